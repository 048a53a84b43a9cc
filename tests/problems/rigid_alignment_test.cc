#include "problems/rigid_alignment.h"

#include <gtest/gtest.h>

#include <cmath>

namespace brachium {
namespace {

using Eigen::Matrix3Xd, Eigen::Vector3d;

RigidMotion Example() {
  return {.R = Eigen::AngleAxisd(2.5, Vector3d(1, -2, 0.5).normalized()).toRotationMatrix(),
          .t = Vector3d(0.3, -4.0, 1.0)};
}

TEST(RigidAlignment, FindsTheMotionBetweenTwoSets) {
  const Matrix3Xd from = Matrix3Xd::Random(3, 20);
  const RigidMotion found = AlignRigidly(from, Example().Apply(from));
  EXPECT_LT((found.R - Example().R).norm(), 1e-12);
  EXPECT_LT((found.t - Example().t).norm(), 1e-12);
}

TEST(RigidAlignment, NeitherScalesNorMirrors) {
  const Matrix3Xd from = Matrix3Xd::Random(3, 20);
  EXPECT_LT((AlignRigidly(from, 3.0 * from).R - Eigen::Matrix3d::Identity()).norm(), 1e-12);
  const Matrix3Xd mirrored = Vector3d(1, 1, -1).asDiagonal() * from;
  EXPECT_NEAR(AlignRigidly(from, mirrored).R.determinant(), 1.0, 1e-12);
}

TEST(RigidAlignment, HasTheLeastSquare) {
  const Matrix3Xd from = Matrix3Xd::Random(3, 20);
  const Matrix3Xd to = Example().Apply(from) + 0.3 * Matrix3Xd::Random(3, 20);
  const RigidMotion best = AlignRigidly(from, to);
  const double least = (best.Apply(from) - to).squaredNorm();
  for (int i = 0; i < 20; ++i) {
    RigidMotion other = best;
    other.R *= Eigen::AngleAxisd(0.02, Vector3d::Random().normalized()).toRotationMatrix();
    other.t += 0.02 * Vector3d::Random();
    EXPECT_GT((other.Apply(from) - to).squaredNorm(), least);
  }
}

TEST(RigidAlignment, SkipsUnknownPointsAndTakesAPlane) {
  Matrix3Xd from = Matrix3Xd::Random(3, 20);
  from.row(2).setZero();
  const Matrix3Xd to = Example().Apply(from);
  from.col(4).setConstant(std::nan(""));
  EXPECT_LT((AlignRigidly(from, to).R - Example().R).norm(), 1e-12);
}

TEST(RigidAlignment, HasAnInverse) {
  const Matrix3Xd from = Matrix3Xd::Random(3, 5);
  EXPECT_LT((Example().Inverse().Apply(Example().Apply(from)) - from).norm(), 1e-12);
}

}  // namespace
}  // namespace brachium
