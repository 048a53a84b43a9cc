// What no movement of the elbow shows: the zeros of flexion and of pronation.
//
// Turning the upper arm's sensor about the flexion axis Z_U, or the forearm's about the pronation axis
// Y_F, adds a constant to the angle and changes nothing else. Both zeros are therefore a prior's:
//   flexion    the line from elbow to shoulder, made square to Z_U, is Y_U; the start pose tells its
//              flexion too; the two are weighted. Where the elbow would then overstretch, beyond
//              -5 deg in 1 % of the time, the zero moves until it does not, and its sd is as large as
//              that at least.
//   pronation  the start pose alone.
// Where no pose is told and the arm hangs when the recordings begin, the thumb is taken to point
// forward, 30 deg.
#pragma once

#include <optional>
#include <vector>

#include "problems/joint_angles.h"
#include "problems/observations.h"
#include "solver/ball_joint.h"

namespace brachium {

// The segments' axes in the axes of their sensors.
struct ElbowFrames {
  Eigen::Matrix3d R_AU, R_BF;

  ElbowAngles AnglesAt(const Eigen::Matrix3d& R_AB, Side side) const;
};

// Z_U = j1, Y_F = j2, Y_U towards the shoulder; the rotation about Y_F is any.
ElbowFrames FramesFrom(const Eigen::Vector3d& j1_A, const Eigen::Vector3d& j2_B,
                       const Eigen::Vector3d& to_shoulder_A);

struct ElbowZeros {
  ElbowFrames frames;
  double flexion_sd = 0.0;    // [rad]
  double pronation_sd = 0.0;  // [rad]
  double moved = 0.0;         // of the zero of flexion, against overstretching [rad]
};

// The told start pose, where it has a pronation; else that of a hanging arm, where the recordings begin
// with one.
std::optional<HeldPose> PoseForZeros(const Observations& observations, const BallJoint& joint,
                                     const ElbowFrames& frames);

// `line_sd` is that of the line from elbow to shoulder [rad].
ElbowZeros SetZeros(const BallJoint& joint, ElbowFrames frames, double line_sd,
                    const HeldPose& pose, Side side);

}  // namespace brachium
