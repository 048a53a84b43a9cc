// Golden values: a Gaussian speed exp(-5 t²) on [-1, 1) and a minimum-jerk speed of one second, both
// at 100 Hz, computed elsewhere with the authors' definitions; limits in closed form.
#include "problems/smoothness.h"

#include <gtest/gtest.h>

#include <cmath>

namespace brachium {
namespace {

std::vector<double> GaussianSpeed() {
  std::vector<double> speed;
  for (int i = 0; i < 200; ++i) speed.push_back(std::exp(-5.0 * std::pow(-1.0 + 0.01 * i, 2)));
  return speed;
}

std::vector<double> MinimumJerkSpeed(int n) {
  std::vector<double> speed;
  for (int i = 0; i < n; ++i) {
    const double t = static_cast<double>(i) / n;
    speed.push_back(30.0 * t * t * (1.0 - t) * (1.0 - t));
  }
  return speed;
}

std::vector<double> TwoBumps(double second) {
  std::vector<double> speed = MinimumJerkSpeed(100);
  for (const double v : MinimumJerkSpeed(100)) speed.push_back(second * v);
  return speed;
}

TEST(SpectralArcLength, MeetsItsGoldenValues) {
  EXPECT_NEAR(SpectralArcLength(GaussianSpeed(), 100.0), -1.41403, 1e-5);
  EXPECT_NEAR(SpectralArcLength(MinimumJerkSpeed(100), 100.0), -1.40583, 1e-5);
}

TEST(SpectralArcLength, DoesNotDependOnTheSize) {
  std::vector<double> speed = GaussianSpeed();
  const double once = SpectralArcLength(speed, 100.0);
  for (double& v : speed) v *= 7.0;
  EXPECT_NEAR(SpectralArcLength(speed, 100.0), once, 1e-12);
}

TEST(LogDimensionlessJerk, MeetsItsGoldenValues) {
  EXPECT_NEAR(LogDimensionlessJerk(GaussianSpeed(), 100.0), -5.81636, 1e-5);
  EXPECT_NEAR(LogDimensionlessJerk(MinimumJerkSpeed(100), 100.0), -5.22414, 1e-5);
}

TEST(LogDimensionlessJerk, TendsToItsLimitInClosedForm) {
  EXPECT_NEAR(LogDimensionlessJerk(MinimumJerkSpeed(20000), 20000.0), -std::log(204.8), 1e-3);
}

TEST(Smoothness, IsLessForTwoSubmovementsThanForOne) {
  EXPECT_LT(SpectralArcLength(TwoBumps(0.8), 100.0),
            SpectralArcLength(MinimumJerkSpeed(100), 100.0));
  EXPECT_LT(LogDimensionlessJerk(TwoBumps(0.8), 100.0),
            LogDimensionlessJerk(MinimumJerkSpeed(100), 100.0));
}

TEST(Smoothness, IsUnknownWithoutMovement) {
  EXPECT_TRUE(std::isnan(SpectralArcLength({0, 0, 0, 0}, 100.0)));
  EXPECT_TRUE(std::isnan(LogDimensionlessJerk({0, 0, 0, 0}, 100.0)));
  EXPECT_TRUE(std::isnan(SpectralArcLength({1, std::nan(""), 1}, 100.0)));
  EXPECT_EQ(SpeedPeaks({}), 0);
}

TEST(SpeedPeaks, CountsSubmovementsButNotRipples) {
  EXPECT_EQ(SpeedPeaks(MinimumJerkSpeed(100)), 1);
  EXPECT_EQ(SpeedPeaks(TwoBumps(1.0)), 2);
  EXPECT_EQ(SpeedPeaks(TwoBumps(0.03)), 1);
  EXPECT_EQ(SpeedPeaks({0, 1, 2, 2, 3, 0}), 1);
}

}  // namespace
}  // namespace brachium
