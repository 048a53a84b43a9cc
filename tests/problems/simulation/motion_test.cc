#include "problems/simulation/motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace brachium {
namespace {

// Rate and acceleration against central differences of the value and of the rate.
void ExpectDerivativesAreExact(const std::function<Moving(double)>& motion, double t,
                               double tolerance) {
  constexpr double kStep = 1e-5;
  const Moving before = motion(t - kStep), here = motion(t), after = motion(t + kStep);
  EXPECT_NEAR(here.rate, (after.value - before.value) / (2 * kStep), tolerance) << "at " << t;
  EXPECT_NEAR(here.acceleration, (after.rate - before.rate) / (2 * kStep), tolerance) << "at " << t;
}

TEST(SmoothStep, GoesFromZeroToOneAndIsStillOutside) {
  for (const double u : {-3.0, 0.0, 1e-9, 0.005}) {
    EXPECT_EQ(SmoothStep(u).value, 0.0);
    EXPECT_EQ(SmoothStep(u).rate, 0.0);
    EXPECT_EQ(SmoothStep(1.0 - u).value, 1.0);
    EXPECT_EQ(SmoothStep(1.0 - u).acceleration, 0.0);
  }
  EXPECT_DOUBLE_EQ(SmoothStep(0.5).value, 0.5);
  EXPECT_DOUBLE_EQ(SmoothStep(0.5).rate, 2.0);
}

TEST(SmoothStep, HasNoJumpWhereItIsCutToBeStill) {
  EXPECT_LT(SmoothStep(0.0100001).value, 1e-40);
  EXPECT_LT(std::abs(SmoothStep(0.0100001).acceleration), 1e-30);
}

TEST(SmoothStep, HasTheDerivativesItClaims) {
  for (double u = -0.1; u < 1.1; u += 0.013) ExpectDerivativesAreExact(SmoothStep, u, 1e-6);
}

// The values of Flash & Hogan 1985: half-way in the middle, with 15/8 of the mean speed.
TEST(MinimumJerkStep, GoesFromZeroToOneWithItsPeakInTheMiddle) {
  EXPECT_EQ(MinimumJerkStep(-0.1).value, 0.0);
  EXPECT_EQ(MinimumJerkStep(1.0).value, 1.0);
  EXPECT_EQ(MinimumJerkStep(1.1).rate, 0.0);
  EXPECT_DOUBLE_EQ(MinimumJerkStep(0.5).value, 0.5);
  EXPECT_DOUBLE_EQ(MinimumJerkStep(0.5).rate, 1.875);
  for (double u = 0.0133; u < 1.0; u += 0.013) ExpectDerivativesAreExact(MinimumJerkStep, u, 1e-6);
}

TEST(Moving, FunctionsFollowTheChainRule) {
  const auto a = [](double t) {
    return Moving{0.7 * std::sin(3 * t), 2.1 * std::cos(3 * t), -6.3 * std::sin(3 * t)};
  };
  const auto b = [](double t) { return Moving{1.0 + t * t, 2 * t, 2.0}; };
  for (double t = -1.0; t < 1.0; t += 0.1) {
    ExpectDerivativesAreExact([&](double x) { return Sin(a(x)); }, t, 1e-7);
    ExpectDerivativesAreExact([&](double x) { return Asin(a(x)); }, t, 1e-6);
    ExpectDerivativesAreExact([&](double x) { return Atan2(a(x), b(x)); }, t, 1e-7);
    ExpectDerivativesAreExact([&](double x) { return Sqrt(b(x)); }, t, 1e-7);
    ExpectDerivativesAreExact([&](double x) { return Inverse(b(x)); }, t, 1e-7);
  }
  EXPECT_DOUBLE_EQ(Atan2({1.0, 0, 0}, {-1.0, 0, 0}).value, 0.75 * M_PI);
}

TEST(Moving, ProductsAndCosineFollowTheChainRule) {
  const auto a = [](double t) {
    return Moving{std::sin(3 * t), 3 * std::cos(3 * t), -9 * std::sin(3 * t)};
  };
  const auto b = [](double t) { return Moving{t * t, 2 * t, 2.0}; };
  for (double t = -1.0; t < 1.0; t += 0.1) {
    ExpectDerivativesAreExact([&](double x) { return a(x) * b(x); }, t, 1e-7);
    ExpectDerivativesAreExact([&](double x) { return Cos(a(x) + -b(x)); }, t, 1e-7);
  }
}

Motion Overlapping() {
  Motion motion(0.2);
  motion.AddStep(1.0, 2.0, 1.5);
  motion.AddStep(1.1, 0.3, -0.4);
  motion.AddStep(2.5, 1.0, -2.0);
  motion.AddStep(6.0, 0.5, 0.7);
  motion.AddSinusoid(0.1, 0.7, 0.4);
  return motion;
}

TEST(Motion, HasTheDerivativesItClaimsWhereStepsOverlap) {
  const Motion motion = Overlapping();
  for (double t = 0.0; t < 8.0; t += 0.07)
    ExpectDerivativesAreExact([&](double x) { return motion.At(x); }, t, 1e-5);
}

TEST(Motion, IsTheSumOfItsSteps) {
  const Motion motion = Overlapping();
  const auto sum = [](double t) {
    return 0.2 + 1.5 * SmoothStep((t - 1.0) / 2.0).value - 0.4 * SmoothStep((t - 1.1) / 0.3).value -
           2.0 * SmoothStep(t - 2.5).value + 0.7 * SmoothStep((t - 6.0) / 0.5).value +
           0.1 * std::sin(2 * M_PI * 0.7 * t + 0.4);
  };
  for (double t = 0.0; t < 8.0; t += 0.01) EXPECT_NEAR(motion.At(t).value, sum(t), 1e-14);
}

TEST(Motion, StaysWhereTheLastStepEnded) {
  Motion motion(1.0);
  motion.AddStep(0.0, 1.0, 2.0);
  EXPECT_EQ(motion.At(5.0).value, 3.0);
  EXPECT_EQ(motion.At(5.0).rate, 0.0);
  EXPECT_EQ(motion.At(-5.0).value, 1.0);
}

TEST(RandomMotion, HasTheRmsAndTheFrequencyAskedFor) {
  Draws draws(11, "random_motion");
  const Motion motion = RandomMotion(0.05, 1.0, draws);
  constexpr int kCount = 100000;  // 1000 s
  double squares = 0.0, rate_squares = 0.0;
  for (int i = 0; i < kCount; ++i) {
    const Moving m = motion.At(0.01 * i);
    squares += m.value * m.value;
    rate_squares += m.rate * m.rate;
  }
  EXPECT_NEAR(std::sqrt(squares / kCount), 0.05, 0.001);
  const double frequency = std::sqrt(rate_squares / squares) / (2 * M_PI);
  EXPECT_GT(frequency, 0.8);
  EXPECT_LT(frequency, 1.5);
}

}  // namespace
}  // namespace brachium
