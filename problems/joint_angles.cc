#include "problems/joint_angles.h"

#include <cmath>

namespace brachium {
namespace {

using Eigen::AngleAxisd, Eigen::Matrix3d, Eigen::Quaterniond, Eigen::Vector3d;

constexpr double kLockedCosine = 1e-8;

// R = Rz(a) Rx(b) Ry(c).
struct ZxyAngles {
  double a, b, c;
};

ZxyAngles ZxyAnglesFrom(const Quaterniond& q) {
  const Matrix3d R = q.toRotationMatrix();
  const double cosine = std::hypot(R(0, 1), R(1, 1));
  const double b = std::atan2(R(2, 1), cosine);
  if (cosine < kLockedCosine) return {std::atan2(R(1, 0), R(0, 0)), b, 0.0};
  return {std::atan2(-R(0, 1), R(1, 1)), b, std::atan2(-R(2, 0), R(2, 2))};
}

Quaterniond AsRightArm(const Quaterniond& q_AB, Side side) {
  return side == Side::kRight ? q_AB : Mirrored(q_AB);
}

}  // namespace

Quaterniond Mirrored(const Quaterniond& q_AB) {
  return Quaterniond(q_AB.w(), -q_AB.x(), -q_AB.y(), q_AB.z());
}

ElbowAngles ElbowAnglesFrom(const Quaterniond& q_UF, Side side) {
  const auto [a, b, c] = ZxyAnglesFrom(AsRightArm(q_UF, side));
  return {.flexion = a, .carrying = -b, .pronation = c};
}

Quaterniond ElbowRotation(const ElbowAngles& angles, Side side) {
  const Quaterniond q_UF = AngleAxisd(angles.flexion, Vector3d::UnitZ()) *
                           AngleAxisd(-angles.carrying, Vector3d::UnitX()) *
                           AngleAxisd(angles.pronation, Vector3d::UnitY());
  return AsRightArm(q_UF, side);
}

ShoulderAngles ShoulderAnglesFrom(const Quaterniond& q_TU, Side side) {
  const Matrix3d R = AsRightArm(q_TU, side).toRotationMatrix();
  const double sine = std::hypot(R(0, 1), R(2, 1));
  ShoulderAngles angles{.plane = {}, .elevation = std::atan2(sine, R(1, 1)), .rotation = {}};
  if (sine < kShoulderPoleSine) return angles;
  angles.plane = std::atan2(-R(0, 1), -R(2, 1));
  angles.rotation = std::atan2(-R(1, 0), R(1, 2));
  return angles;
}

double ShoulderElevation(const Quaterniond& q_WU) {
  const Vector3d y_W = q_WU * Vector3d::UnitY();
  return std::atan2(std::hypot(y_W.x(), y_W.y()), y_W.z());
}

WristAngles WristAnglesFrom(const Quaterniond& q_FH, Side side) {
  const auto [a, b, c] = ZxyAnglesFrom(AsRightArm(q_FH, side));
  return {.flexion = a, .deviation = b, .rotation = c};
}

}  // namespace brachium
