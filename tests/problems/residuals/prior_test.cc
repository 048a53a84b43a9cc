#include "problems/residuals/prior.h"

#include <gtest/gtest.h>

#include "tests/support/jacobian_check.h"

namespace brachium {
namespace {

const Prior<3> kPlace({1.0, -2.0, 3.0}, {0.1, 0.2, 0.5});
const Prior<2> kCarrying({0.17, 0.0}, {0.14, 0.09});

TEST(Prior, IsZeroAtTheMean) {
  EXPECT_EQ(ResidualAt(kPlace, {Eigen::Vector3d(1.0, -2.0, 3.0)}).norm(), 0.0);
}

TEST(Prior, IsOneAtOneSigmaOfEachComponent) {
  EXPECT_TRUE(
      ResidualAt(kPlace, {Eigen::Vector3d(1.1, -1.8, 3.5)}).isApprox(Eigen::Vector3d::Ones()));
  EXPECT_TRUE(
      ResidualAt(kCarrying, {Eigen::Vector2d(0.31, 0.09)}).isApprox(Eigen::Vector2d::Ones()));
}

TEST(Prior, DerivativesAgree) {
  EXPECT_TRUE(DerivativesAgreeAtRandomPoints(kPlace));
  EXPECT_TRUE(DerivativesAgreeAtRandomPoints(kCarrying));
}

}  // namespace
}  // namespace brachium
