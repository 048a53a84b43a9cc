#include "solver/calibrate_clusters.h"

#include <algorithm>
#include <cmath>

#include "problems/rotation.h"
#include "problems/sampling.h"

namespace brachium {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;

constexpr double kSpan = 0.1;  // of a rate [s]

double MedianStep(const std::vector<double>& time) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < time.size(); ++i) steps.push_back(time[i] - time[i - 1]);
  std::nth_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2),
                   steps.end());
  return steps[steps.size() / 2];
}

}  // namespace

std::optional<Recording> ClusterRecording(const Reference& reference, Segment segment) {
  const std::vector<double>& time = reference.time;
  if (time.size() < 3) return std::nullopt;
  const auto& q_VC = reference.q_VB.at(segment);
  const double step = MedianStep(time), offset = reference.clock_offset.value_or(0.0);
  const auto half = static_cast<std::size_t>(std::max(1.0, std::round(kSpan / 2 / step)));
  const double longest = (2.0 * static_cast<double>(half) + kGapFactor - 1.0) * step;
  Recording recording;
  recording.segment = segment;
  for (std::size_t i = half; i + half < time.size(); ++i) {
    const double span = time[i + half] - time[i - half];
    const Vector3d turn = Log<double>(q_VC[i - half].conjugate() * q_VC[i + half]);
    const Vector3d up_C = q_VC[i].conjugate() * Vector3d::UnitZ();
    if (!turn.allFinite() || !up_C.allFinite() || span > longest) continue;
    recording.time.push_back(time[i] - offset);
    recording.gyr_S.push_back(turn / span);
    recording.acc_S.push_back(kGravity * up_C);
  }
  if (recording.size() < 2) return std::nullopt;
  return recording;
}

Calibration CalibrateClusters(const Reference& reference, const Observations& observations,
                              const CalibrationOptions& options) {
  Observations clusters = observations;
  clusters.recordings.clear();
  std::vector<std::string> without;
  for (const auto& [segment, q_VC] : reference.q_VB) {
    const auto recording = ClusterRecording(reference, segment);
    if (recording && HasLabelledMovements(observations, segment))
      clusters.recordings.push_back(*recording);
    else
      without.push_back(std::string(Name(segment)) + ": no movement is labelled for its cluster");
  }
  Calibration result = Calibrate(clusters, options);
  result.notes.insert(result.notes.end(), without.begin(), without.end());
  return result;
}

}  // namespace brachium
