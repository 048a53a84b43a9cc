#include "problems/simulation/arm_chain.h"

namespace brachium {
namespace {

using Eigen::Vector3d;

const Vector3d kX = Vector3d::UnitX(), kY = Vector3d::UnitY(), kZ = Vector3d::UnitZ();

// From the hips to the shoulders' height [m]: 0.29 of a stature of 1.75 m (Winter).
constexpr double kTrunk = 0.5;

// The trunk leaning about the hips; its joint is where the shoulder's mean place has gone.
BodyMotion Leaning(const MovingJoints& q, const TurningFrame& upright) {
  BodyMotion trunk;
  trunk.turning = upright * About(kZ, -q[kTrunkLean]) * About(kX, q[kTrunkBend]);
  const MovingPoint height{.p = kTrunk * kY};
  trunk.joint_W = PointOn({trunk.turning, {}}, height) - PointOn({upright, {}}, height);
  return trunk;
}

// From the directions in which it points now and with the shoulder in its mean place, as turns
// about Y and X.
BodyMotion Girdle(const BodyMotion& trunk, const MovingPoint& shoulder_T, const Vector3d& d_G) {
  const auto pointing = [](const MovingPoint& n, Moving* about_y, Moving* about_x) {
    const Moving x = Dot(n, {.p = kX}), y = Dot(n, {.p = kY}), z = Dot(n, {.p = kZ});
    *about_y = Atan2(x, z);
    *about_x = -Asin(y);
  };
  Moving y, x, y0, x0;
  pointing(Unit(shoulder_T + MovingPoint{.p = d_G}), &y, &x);
  pointing(Unit({.p = d_G}), &y0, &x0);
  const TurningFrame turn = About(kY, y) * About(kX, x) * About(kX, -x0) * About(kY, -y0);
  BodyMotion girdle{.turning = trunk.turning * turn, .joint_W = {}};
  girdle.joint_W = PointOn(trunk, shoulder_T) - PointOn(girdle, {.p = d_G});
  return girdle;
}

}  // namespace

JointValues StartPoseJoints() {
  JointValues pose{};
  pose[kShoulderAbduction] = 8 * kDegree;
  pose[kElbowFlexion] = 10 * kDegree;
  pose[kForearmPronation] = 90 * kDegree;
  return pose;
}

Vector3d ArmShape::DistalJoint(Segment segment) const {
  if (segment == Segment::kUpperArm) return {0.0, -upper_arm, 0.0};
  if (segment == Segment::kForearm) return {0.0, -forearm, 0.0};
  if (segment == Segment::kHand) return {0.0, -hand, 0.0};
  return DefaultGeometry(Segment::kGirdle, Side::kRight).p_distal_B;
}

const BodyMotion& ArmMotion::operator[](Segment segment) const {
  if (segment == Segment::kGirdle) return girdle;
  if (segment == Segment::kUpperArm) return upper_arm;
  return segment == Segment::kForearm ? forearm : hand;
}

ArmMotion ArmOf(const MovingJoints& q, const ArmShape& shape, const TurningFrame& upright) {
  const BodyMotion trunk = Leaning(q, upright);
  const MovingPoint shoulder_T = PointOf(q[kShoulderForward], q[kShoulderUp], q[kShoulderRight]);
  ArmMotion arm;
  arm.girdle = Girdle(trunk, shoulder_T, shape.DistalJoint(Segment::kGirdle));
  arm.upper_arm.turning = trunk.turning * About(kZ, q[kShoulderFlexion]) *
                          About(kX, -q[kShoulderAbduction]) * About(kY, q[kShoulderRotation]);
  arm.upper_arm.joint_W = PointOn(trunk, shoulder_T);
  const Moving carrying = Moving{shape.carrying_angle, 0.0, 0.0} +
                          shape.carrying_slope * Cos(q[kElbowFlexion]) + q[kElbowAdduction];
  arm.forearm.turning = arm.upper_arm.turning * About(kZ, q[kElbowFlexion]) * About(kX, -carrying) *
                        About(kY, q[kForearmPronation]);
  arm.forearm.joint_W = PointOn(arm.upper_arm, {.p = shape.DistalJoint(Segment::kUpperArm)});
  arm.wrist_W = PointOn(arm.forearm, {.p = shape.DistalJoint(Segment::kForearm)});
  arm.hand.turning =
      arm.forearm.turning * About(kZ, q[kWristFlexion]) * About(kX, q[kWristDeviation]);
  arm.hand.joint_W = arm.wrist_W;
  arm.fingertip_W = PointOn(arm.hand, {.p = shape.DistalJoint(Segment::kHand)});
  return arm;
}

ArmMotion ArmOf(const JointValues& joints, const ArmShape& shape) {
  MovingJoints still;
  for (std::size_t i = 0; i < still.size(); ++i) still[i].value = joints[i];
  return ArmOf(still, shape, {});
}

}  // namespace brachium
