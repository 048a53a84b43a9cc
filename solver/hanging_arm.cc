#include "solver/hanging_arm.h"

namespace brachium {
namespace {

constexpr double kAboutThePose = 0.25;        // [s]
constexpr double kStillHangs = 45 * kDegree;  // of elevation and of flexion

std::vector<Interval> HangingIntervals(const Observations& observations) {
  std::vector<Interval> hanging;
  for (const Interval& interval : observations.intervals)
    if (interval.label == "calibration:static_pose") hanging.push_back(interval);
  const auto& pose = observations.start_pose;
  if (hanging.empty() && pose && pose->shoulder_elevation.value_or(kStillHangs) < kStillHangs &&
      pose->elbow_flexion.value_or(kStillHangs) < kStillHangs)
    hanging.push_back({"", pose->time - kAboutThePose, pose->time + kAboutThePose});
  return hanging;
}

}  // namespace

std::optional<Eigen::Vector3d> UpOfTheHangingArm(const Recording& recording,
                                                 const Observations& observations) {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  for (const Interval& interval : HangingIntervals(observations))
    for (std::size_t i = 0; i < recording.size(); ++i)
      if (recording.time[i] >= interval.start && recording.time[i] <= interval.end)
        force += recording.acc_S[i];
  if (force.isZero()) return std::nullopt;
  return force.normalized();
}

}  // namespace brachium
