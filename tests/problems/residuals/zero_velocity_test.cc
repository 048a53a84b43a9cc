#include "problems/residuals/zero_velocity.h"

#include <gtest/gtest.h>

#include "tests/support/jacobian_check.h"

namespace brachium {
namespace {

using Eigen::Vector3d;

constexpr double kSigma = 0.005, kTau = 0.5, kStep = 0.1;
const auto kFirstOrder = FirstOrderStep::Over(kStep, kSigma, kTau);

TEST(ZeroVelocity, IsZeroForASensorThatStays) {
  const Vector3d zero = Vector3d::Zero();
  EXPECT_EQ(ResidualAt(ZeroVelocityStart(kSigma, 0.9), {zero}).norm(), 0.0);
  EXPECT_EQ(ResidualAt(ZeroVelocity(kFirstOrder, 0.9), {zero, zero}).norm(), 0.0);
}

TEST(ZeroVelocity, IsOneAtOneSigmaOfACertainRest) {
  const Vector3d v(0.0, kSigma, 0.0);
  EXPECT_NEAR(ResidualAt(ZeroVelocityStart(kSigma, 1.0), {v}).norm(), 1.0, 1e-12);
}

TEST(ZeroVelocity, LetsAResidualVelocityDieAway) {
  const Vector3d v(0.004, -0.003, 0.001);
  EXPECT_LT(
      ResidualAt(ZeroVelocity(kFirstOrder, 1.0), {v, Vector3d(std::exp(-kStep / kTau) * v)}).norm(),
      1e-12);
}

TEST(ZeroVelocity, CountsInProportionToTheProbabilityOfTheRest) {
  const Vector3d a(0.01, 0.02, 0.03), b(-0.01, 0.0, 0.02);
  const auto cost = [&](double probability) {
    return ResidualAt(ZeroVelocity(kFirstOrder, probability), {a, b}).squaredNorm() +
           ResidualAt(ZeroVelocityStart(kSigma, probability), {a}).squaredNorm();
  };
  EXPECT_NEAR(cost(0.3), 0.3 * cost(1.0), 1e-12 * cost(1.0));
  EXPECT_EQ(cost(0.0), 0.0);
}

TEST(ZeroVelocity, DerivativesAgree) {
  EXPECT_TRUE(DerivativesAgreeAtRandomPoints(ZeroVelocity(kFirstOrder, 0.7)));
  EXPECT_TRUE(DerivativesAgreeAtRandomPoints(ZeroVelocityStart(kSigma, 0.7)));
}

}  // namespace
}  // namespace brachium
