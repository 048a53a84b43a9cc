#include "solver/ball_joint.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "problems/sampling.h"
#include "problems/statistics.h"
#include "solver/batch_smoother.h"

namespace brachium {
namespace {

using Eigen::Vector3d;

constexpr double kUnknownPlace = 0.3;  // sd of joints and sensors [m]
constexpr double kPeriod = 0.1;        // [s]

bool IsOfTheElbow(const Recording& recording) {
  return recording.segment == Segment::kUpperArm || recording.segment == Segment::kForearm;
}

Observations AsBallJoint(Observations observations) {
  observations.start_pose.reset();
  observations.arm.segments.clear();
  observations.arm.elbow.adduction_constraint = false;
  observations.arm.shoulder.sigma = kUnknownPlace;
  std::erase_if(observations.recordings, std::not_fn(IsOfTheElbow));
  for (Recording& recording : observations.recordings) {
    recording.mounting = Mounting{.q_sigma = 0.0, .p_sigma = kUnknownPlace};
    observations.arm.segments[recording.segment] = {.sigma = kUnknownPlace};
  }
  return observations;
}

const Constant& Found(const Estimate& estimate, const std::string& name) {
  return *std::find_if(estimate.diagnostics.constants.begin(), estimate.diagnostics.constants.end(),
                       [&](const Constant& constant) { return constant.name == name; });
}

Vector3d Value(const Constant& constant) { return Vector3d(constant.value.data()); }

// Mean over the directions square to `along`, a unit vector; without the correlations, which are not
// told.
double SdAcross(const Constant& constant, const Vector3d& along) {
  const Eigen::Array3d variance = Eigen::Array3d(constant.sd.data()).square();
  return std::sqrt((variance * (1 - along.array().square())).sum() / 2);
}

double MedianOfKnown(std::vector<double> values) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  return Quantile(values, 0.5);
}

void SetRotations(const Estimate& estimate, BallJoint& joint) {
  std::vector<double> at;
  for (double t = estimate.time.front(); t <= estimate.time.back(); t += kPeriod) at.push_back(t);
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

std::optional<BallJoint> FollowBallJoint(const Observations& observations, std::string* why) {
  const BatchSmoother smoother(SmootherOptions{});
  const Observations free = AsBallJoint(observations);
  if (!smoother.Accepts(free, why)) return std::nullopt;
  const Estimate estimate = smoother.Run(free);
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
  joint.upper_sd = SdAcross(distal, joint.shoulder_to_elbow_A.normalized());
  joint.fore_sd = SdAcross(placed, joint.elbow_to_sensor_B.normalized());
  joint.heading_sd = MedianOfKnown(estimate.sd_angle.at("relative_heading"));
  return joint;
}

}  // namespace brachium
