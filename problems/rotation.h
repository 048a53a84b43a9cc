// Rotations by their vector: Exp, Log and the Jacobians that relate small changes of the two.
// Full angles, in rad; q ⊗ Exp(φ) turns q by φ in its own (right) frame. Works for ceres::Jet.
// Source: Solà, Deray & Atchuthan, A micro Lie theory for state estimation in robotics (2018).
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

namespace brachium {

template <typename T>
using Vector3T = Eigen::Matrix<T, 3, 1>;
template <typename T>
using Matrix3T = Eigen::Matrix<T, 3, 3>;

// [v]x : Skew(v) * x = v × x.
template <typename T>
Matrix3T<T> Skew(const Vector3T<T>& v) {
  Matrix3T<T> m;
  m << T(0), -v.z(), v.y(), v.z(), T(0), -v.x(), -v.y(), v.x(), T(0);
  return m;
}

// The unit quaternion that turns by |φ| about φ. Smooth through zero.
template <typename T>
Eigen::Quaternion<T> Exp(const Vector3T<T>& phi) {
  using std::cos, std::sin, std::sqrt;
  const T half_squared = T(0.25) * phi.squaredNorm();
  T w, k;  // k = sin(half) / (2 half)
  if (half_squared < T(1e-8)) {
    w = T(1) - T(0.5) * half_squared;
    k = T(0.5) - half_squared / T(12);
  } else {
    const T half = sqrt(half_squared);
    w = cos(half);
    k = T(0.5) * sin(half) / half;
  }
  return Eigen::Quaternion<T>(w, k * phi.x(), k * phi.y(), k * phi.z());
}

// The rotation vector of a unit quaternion, |φ| <= π. Smooth through zero.
template <typename T>
Vector3T<T> Log(const Eigen::Quaternion<T>& q) {
  using std::atan2, std::sqrt;
  const T sign = q.w() < T(0) ? T(-1) : T(1);
  const Vector3T<T> v = sign * q.vec();
  const T w = sign * q.w();
  const T s_squared = v.squaredNorm();
  if (s_squared < T(1e-12)) return v * (T(2) / w) * (T(1) - s_squared / (T(3) * w * w));
  const T s = sqrt(s_squared);
  return v * (T(2) * atan2(s, w) / s);
}

// Right Jacobian: Exp(φ + δ) ≈ Exp(φ) Exp(Jr(φ) δ).
Eigen::Matrix3d RightJacobian(const Eigen::Vector3d& phi);

// Its inverse: Log(Exp(φ) Exp(δ)) ≈ φ + Jr⁻¹(φ) δ. |φ| < 2π.
Eigen::Matrix3d InverseRightJacobian(const Eigen::Vector3d& phi);

// The shortest rotation R with R a = b, for directions a and b.
Eigen::Quaterniond RotationBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

// The rotation with the least sum of squared sines of half the angles to all of them, which need not
// be near one another's sign. Requires at least one. Source: Markley et al., J. Guid. Control Dyn. 30
// (2007).
Eigen::Quaterniond MeanRotation(const std::vector<Eigen::Quaterniond>& rotations);

}  // namespace brachium
