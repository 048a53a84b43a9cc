#include "problems/simulation/rigid_motion.h"

namespace brachium {

using Eigen::Vector3d;

TurningFrame About(const Vector3d& axis, const Moving& angle) {
  return {Eigen::Quaterniond(Eigen::AngleAxisd(angle.value, axis)), angle.rate * axis,
          angle.acceleration * axis};
}

TurningFrame operator*(const TurningFrame& a_to_b, const TurningFrame& b_to_c) {
  const Eigen::Matrix3d R_CB = b_to_c.q_AB.conjugate().toRotationMatrix();
  const Vector3d omega_AB_C = R_CB * a_to_b.omega_AB_B;
  return {a_to_b.q_AB * b_to_c.q_AB, omega_AB_C + b_to_c.omega_AB_B,
          R_CB * a_to_b.alpha_AB_B + b_to_c.alpha_AB_B - b_to_c.omega_AB_B.cross(omega_AB_C)};
}

MovingPoint PointOf(const Moving& x, const Moving& y, const Moving& z) {
  return {{x.value, y.value, z.value},
          {x.rate, y.rate, z.rate},
          {x.acceleration, y.acceleration, z.acceleration}};
}

MovingPoint operator+(const MovingPoint& a, const MovingPoint& b) {
  return {a.p + b.p, a.v + b.v, a.a + b.a};
}

MovingPoint operator-(const MovingPoint& a, const MovingPoint& b) {
  return {a.p - b.p, a.v - b.v, a.a - b.a};
}

MovingPoint operator*(const Moving& k, const MovingPoint& a) {
  return {k.value * a.p, k.rate * a.p + k.value * a.v,
          k.acceleration * a.p + 2.0 * k.rate * a.v + k.value * a.a};
}

Moving Dot(const MovingPoint& a, const MovingPoint& b) {
  return {a.p.dot(b.p), a.v.dot(b.p) + a.p.dot(b.v),
          a.a.dot(b.p) + 2.0 * a.v.dot(b.v) + a.p.dot(b.a)};
}

MovingPoint Cross(const MovingPoint& a, const MovingPoint& b) {
  return {a.p.cross(b.p), a.v.cross(b.p) + a.p.cross(b.v),
          a.a.cross(b.p) + 2.0 * a.v.cross(b.v) + a.p.cross(b.a)};
}

MovingPoint Unit(const MovingPoint& a) { return Inverse(Sqrt(Dot(a, a))) * a; }

MovingPoint PointOn(const BodyMotion& body, const MovingPoint& r_B) {
  const Eigen::Matrix3d R_WB = body.turning.q_AB.toRotationMatrix();
  const Vector3d& omega = body.turning.omega_AB_B;
  const Vector3d turned = omega.cross(r_B.p);
  return {body.joint_W.p + R_WB * r_B.p, body.joint_W.v + R_WB * (turned + r_B.v),
          body.joint_W.a + R_WB * (body.turning.alpha_AB_B.cross(r_B.p) + omega.cross(turned) +
                                   2.0 * omega.cross(r_B.v) + r_B.a)};
}

}  // namespace brachium
