// Flexion and pronation from the attitudes of the two segments, with derivatives; shared by the
// residuals that speak of them.
//
//   R_UF = Rz(a) Rx(b) Ry(c):   a = atan2(-R_01, R_11),   c = atan2(-R_20, R_22)
//   flexion = a, pronation = s c  (s = +1 right, -1 left)
//
// Jacobian  the rate of F in U is ȧ z_U + ḃ x' + ċ y_F; with ω = φ_F - R_FU φ_U in F axes,
//           ȧ = (p · ω)/(p · z),  p = y × x' the common normal of the other two axes, likewise ċ.
// Degenerate where |b| nears 90 deg: no elbow goes there.
#pragma once

#include <cmath>

#include "problems/rotation.h"
#include "problems/segment.h"

namespace brachium {

template <typename T>
struct FlexionPronation {
  T flexion, pronation;
};

template <typename T>
FlexionPronation<T> ElbowFlexionPronation(const T* q_WU, const T* q_WF, double s) {
  using std::atan2;
  using Rotation = Eigen::Map<const Eigen::Quaternion<T>>;
  const Matrix3T<T> R =
      (Rotation(q_WU).conjugate() * Rotation(q_WF)).normalized().toRotationMatrix();
  return {atan2(-R(0, 1), R(1, 1)), T(s) * atan2(-R(2, 0), R(2, 2))};
}

struct FlexionPronationGradient {
  Eigen::RowVector3d flexion_U, flexion_F, pronation_U, pronation_F;
};

inline FlexionPronationGradient ElbowFlexionPronationGradient(const double* q_WU,
                                                              const double* q_WF, double s) {
  using Rotation = Eigen::Map<const Eigen::Quaterniond>;
  const Eigen::Matrix3d R_UF = (Rotation(q_WU).conjugate() * Rotation(q_WF)).toRotationMatrix();
  const Eigen::Vector3d z_F = R_UF.row(2).transpose();  // the flexion axis in F
  const Eigen::Vector3d y_F = Eigen::Vector3d::UnitY();
  const Eigen::Vector3d x_F = y_F.cross(z_F);  // along the floating axis
  const Eigen::Vector3d flexion = y_F.cross(x_F) / y_F.cross(x_F).dot(z_F);
  const Eigen::Vector3d pronation = s * z_F.cross(x_F) / z_F.cross(x_F).dot(y_F);
  return {-(R_UF * flexion).transpose(), flexion.transpose(), -(R_UF * pronation).transpose(),
          pronation.transpose()};
}

}  // namespace brachium
