#include "problems/residuals/shoulder_process.h"

#include <gtest/gtest.h>

#include "tests/support/jacobian_check.h"

namespace brachium {
namespace {

using Eigen::Vector3d;

constexpr double kSigma = 0.03, kTau = 10.0, kStep = 0.1;
const Vector3d kMean(0.5, -0.2, 1.3), kAway(0.04, 0.01, -0.02);

ShoulderProcess Process(double duration = kStep) {
  return ShoulderProcess(FirstOrderStep::Over(duration, kSigma, kTau));
}

TEST(ShoulderProcess, IsZeroWhenTheShoulderReturnsToItsMeanAtTheRateOfTheProcess) {
  const Vector3d before = kMean + kAway, after = kMean + std::exp(-kStep / kTau) * kAway;
  EXPECT_LT(ResidualAt(Process(), {before, after, kMean}).norm(), 1e-12);
}

TEST(ShoulderProcess, IsOneWhenTheStepIsOneSigmaOff) {
  const Vector3d off = kSigma * std::sqrt(1 - std::exp(-2 * kStep / kTau)) * Vector3d::UnitY();
  const Vector3d after = kMean + std::exp(-kStep / kTau) * kAway + off;
  EXPECT_NEAR(ResidualAt(Process(), {Vector3d(kMean + kAway), after, kMean}).norm(), 1.0, 1e-12);
}

TEST(ShoulderProcess, IsBlindToWhereTheMeanIs) {
  const Vector3d before(0.1, 0.2, 0.3), after(0.3, 0.1, 0.2), shift(5.0, -7.0, 2.0);
  EXPECT_LT((ResidualAt(Process(), {before, after, kMean}) -
             ResidualAt(Process(), {Vector3d(before + shift), Vector3d(after + shift),
                                    Vector3d(kMean + shift)}))
                .norm(),
            1e-10);
}

TEST(ShoulderProcess, ForgetsThePastAfterManyCorrelationTimes) {
  const Vector3d after = kMean + kSigma * Vector3d::UnitX();
  EXPECT_NEAR(ResidualAt(Process(1000.0), {Vector3d(7.0, 8.0, 9.0), after, kMean}).norm(), 1.0,
              1e-12);
}

TEST(ShoulderProcess, DerivativesAgree) { EXPECT_TRUE(DerivativesAgreeAtRandomPoints(Process())); }

TEST(ShoulderProcessStart, IsOneAtOneSigmaFromTheMean) {
  const Vector3d start = kMean + kSigma * Vector3d(0.6, 0.0, 0.8);
  EXPECT_NEAR(ResidualAt(ShoulderProcessStart(kSigma), {start, kMean}).norm(), 1.0, 1e-12);
  EXPECT_EQ(ResidualAt(ShoulderProcessStart(kSigma), {kMean, kMean}).norm(), 0.0);
}

TEST(ShoulderProcessStart, DerivativesAgree) {
  EXPECT_TRUE(DerivativesAgreeAtRandomPoints(ShoulderProcessStart(kSigma)));
}

}  // namespace
}  // namespace brachium
