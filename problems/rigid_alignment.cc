#include "problems/rigid_alignment.h"

#include <Eigen/SVD>

namespace brachium {

using Eigen::Matrix3d, Eigen::Matrix3Xd, Eigen::Vector3d;

Matrix3Xd RigidMotion::Apply(const Matrix3Xd& points) const { return (R * points).colwise() + t; }

RigidMotion RigidMotion::Inverse() const { return {.R = R.transpose(), .t = -R.transpose() * t}; }

RigidMotion AlignRigidly(const Matrix3Xd& from, const Matrix3Xd& to) {
  Vector3d mean_from = Vector3d::Zero(), mean_to = Vector3d::Zero();
  double n = 0.0;
  const auto known = [&](Eigen::Index i) {
    return from.col(i).allFinite() && to.col(i).allFinite();
  };
  for (Eigen::Index i = 0; i < from.cols(); ++i) {
    if (!known(i)) continue;
    mean_from += from.col(i);
    mean_to += to.col(i);
    n += 1.0;
  }
  if (n == 0.0) return {};
  mean_from /= n;
  mean_to /= n;
  Matrix3d covariance = Matrix3d::Zero();
  for (Eigen::Index i = 0; i < from.cols(); ++i)
    if (known(i)) covariance += (to.col(i) - mean_to) * (from.col(i) - mean_from).transpose();
  const Eigen::JacobiSVD<Matrix3d> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Vector3d signs = Vector3d::Ones();
  if ((svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0) signs(2) = -1.0;
  RigidMotion motion;
  motion.R = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
  motion.t = mean_to - motion.R * mean_from;
  return motion;
}

}  // namespace brachium
