#include "io/elbow_check.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "io/elbow_sensors.h"
#include "io/text.h"

namespace brachium {
namespace {

constexpr double kLeastMotion = 0.04;  // rms of the force's length about its mean [m/s^2]
constexpr double kWellAgreed = 0.25;   // of that rms: nothing can be much better
constexpr double kMuchBetter = 0.72;   // of the told disagreement; sound trials: 0.85 and more
constexpr double kLongestLag = 3.0;    // [s]
constexpr double kShortestLag = 0.05;  // [s]

using Series = std::vector<double>;

// The length of the specific force at the elbow about its mean, which a bias would move.
Series ForceAt(const Eigen::Vector3d& r_S, const ElbowSensor& sensor, double sign) {
  Series lengths;
  for (std::size_t k = 0; k < sensor.gyr_S.size(); ++k)
    lengths.push_back((sign * sensor.acc_S[k] + sensor.Lever(k) * r_S).norm());
  const double mean =
      std::reduce(lengths.begin(), lengths.end()) / static_cast<double>(std::ssize(lengths));
  for (double& length : lengths) length -= mean;
  return lengths;
}

double Rms(const Series& a) {
  double squares = 0.0;
  for (const double value : a) squares += value * value;
  return std::sqrt(squares / static_cast<double>(a.size()));
}

// Rms of a(t) - b(t + lag steps), over where both are.
double Disagreement(const Series& a, const Series& b, std::ptrdiff_t lag = 0) {
  const auto size = std::ssize(a);
  double squares = 0.0, count = 0.0;
  for (auto i = std::max<std::ptrdiff_t>(0, -lag); i < size - std::max<std::ptrdiff_t>(0, lag);
       ++i, count += 1.0) {
    const double difference = a[static_cast<std::size_t>(i)] - b[static_cast<std::size_t>(i + lag)];
    squares += difference * difference;
  }
  return std::sqrt(squares / std::max(count, 1.0));
}

struct Suspect {
  double disagreement = 0.0;
  std::string text;
};

std::string Shift(std::ptrdiff_t lag) {
  return Fixed(kElbowStep * static_cast<double>(std::abs(lag)), 2) + " s";
}

// What else the trial could be, and how well each agrees.
std::vector<Suspect> Suspects(const ElbowSensor& upper, const ElbowSensor& fore) {
  const Eigen::Vector3d &r_U = upper.elbow_S, &r_F = fore.elbow_S;
  const Series told_U = ForceAt(r_U, upper, 1.0), told_F = ForceAt(r_F, fore, 1.0);
  const Series turned_U = ForceAt(r_U, upper, -1.0), turned_F = ForceAt(r_F, fore, -1.0);
  std::vector<Suspect> suspects = {
      {Disagreement(ForceAt(r_U, fore, 1.0), ForceAt(r_F, upper, 1.0)),
       "the recordings of upper arm and forearm look exchanged; check which sensor was worn where "
       "[sensors_swapped]"},
      {Disagreement(turned_U, told_F),
       "acc of the upper arm looks turned round; expected specific force, +9.81 upward at rest: "
       "multiply it by -1 [gravity_sign]"},
      {Disagreement(told_U, turned_F),
       "acc of the forearm looks turned round; expected specific force, +9.81 upward at rest: "
       "multiply it by -1 [gravity_sign]"},
      {Disagreement(turned_U, turned_F),
       "acc of both sensors looks turned round; expected specific force, +9.81 upward at rest: "
       "multiply it by -1 [gravity_sign]"}};
  Suspect lagging{HUGE_VAL, ""};
  const auto most = static_cast<std::ptrdiff_t>(kLongestLag / kElbowStep);
  const auto least = static_cast<std::ptrdiff_t>(kShortestLag / kElbowStep);
  for (auto lag = -most; lag <= most; ++lag) {
    const double disagreement = Disagreement(told_U, told_F, lag);
    if (std::abs(lag) < least || disagreement >= lagging.disagreement) continue;
    lagging = {disagreement, "the clock of the forearm looks " + Shift(lag) +
                                 (lag > 0 ? " late" : " early") +
                                 "; expected one clock: shift its time_s by that [clock]"};
  }
  suspects.push_back(lagging);
  return suspects;
}

}  // namespace

bool CheckElbow(const Observations& observations, Findings* findings) {
  const auto sensors = FindElbowSensors(observations, 4.0 * kLongestLag, 120.0);
  if (!sensors) return false;
  const Series force_U = ForceAt(sensors->upper.elbow_S, sensors->upper, 1.0);
  const Series force_F = ForceAt(sensors->fore.elbow_S, sensors->fore, 1.0);
  const double motion = std::max(Rms(force_U), Rms(force_F));
  const double told = Disagreement(force_U, force_F);
  if (motion < kLeastMotion || told < kWellAgreed * motion) return false;
  const std::vector<Suspect> suspects = Suspects(sensors->upper, sensors->fore);
  const Suspect& best = *std::ranges::min_element(suspects, {}, &Suspect::disagreement);
  if (best.disagreement > kMuchBetter * told) return false;
  findings->warnings.push_back("the two sensors disagree about the elbow's acceleration by " +
                               Fixed(told, 2) + " m/s^2 rms, by " + Fixed(best.disagreement, 2) +
                               " otherwise: " + best.text);
  return true;
}

}  // namespace brachium
