#include "solver/elbow_zeros.h"

#include <algorithm>
#include <cmath>

#include "problems/statistics.h"
#include "solver/calibration_movement.h"

namespace brachium {
namespace {

using Eigen::AngleAxisd, Eigen::Matrix3d, Eigen::Quaterniond, Eigen::Vector3d;

constexpr double kStretched = -5 * kDegree;  // the least flexion of a usual elbow
constexpr double kStretchedShare = 0.01;     // of the time, beyond that
constexpr double kHangs = 35 * kDegree;
constexpr double kAssumedPoseSigma = 30 * kDegree;
constexpr double kStart = 0.5;  // [s]

Matrix3d FromYZ(const Vector3d& Y, const Vector3d& Z) {
  Matrix3d R;
  R << Y.cross(Z), Y, Z;
  return R;
}

Vector3d UpAtTheStart(const Recording& recording, double until) {
  Vector3d force = Vector3d::Zero();
  for (std::size_t i = 0; i < recording.size() && recording.time[i] <= until; ++i)
    force += recording.acc_S[i];
  return force.normalized();
}

bool Hangs(const Observations& observations, const BallJoint& joint, const ElbowFrames& frames) {
  const double until = joint.time.front() + kStart;
  for (const Recording& recording : observations.recordings) {
    const bool upper = recording.segment == Segment::kUpperArm;
    if (!upper && recording.segment != Segment::kForearm) continue;
    const Vector3d Y_S = (upper ? frames.R_AU : frames.R_BF).col(1);
    if (AngleBetween(UpAtTheStart(recording, until), Y_S) > kHangs) return false;
  }
  return true;
}

const Matrix3d& At(const BallJoint& joint, double time) {
  const auto after = std::lower_bound(joint.time.begin(), joint.time.end(), time);
  const auto last = static_cast<std::ptrdiff_t>(joint.time.size()) - 1;
  return joint.R_AB[static_cast<std::size_t>(std::min(after - joint.time.begin(), last))];
}

double LeastFlexion(const BallJoint& joint, const ElbowFrames& frames, Side side) {
  std::vector<double> flexion;
  for (const Matrix3d& R_AB : joint.R_AB) flexion.push_back(frames.AnglesAt(R_AB, side).flexion);
  return Quantile(flexion, kStretchedShare);
}

// Adds to every flexion.
void Flex(double by, ElbowFrames& frames) {
  frames.R_AU *= AngleAxisd(-by, Vector3d::UnitZ()).toRotationMatrix();
}

}  // namespace

ElbowAngles ElbowFrames::AnglesAt(const Matrix3d& R_AB, Side side) const {
  return ElbowAnglesFrom(Quaterniond(Matrix3d(R_AU.transpose() * R_AB * R_BF)), side);
}

ElbowFrames FramesFrom(const Vector3d& j1_A, const Vector3d& j2_B, const Vector3d& to_shoulder_A) {
  const Vector3d Y_U = (to_shoulder_A - to_shoulder_A.dot(j1_A) * j1_A).normalized();
  return {.R_AU = FromYZ(Y_U, j1_A), .R_BF = FromYZ(j2_B, j2_B.unitOrthogonal())};
}

std::optional<HeldPose> PoseForZeros(const Observations& observations, const BallJoint& joint,
                                     const ElbowFrames& frames) {
  if (observations.start_pose && observations.start_pose->forearm_pronation)
    return observations.start_pose;
  if (!Hangs(observations, joint, frames)) return std::nullopt;
  return HeldPose{.time = joint.time.front() + kStart / 2,
                  .elbow_flexion = 10 * kDegree,
                  .forearm_pronation = 90 * kDegree,
                  .shoulder_elevation = {},
                  .sigma = kAssumedPoseSigma};
}

ElbowZeros SetZeros(const BallJoint& joint, ElbowFrames frames, double line_sd,
                    const HeldPose& pose, Side side) {
  const ElbowAngles then = frames.AnglesAt(At(joint, pose.time), side);
  const double weight_of_line = 1 / (line_sd * line_sd);
  const double weight_of_pose = pose.elbow_flexion ? 1 / (pose.sigma * pose.sigma) : 0.0;
  const double weights = weight_of_line + weight_of_pose;
  Flex((pose.elbow_flexion.value_or(then.flexion) - then.flexion) * weight_of_pose / weights,
       frames);
  const double turn = Sign(side) * (*pose.forearm_pronation - then.pronation);
  frames.R_BF *= AngleAxisd(turn, Vector3d::UnitY()).toRotationMatrix();
  const double moved = std::max(0.0, kStretched - LeastFlexion(joint, frames, side));
  Flex(moved, frames);
  return {.frames = frames,
          .flexion_sd = std::max(1 / std::sqrt(weights), moved),
          .pronation_sd = pose.sigma,
          .moved = moved};
}

}  // namespace brachium
