#include "io/slip_check.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "io/slips.h"
#include "io/text.h"

namespace brachium {
namespace {

constexpr double kLongest = 1200.0;          // [s]
constexpr double kLeastChange = 0.015;       // of the elbow in the sensor's axes [m]
constexpr double kLeastTurn = 12 * kDegree;  // of the sensor; skin does as much
constexpr double kNear = 3.0;                // from a slip by the hinge to one by force [s]
// How much likelier a slip makes the trial, -log(1 - share), beside what chance and soft tissue make
// of it: that falls with the length of a trial, down to what does not average out; a window of the
// hinge is lost to its heading. A score of one, of both together, is a slip; the largest of 3000 sound
// trials of 20 to 125 s is 0.88.
constexpr double kAverages = 75.0;   // [s]
constexpr double kByForce = 20.0;    // [s]
constexpr double kByHinge = 24.0;    // [s]
constexpr double kOneWindow = 12.0;  // [s]

double Likelier(double share) { return -std::log1p(-share); }

double ForceScore(const SlipEvidence& slip, double length) {
  return slip.change < kLeastChange ? 0.0
                                    : Likelier(slip.share) * std::min(length, kAverages) / kByForce;
}

double HingeScore(const SlipEvidence& slip, double length) {
  return slip.change < kLeastTurn
             ? 0.0
             : Likelier(slip.share) * (std::min(length, kAverages) - kOneWindow) / kByHinge;
}

struct Slip {
  double score = 0.0;
  double time = 0.0;  // [s]
  std::string text;
};

Slip LikeliestSlip(const std::vector<SlipEvidence>& by_force,
                   const std::vector<SlipEvidence>& by_hinge, double length) {
  Slip best;
  for (const SlipEvidence& force : by_force) {
    const double alone = ForceScore(force, length);
    double hinge_score = 0.0;
    const SlipEvidence* turned = nullptr;
    for (const SlipEvidence& hinge : by_hinge) {
      if (std::abs(hinge.time - force.time) > 0.5 * kNear) continue;
      const double score = HingeScore(hinge, length);
      if (score > hinge_score) hinge_score = score, turned = &hinge;
    }
    if (alone + hinge_score <= best.score) continue;
    best = {alone + hinge_score, force.time, ""};
    best.text = alone > hinge_score
                    ? force.sensor + " (" + Fixed(100.0 * force.change, 0) + " cm)"
                    : turned->sensor + " (" + Fixed(turned->change / kDegree, 0) + " deg)";
  }
  return best;
}

}  // namespace

void CheckSlip(const Observations& observations, Findings* findings) {
  const auto sensors = FindElbowSensors(observations, 2.0 * kLeastPart + 1.0, kLongest);
  if (!sensors) return;
  const double length = kElbowStep * static_cast<double>(sensors->size());
  const Slip slip =
      LikeliestSlip(SlipsByForce(*sensors), SlipsByHinge(*sensors, observations.arm), length);
  if (slip.score < 1.0) return;
  findings->warnings.push_back("from about " + Fixed(slip.time, 0) +
                               " s on a sensor sits otherwise: " + slip.text +
                               ", seen from the elbow; if it slipped, make two trials of this one "
                               "[slip]");
}

}  // namespace brachium
