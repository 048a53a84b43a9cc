#include "problems/simulation/inverse_kinematics.h"

#include <cmath>
#include <stdexcept>

namespace brachium {
namespace {

using Eigen::Vector3d;

Moving Constant(double value) { return {value, 0.0, 0.0}; }

Moving Carrying(const Moving& flexion, const Moving& adduction, const ArmShape& shape) {
  return Constant(shape.carrying_angle) + shape.carrying_slope * Cos(flexion) + adduction;
}

// The flexion at which shoulder and wrist are as far apart as given:
//   cos(f) cos(k(f)) = (d^2 - L_U^2 - L_F^2) / (2 L_U L_F) = c,
// by Newton's method on values and derivatives at once; each step doubles the digits of both.
Moving ElbowFlexion(const Moving& distance_squared, const Moving& adduction,
                    const ArmShape& shape) {
  const double u = shape.upper_arm, f = shape.forearm;
  constexpr double kFarthest = 0.99;  // of c: an elbow flexed by 8 deg, or as far from closed
  const Moving c = (0.5 / (u * f)) * (distance_squared + Constant(-u * u - f * f));
  if (!(std::abs(c.value) < kFarthest))
    throw std::domain_error("the wrist is out of the arm's reach");
  Moving flexion = Constant(std::acos(c.value));
  for (int i = 0; i < 12; ++i) {
    const Moving k = Carrying(flexion, adduction, shape);
    const Moving slope =
        -(Sin(flexion) * Cos(k)) + shape.carrying_slope * (Cos(flexion) * (Sin(k) * Sin(flexion)));
    flexion = flexion + -((Cos(flexion) * Cos(k) + -c) * Inverse(slope));
  }
  return flexion;
}

// Orthonormal axes: along `along`, and perpendicular to it on the side of `aside`.
std::array<MovingPoint, 3> Axes(const MovingPoint& along, const MovingPoint& aside) {
  const MovingPoint first = Unit(along);
  const MovingPoint across = aside - Dot(aside, first) * first;
  if (!(across.p.norm() > 1e-3 * aside.p.norm()))
    throw std::domain_error("the elbow's direction is that of the wrist");
  const MovingPoint second = Unit(across);
  return {first, second, Cross(first, second)};
}

double Value(const Moving& m) { return m.value; }

}  // namespace

// With orthonormal axes A through wrist and elbow, R_TU = A_T A_U^T; its angles are read off
//   R_TU = Rz(F) Rx(-A) Ry(R):  R e_y = (-sin F cos A, cos F cos A, -sin A),
//   e_z^T R = (-cos A sin R, -sin A, cos A cos R).
void BringWristTo(const MovingPoint& wrist_T, const MovingPoint& elbow_T, const ArmShape& shape,
                  MovingJoints& joints) {
  const Moving flexion = ElbowFlexion(Dot(wrist_T, wrist_T), joints[kElbowAdduction], shape);
  const Moving k = Carrying(flexion, joints[kElbowAdduction], shape);
  const MovingPoint wrist_U =
      PointOf(shape.forearm * (Sin(flexion) * Cos(k)),
              Constant(-shape.upper_arm) + -(shape.forearm * (Cos(flexion) * Cos(k))),
              shape.forearm * Sin(k));
  const auto axes_T = Axes(wrist_T, elbow_T);
  const auto axes_U = Axes(wrist_U, {.p = -Vector3d::UnitY()});
  const auto element = [&](int row, int column) {
    Moving sum;
    for (std::size_t i = 0; i < 3; ++i)
      sum = sum + Dot(axes_T[i], {.p = Vector3d::Unit(row)}) *
                      Dot(axes_U[i], {.p = Vector3d::Unit(column)});
    return sum;
  };
  joints[kShoulderFlexion] = Atan2(-element(0, 1), element(1, 1));
  joints[kShoulderAbduction] = -Asin(element(2, 1));
  joints[kShoulderRotation] = Atan2(-element(2, 0), element(2, 2));
  joints[kElbowFlexion] = flexion;
}

// The wrist goes where the hand, as it is held at the last guess, leaves it; this converges because
// the hand is shorter than the way to it.
void BringHandTo(const HandPlace& place, const ArmShape& shape, JointValues& joints) {
  constexpr int kMost = 500;
  constexpr double kClose = 1e-14;  // [m]
  const auto bring_wrist = [&](const Vector3d& wrist_T) {
    const ArmMotion arm = ArmOf(joints, shape);
    // Into the axes of a trunk that leans: those of an upper arm with shoulder angles of zero.
    JointValues trunk = joints;
    trunk[kShoulderFlexion] = trunk[kShoulderAbduction] = trunk[kShoulderRotation] = 0.0;
    const Eigen::Quaterniond q_to_lean = ArmOf(trunk, shape).upper_arm.turning.q_AB.conjugate();
    MovingJoints moving;
    moving[kElbowAdduction].value = joints[kElbowAdduction];
    BringWristTo({.p = q_to_lean * (wrist_T - arm.upper_arm.joint_W.p)},
                 {.p = q_to_lean * place.elbow_T}, shape, moving);
    for (const Joint joint :
         {kShoulderFlexion, kShoulderAbduction, kShoulderRotation, kElbowFlexion})
      joints[joint] = Value(moving[joint]);
  };
  Vector3d wrist_T = place.p_T;
  if (place.part == HandPlace::Part::kFingertip) wrist_T -= Vector3d(0.12, 0.0, 0.0);
  bring_wrist(wrist_T);
  for (int i = 0; i < kMost && place.part == HandPlace::Part::kFingertip; ++i) {
    const ArmMotion arm = ArmOf(joints, shape);
    if ((arm.fingertip_W.p - place.p_T).norm() < kClose) return;
    bring_wrist(arm.wrist_W.p + place.p_T - arm.fingertip_W.p);
  }
}

}  // namespace brachium
