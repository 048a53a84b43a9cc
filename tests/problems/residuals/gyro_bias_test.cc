#include "problems/residuals/gyro_bias.h"

#include <gtest/gtest.h>

#include "tests/support/jacobian_check.h"

namespace brachium {
namespace {

using Eigen::Vector3d;

const Vector3d kBias(0.01, -0.02, 0.005);

TEST(GyroBiasWalk, IsZeroForABiasThatStays) {
  EXPECT_LT(ResidualAt(GyroBiasWalk(1e-4, 5.0), {kBias, kBias}).norm(), 1e-12);
}

TEST(GyroBiasWalk, IsOneAfterTheWalkOfOneSigma) {
  const Vector3d later = kBias + 1e-4 * std::sqrt(5.0) * Vector3d::UnitZ();
  EXPECT_NEAR(ResidualAt(GyroBiasWalk(1e-4, 5.0), {kBias, later}).norm(), 1.0, 1e-9);
}

TEST(GyroBiasWalk, AllowsAsMuchOverTwoHalvesAsOverTheWhole) {
  const double whole =
      1 / ResidualAt(GyroBiasWalk(1e-4, 5.0), {Vector3d(0, 0, 0), kBias}).squaredNorm();
  const double half =
      1 / ResidualAt(GyroBiasWalk(1e-4, 2.5), {Vector3d(0, 0, 0), kBias}).squaredNorm();
  EXPECT_NEAR(2 * half, whole, 1e-12 * whole);  // variances add
}

TEST(GyroBiasRest, IsZeroWhereTheLineBetweenTheNodesMeetsTheMeanRate) {
  const Vector3d before(0.0, 0.0, 0.0), after = 4 * kBias;
  EXPECT_LT(ResidualAt(GyroBiasRest(kBias, 0.25, 1e-3, 1.0), {before, after}).norm(), 1e-12);
}

TEST(GyroBiasRest, IsOneAtOneSigmaOfACertainRest) {
  const Vector3d off = kBias + 1e-3 * Vector3d::UnitX();
  EXPECT_NEAR(ResidualAt(GyroBiasRest(kBias, 0.4, 1e-3, 1.0), {off, off}).norm(), 1.0, 1e-9);
}

TEST(GyroBiasRest, CountsInProportionToTheProbabilityOfTheRest) {
  const auto cost = [](double probability) {
    return ResidualAt(GyroBiasRest(kBias, 0.4, 1e-3, probability),
                      {Vector3d(0, 0, 0), Vector3d(0.01, 0, 0)})
        .squaredNorm();
  };
  EXPECT_NEAR(cost(0.3), 0.3 * cost(1.0), 1e-12 * cost(1.0));
}

TEST(GyroBias, DerivativesAgree) {
  EXPECT_TRUE(DerivativesAgreeAtRandomPoints(GyroBiasWalk(0.1, 5.0)));
  EXPECT_TRUE(DerivativesAgreeAtRandomPoints(GyroBiasRest(kBias, 0.4, 0.05, 0.8)));
}

}  // namespace
}  // namespace brachium
