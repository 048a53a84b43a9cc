// The rigid motion that takes one set of points closest to another.
#pragma once

#include <Eigen/Geometry>

namespace brachium {

// x -> R x + t.
struct RigidMotion {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  Eigen::Vector3d t = Eigen::Vector3d::Zero();

  Eigen::Matrix3Xd Apply(const Eigen::Matrix3Xd& points) const;
  RigidMotion Inverse() const;
};

// Least Σ|to - (R from + t)|² over columns that are known in both; a proper rotation, no scale. What
// the points leave open (on one line: the turn about it) is decided anyhow and costs nothing.
// Source: Umeyama, IEEE T-PAMI 13 (1991).
RigidMotion AlignRigidly(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to);

}  // namespace brachium
