// SO(3) as Ceres sees it: a unit quaternion [x y z w], perturbed on the right by a full angle,
//
//   q ⊞ φ = q ⊗ Exp(φ),   φ [rad] in the body frame.
//
// Ceres' own quaternion manifolds perturb on the left by a half angle: standard deviations read off
// them are half as large and in world axes. Here a tangent covariance is in rad² and body axes.
#pragma once

#include <ceres/manifold.h>

#include <Eigen/Geometry>

#include "problems/rotation.h"

namespace brachium {

class RotationManifold final : public ceres::Manifold {
 public:
  int AmbientSize() const override { return 4; }
  int TangentSize() const override { return 3; }

  bool Plus(const double* x, const double* delta, double* x_plus) const override {
    const Eigen::Map<const Eigen::Quaterniond> q(x);
    Eigen::Map<Eigen::Quaterniond>{x_plus} =
        (q * Exp<double>(Eigen::Vector3d(delta[0], delta[1], delta[2]))).normalized();
    return true;
  }

  bool PlusJacobian(const double* x, double* jacobian) const override {
    Eigen::Map<Eigen::Matrix<double, 4, 3, Eigen::RowMajor>>{jacobian} = 0.5 * TangentBasis(x);
    return true;
  }

  bool Minus(const double* y, const double* x, double* y_minus_x) const override {
    const Eigen::Map<const Eigen::Quaterniond> q_y(y), q_x(x);
    Eigen::Map<Eigen::Vector3d>{y_minus_x} = Log<double>(q_x.conjugate() * q_y);
    return true;
  }

  bool MinusJacobian(const double* x, double* jacobian) const override {
    Eigen::Map<Eigen::Matrix<double, 3, 4, Eigen::RowMajor>>{jacobian} =
        2.0 * TangentBasis(x).transpose();
    return true;
  }

 private:
  // Columns q⊗i, q⊗j, q⊗k: orthonormal, perpendicular to q.
  static Eigen::Matrix<double, 4, 3> TangentBasis(const double* q) {
    const double x = q[0], y = q[1], z = q[2], w = q[3];
    Eigen::Matrix<double, 4, 3> basis;
    basis << w, -z, y,  //
        z, w, -x,       //
        -y, x, w,       //
        -x, -y, -z;
    return basis;
  }
};

}  // namespace brachium
