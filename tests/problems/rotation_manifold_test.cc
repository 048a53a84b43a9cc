#include "problems/rotation_manifold.h"

#include <ceres/manifold_test_utils.h>
#include <gtest/gtest.h>

#include "tests/support/residual_values.h"

namespace brachium {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;

const RotationManifold kManifold;

TEST(RotationManifold, KeepsTheLawsOfAManifold) {
  std::mt19937 random(1);
  for (int i = 0; i < 50; ++i) {
    const ceres::Vector x = RandomRotation(random).coeffs(), y = RandomRotation(random).coeffs();
    const ceres::Vector delta = 2.5 * RandomVector(3, random).normalized();
    EXPECT_THAT(kManifold, ceres::XPlusZeroIsXAt(x, 1e-12));
    EXPECT_THAT(kManifold, ceres::XMinusXIsZeroAt(x, 1e-12));
    EXPECT_THAT(kManifold, ceres::MinusPlusIsIdentityAt(x, delta, 1e-12));
    EXPECT_THAT(kManifold, ceres::MinusPlusJacobianIsIdentityAt(x, 1e-12));
    EXPECT_THAT(kManifold, ceres::HasCorrectPlusJacobianAt(x, 1e-7));
    EXPECT_THAT(kManifold, ceres::HasCorrectMinusJacobianAt(x, 1e-7));
  }
}

TEST(RotationManifold, TurnsByTheFullAngleInTheBodysAxes) {
  std::mt19937 random(1);
  const Quaterniond q_WB = RandomRotation(random);
  const Vector3d phi(0.0, 0.3, 0.0);
  Quaterniond turned;
  kManifold.Plus(q_WB.coeffs().data(), phi.data(), turned.coeffs().data());
  const Quaterniond expected = q_WB * Eigen::AngleAxisd(0.3, Vector3d::UnitY());
  EXPECT_LT(turned.angularDistance(expected), 1e-14);
}

TEST(RotationManifold, StaysOnTheUnitSphereOverManySteps) {
  std::mt19937 random(1);
  Quaterniond q = RandomRotation(random);
  for (int i = 0; i < 10000; ++i) {
    const Vector3d step = RandomVector(3, random, 0.5);
    Quaterniond next;
    kManifold.Plus(q.coeffs().data(), step.data(), next.coeffs().data());
    q = next;
  }
  EXPECT_NEAR(q.norm(), 1.0, 1e-14);
}

}  // namespace
}  // namespace brachium
