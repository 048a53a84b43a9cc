#include "solver/baselines/static_alignment.h"

#include <cmath>

#include "problems/joint_angles.h"
#include "problems/rotation.h"

namespace brachium {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;

constexpr double kThumbsForward = 90 * kDegree;

Quaterniond Trunk(double facing) {
  Eigen::Matrix3d R_WT;
  R_WT.col(0) = Vector3d(std::cos(facing), std::sin(facing), 0.0);
  R_WT.col(1) = Vector3d::UnitZ();
  R_WT.col(2) = R_WT.col(0).cross(R_WT.col(1));
  return Quaterniond(R_WT);
}

std::vector<Quaterniond> DuringStaticPose(const Recording& recording,
                                          const std::vector<Interval>& intervals) {
  std::vector<Quaterniond> q_WS;
  if (recording.q_WS.empty()) return q_WS;
  for (const Interval& interval : intervals)
    for (std::size_t i = 0; i < recording.size(); ++i)
      if (interval.label == "calibration:static_pose" && recording.time[i] >= interval.start &&
          recording.time[i] <= interval.end)
        q_WS.push_back(recording.q_WS[i]);
  return q_WS;
}

}  // namespace

Quaterniond StaticPose(Segment segment, const Observations& observations, double facing) {
  if (segment != Segment::kForearm && segment != Segment::kHand) return Trunk(facing);
  ElbowAngles elbow{.pronation = kThumbsForward};
  if (observations.start_pose && observations.start_pose->forearm_pronation)
    elbow.pronation = *observations.start_pose->forearm_pronation;
  return Trunk(facing) * ElbowRotation(elbow, observations.arm.side);
}

Observations AlignedByStaticPose(const Observations& observations, double facing) {
  Observations aligned = observations;
  for (Recording& recording : aligned.recordings) {
    if (recording.mounting) continue;
    const auto q_WS = DuringStaticPose(recording, observations.intervals);
    if (q_WS.empty()) continue;
    const Quaterniond expected = StaticPose(recording.segment, observations, facing);
    recording.mounting = Mounting{.q_BS = expected.conjugate() * MeanRotation(q_WS)};
  }
  return aligned;
}

}  // namespace brachium
