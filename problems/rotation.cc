#include "problems/rotation.h"

#include <Eigen/Eigenvalues>

namespace brachium {

Eigen::Matrix3d RightJacobian(const Eigen::Vector3d& phi) {
  const double a2 = phi.squaredNorm();
  const Eigen::Matrix3d S = Skew<double>(phi);
  if (a2 < 1e-8)
    return Eigen::Matrix3d::Identity() - (0.5 - a2 / 24) * S + (1.0 / 6 - a2 / 120) * S * S;
  const double a = std::sqrt(a2);
  return Eigen::Matrix3d::Identity() - (1 - std::cos(a)) / a2 * S +
         (a - std::sin(a)) / (a2 * a) * S * S;
}

Eigen::Matrix3d InverseRightJacobian(const Eigen::Vector3d& phi) {
  const double a2 = phi.squaredNorm();
  const Eigen::Matrix3d S = Skew<double>(phi);
  if (a2 < 1e-8) return Eigen::Matrix3d::Identity() + 0.5 * S + (1.0 / 12 + a2 / 720) * S * S;
  const double a = std::sqrt(a2);
  return Eigen::Matrix3d::Identity() + 0.5 * S + (1 - 0.5 * a / std::tan(0.5 * a)) / a2 * S * S;
}

Eigen::Quaterniond RotationBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return Eigen::Quaterniond::FromTwoVectors(a, b);
}

Eigen::Quaterniond MeanRotation(const std::vector<Eigen::Quaterniond>& rotations) {
  Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();
  for (const Eigen::Quaterniond& q : rotations) sum += q.coeffs() * q.coeffs().transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(sum);
  return Eigen::Quaterniond(Eigen::Vector4d(solver.eigenvectors().col(3)));
}

}  // namespace brachium
