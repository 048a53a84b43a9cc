#include "solver/baselines/butterworth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/smooth_motion.h"

namespace brachium {
namespace {

using Eigen::Vector3d;
using Band = Butterworth::Band;

constexpr double kPeriod = 0.01;  // [s]

std::vector<Vector3d> Wave(double frequency, double duration) {
  return Sampled(EvenTimes(0.0, kPeriod, static_cast<std::size_t>(duration / kPeriod)),
                 [frequency](double t) -> Vector3d {
                   const double phase = 2 * std::numbers::pi * frequency * t;
                   return {std::sin(phase), 2 * std::sin(phase), std::cos(phase)};
                 });
}

// Peak over the middle, of a wave whose own peak is 1.
double Gain(double frequency, const Butterworth& filter) {
  const auto filtered = Filtered(Wave(frequency, 60 / frequency), kPeriod, filter);
  double peak = 0.0;
  for (std::size_t i = filtered.size() / 3; i < 2 * filtered.size() / 3; ++i)
    peak = std::max(peak, std::abs(filtered[i].x()));
  return peak;
}

TEST(Butterworth, HasItsGainAtTheCutoffWhateverTheOrder) {
  for (const Band band : {Band::kLow, Band::kHigh})
    for (const int order : {1, 2, 3, 4}) {
      EXPECT_NEAR(Gain(0.5, {band, 0.5, order}), std::numbers::sqrt2 / 2, 0.01) << order;
      EXPECT_NEAR(Gain(0.5, {band, 0.5, order, true}), 0.5, 0.01) << order;
    }
}

TEST(Butterworth, FallsByItsOrderAnOctaveBeyondTheCutoff) {
  for (const int order : {1, 2, 3}) {
    const double expected = 1 / std::sqrt(1 + std::pow(2.0, 2 * order));
    EXPECT_NEAR(Gain(0.5, {Band::kLow, 0.25, order}), expected, 0.01) << order;
    EXPECT_NEAR(Gain(0.5, {Band::kHigh, 1.0, order}), expected, 0.01) << order;
  }
}

TEST(Butterworth, PassesOrStopsAConstantFromTheFirstSample) {
  const std::vector<Vector3d> constant(50, Vector3d(1.0, -2.0, 3.0));
  for (const bool zero_phase : {false, true})
    for (const int order : {1, 2, 3}) {
      for (const Vector3d& v : Filtered(constant, kPeriod, {Band::kLow, 5.0, order, zero_phase}))
        EXPECT_NEAR((v - constant[0]).norm(), 0.0, 1e-12);
      for (const Vector3d& v : Filtered(constant, kPeriod, {Band::kHigh, 5.0, order, zero_phase}))
        EXPECT_NEAR(v.norm(), 0.0, 1e-12);
    }
}

TEST(Butterworth, DelaysNothingWithZeroPhase) {
  const auto wave = Wave(1.0, 10.0);
  const auto filtered = Filtered(wave, kPeriod, {Band::kLow, 10.0, 2, true});
  const auto delayed = Filtered(wave, kPeriod, {Band::kLow, 10.0, 2, false});
  double worst = 0.0, worst_delayed = 0.0;
  for (std::size_t i = 100; i < 900; ++i) {
    worst = std::max(worst, (filtered[i] - wave[i]).norm());
    worst_delayed = std::max(worst_delayed, (delayed[i] - wave[i]).norm());
  }
  EXPECT_LT(worst, 1e-3);
  EXPECT_GT(worst_delayed, 0.1);
}

TEST(Butterworth, OfTwentiethHertzForgetsAReachThatIsHeld) {
  // 90 deg in the first second, then nothing.
  std::vector<Vector3d> rate(1000, Vector3d::Zero());
  rate[0] = Vector3d::Zero();
  for (std::size_t i = 1; i <= 100; ++i) rate[i].x() = 90.0;
  double angle = 0.0;
  std::vector<double> angles;
  for (const Vector3d& filtered : Filtered(rate, kPeriod, {Band::kHigh, 0.05, 1}))
    angles.push_back(angle += kPeriod * filtered.x());
  EXPECT_NEAR(angles[100], 77, 0.5);
  EXPECT_NEAR(angles[200], 56, 0.5);
  EXPECT_NEAR(angles[400], 30, 0.5);
  EXPECT_NEAR(angles[800], 9, 0.5);
}

}  // namespace
}  // namespace brachium
