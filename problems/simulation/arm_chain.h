// The simulated arm as a chain of joints: what moves, how long it is, and where all of it is.
//
// A trunk T leans about the hips; its axes are X forward, Y up, Z right while it is upright. The arm
// hangs from the shoulder (right arm):
//   R_TU = Rz(shoulder flexion) Rx(-abduction) Ry(internal rotation),
//   R_UF = Rz(elbow flexion) Rx(-k) Ry(pronation),    k = k0 + k1 cos(elbow flexion) + e,
//   R_FH = Rz(wrist flexion) Rx(wrist deviation).
// The girdle turns so that it points from C7 to wherever the shoulder moves; what its length does
// not allow, C7 gives.
#pragma once

#include <Eigen/Core>
#include <array>
#include <map>

#include "problems/arm_model.h"
#include "problems/simulation/rigid_motion.h"

namespace brachium {

// What moves; angles [rad], shoulder position in trunk axes, from its mean place [m].
enum Joint {
  kShoulderFlexion,
  kShoulderAbduction,
  kShoulderRotation,
  kElbowFlexion,
  kForearmPronation,
  kElbowAdduction,  // e
  kShoulderForward,
  kShoulderUp,
  kShoulderRight,
  kWristFlexion,
  kWristDeviation,
  kTrunkLean,  // forward
  kTrunkBend,  // to the right
  kJointCount
};
using JointValues = std::array<double, kJointCount>;
using MovingJoints = std::array<Moving, kJointCount>;

// Arm hanging, elbow 10 deg flexed, thumb forward.
JointValues StartPoseJoints();

// True lengths and elbow of a right arm. Lengths: an adult of 1.75 m (Winter).
struct ArmShape {
  double upper_arm = 0.31;              // [m]
  double forearm = 0.26;                // [m]
  double hand = 0.19;                   // wrist to fingertip [m]
  double carrying_angle = 8 * kDegree;  // k0, valgus positive [rad]
  double carrying_slope = 3 * kDegree;  // k1: more valgus when straight [rad]

  // The distal joint of a segment, in its axes [m]: (0, -length, 0), the girdle's aside.
  Eigen::Vector3d DistalJoint(Segment segment) const;
};

// Where the arm is at one instant. World: z up; see BodyMotion. A segment's joint is its proximal
// one: C7 for the girdle.
struct ArmMotion {
  BodyMotion upper_arm, forearm, girdle, hand;
  MovingPoint wrist_W;
  MovingPoint fingertip_W;

  const BodyMotion& operator[](Segment segment) const;
};

// The right arm on a trunk that would stand upright with these axes and the shoulder's mean place in
// the origin. With trunk axes of identity, places are in the upright trunk's axes.
ArmMotion ArmOf(const MovingJoints& joints, const ArmShape& shape, const TurningFrame& upright);

// The same at one instant, still.
ArmMotion ArmOf(const JointValues& joints, const ArmShape& shape);

}  // namespace brachium
