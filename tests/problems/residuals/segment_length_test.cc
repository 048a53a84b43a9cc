#include "problems/residuals/segment_length.h"

#include <gtest/gtest.h>

#include "tests/support/jacobian_check.h"

namespace brachium {
namespace {

using Eigen::Vector3d;

const SegmentLength kUpperArmLength({0.0, -0.30, 0.0}, 0.005);

TEST(SegmentLength, IsZeroAtTheMeasuredJoint) {
  EXPECT_EQ(ResidualAt(kUpperArmLength, {Vector3d(0.0, -0.30, 0.0)}).norm(), 0.0);
}

TEST(SegmentLength, IsOneAtOneErrorOfTheTapeInAnyDirection) {
  for (const Vector3d& direction : {Vector3d(1, 0, 0), Vector3d(0, 1, 0), Vector3d(0, 0.6, -0.8)})
    EXPECT_NEAR(
        ResidualAt(kUpperArmLength, {Vector3d(Vector3d(0, -0.30, 0) + 0.005 * direction)}).norm(),
        1.0, 1e-12);
}

TEST(SegmentLength, DerivativesAgree) {
  EXPECT_TRUE(DerivativesAgreeAtRandomPoints(kUpperArmLength));
}

}  // namespace
}  // namespace brachium
