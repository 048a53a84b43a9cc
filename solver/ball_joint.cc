#include "solver/ball_joint.h"

#include <algorithm>
#include <cmath>

#include "problems/sampling.h"
#include "problems/statistics.h"
#include "solver/batch_smoother.h"

namespace brachium {
namespace {

using Eigen::Vector3d;

constexpr double kUnknownPlace = 0.3;  // sd of joints and sensors [m]

Observations AsBallJoint(const Recording& upper_arm, const Recording& forearm, Side side) {
  Observations observations;
  observations.arm.side = side;
  observations.arm.elbow.adduction_constraint = false;
  for (const Recording& recording : {upper_arm, forearm}) {
    observations.recordings.push_back(recording);
    Mounting unknown;
    unknown.p_sigma = kUnknownPlace;
    observations.recordings.back().mounting = unknown;
    observations.arm.segments[recording.segment] = {.p_distal_B = Vector3d::Zero(),
                                                    .sigma = kUnknownPlace};
  }
  return observations;
}

const Constant& Found(const Estimate& estimate, const std::string& name) {
  return *std::find_if(estimate.diagnostics.constants.begin(), estimate.diagnostics.constants.end(),
                       [&](const Constant& constant) { return constant.name == name; });
}

Vector3d Value(const Constant& constant) { return Vector3d(constant.value.data()); }

double LargestSd(const Constant& constant) {
  return *std::max_element(constant.sd.begin(), constant.sd.end());
}

double MedianOfKnown(std::vector<double> values) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  return Quantile(values, 0.5);
}

void SetRotations(const Estimate& estimate, BallJoint& joint) {
  std::vector<double> at;
  for (double t = estimate.time.front(); t <= estimate.time.back(); t += BallJoint::kPeriod)
    at.push_back(t);
  const SampleTimes times(estimate.time);
  const auto q_WA = Interpolate(times, estimate.q_WB.at(Segment::kUpperArm), at);
  const auto q_WB = Interpolate(times, estimate.q_WB.at(Segment::kForearm), at);
  for (std::size_t i = 0; i < at.size(); ++i) {
    const Eigen::Quaterniond q_AB = q_WA[i].conjugate() * q_WB[i];
    if (!q_AB.coeffs().allFinite()) continue;
    joint.time.push_back(at[i]);
    joint.R_AB.push_back(q_AB.toRotationMatrix());
  }
}

}  // namespace

std::optional<BallJoint> FollowBallJoint(const Recording& upper_arm, const Recording& forearm,
                                         Side side, std::string* why) {
  const BatchSmoother smoother(SmootherOptions{});
  const Observations observations = AsBallJoint(upper_arm, forearm, side);
  if (!smoother.Accepts(observations, why)) return std::nullopt;
  const Estimate estimate = smoother.Run(observations);
  if (!estimate.diagnostics.converged || estimate.diagnostics.singular) {
    *why = "the two sensors cannot be followed as bodies on one joint: " +
           estimate.diagnostics.termination;
    return std::nullopt;
  }
  BallJoint joint;
  SetRotations(estimate, joint);
  const Constant& distal = Found(estimate, "upper_arm.distal_joint_m");
  const Constant& placed = Found(estimate, "forearm.p_BS_m");
  joint.shoulder_to_elbow_A = Value(distal);
  joint.elbow_to_sensor_A = Value(Found(estimate, "upper_arm.p_BS_m")) - Value(distal);
  joint.elbow_to_sensor_B = Value(placed);
  joint.upper_sd = LargestSd(distal);
  joint.fore_sd = LargestSd(placed);
  joint.heading_sd = MedianOfKnown(estimate.sd_angle.at("relative_heading"));
  return joint;
}

}  // namespace brachium
