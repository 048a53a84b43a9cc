#include "problems/stillness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "tests/support/moving_sensor.h"
#include "tests/support/residual_values.h"
#include "tests/support/smooth_motion.h"

namespace brachium {
namespace {

using Eigen::Vector3d;

const Vector3d kUp_S = Vector3d(0.3, 9.0, 3.5).normalized() * kGravity;

using Signal = std::function<Vector3d(double)>;
Vector3d Zero(double) { return Vector3d::Zero(); }

// A sensor with these rates [deg/s] and with these forces beside gravity [m/s²], and its noise.
Recording Signals(const Signal& rate_deg_s, const Signal& force, double duration,
                  double frequency = 100.0) {
  Recording recording;
  recording.time = EvenTimes(0.0, 1 / frequency, static_cast<std::size_t>(duration * frequency));
  std::mt19937 random(1);
  const ImuNoise& noise = recording.noise;
  const double bandwidth = std::sqrt(frequency / 2);
  for (const double t : recording.time) {
    recording.gyr_S.push_back(kDegree * rate_deg_s(t) +
                              RandomVector(3, random, noise.gyro_density * bandwidth));
    recording.acc_S.push_back(kUp_S + force(t) +
                              RandomVector(3, random, noise.accel_density * bandwidth));
  }
  return recording;
}

bool IsMoving(double t) { return t < 2.0 || t > 4.0; }

// Moves as an arm does, but for a rest from 2 to 4 s.
Recording RestInTheMiddle(const Vector3d& bias_deg_s) {
  return Signals(
      [&](double t) -> Vector3d {
        return bias_deg_s + (IsMoving(t) ? 90.0 : 0.0) * Vector3d(std::sin(7 * t), 1.0, 0.5);
      },
      [](double t) -> Vector3d {
        return (IsMoving(t) ? 3.0 : 0.0) * Vector3d(std::sin(9 * t), std::cos(8 * t), 0.0);
      },
      6.0);
}

TEST(DetectRests, FindsARestBetweenMovements) {
  const auto rests = DetectRests(RestInTheMiddle(Vector3d::Zero()), {});
  ASSERT_EQ(rests.size(), 1u);
  EXPECT_NEAR(rests[0].start, 2.0, 0.1);
  EXPECT_NEAR(rests[0].end, 4.0, 0.1);
  EXPECT_GT(rests[0].probability, 0.8);
  EXPECT_LE(rests[0].probability, 1.0);
  EXPECT_LT((rests[0].mean_force - kUp_S).norm(), 0.01);
}

TEST(DetectRests, TakesTheMeanRateOfARestForTheBiasOfItsSensor) {
  const Vector3d bias_deg_s(0.6, -0.7, 0.4);  // about 1 deg/s
  const auto rests = DetectRests(RestInTheMiddle(bias_deg_s), {});
  ASSERT_EQ(rests.size(), 1u);
  EXPECT_NEAR(rests[0].start, 2.0, 0.1);
  EXPECT_NEAR(rests[0].end, 4.0, 0.1);
  EXPECT_LT((rests[0].mean_rate - kDegree * bias_deg_s).norm(), 0.05 * kDegree);
  EXPECT_GT(rests[0].probability, 0.8);
}

TEST(DetectRests, IsAsSureOfASensorWithABiasAsOfOneWithout) {
  for (const double bias_deg_s : {0.0, 1.0, 1.8}) {
    const auto rests =
        DetectRests(Signals([&](double) { return Vector3d(0.0, bias_deg_s, 0.0); }, Zero, 5.0), {});
    ASSERT_EQ(rests.size(), 1u);
    EXPECT_GT(rests[0].probability, 0.85);
  }
}

// Turns from rest by a smooth step of 60 deg in 0.8 s, which begins at 3 s.
Signal SmoothStart() {
  return [](double t) -> Vector3d {
    const double x = std::clamp((t - 3.0) / 0.8, 0.0, 1.0);
    return 60.0 / 0.8 * 30.0 * x * x * (1 - x) * (1 - x) * Vector3d::UnitY();
  };
}

TEST(DetectRests, EndsARestWhereAMovementBegins) {
  const auto rests = DetectRests(Signals(SmoothStart(), Zero, 3.8), {});
  ASSERT_EQ(rests.size(), 1u);
  EXPECT_NEAR(rests[0].end, 3.0, 0.03);
  EXPECT_LT(rests[0].mean_rate.norm(), 0.01 * kDegree);
}

TEST(DetectRests, KeepsTheRestOfASensorWithoutNoise) {
  Recording recording = Signals(SmoothStart(), Zero, 3.8);
  for (std::size_t i = 0; i < recording.size(); ++i) {
    recording.gyr_S[i] = kDegree * SmoothStart()(recording.time[i]);
    recording.acc_S[i] = kUp_S;
  }
  const auto rests = DetectRests(recording, {});
  ASSERT_EQ(rests.size(), 1u);
  EXPECT_NEAR(rests[0].end, 3.0, 0.03);
}

TEST(DetectRests, TakesNoTurningPointOfAMovementForARest) {
  const auto force_at_the_turn = [](double acceleration) {
    return Signals(
        [](double t) -> Vector3d {
          return std::abs(t - 3.0) < 0.2 ? Vector3d::Zero() : Vector3d(90, 40, 0);
        },
        [=](double) -> Vector3d { return acceleration * kUp_S.normalized(); }, 6.0);
  };
  EXPECT_EQ(DetectRests(force_at_the_turn(0.0), {}).size(), 1u);
  EXPECT_EQ(DetectRests(force_at_the_turn(0.8), {}).size(), 0u);
}

TEST(DetectRests, FindsNothingWhereTheSensorTurnsSlowlyAndIsPushedGently) {
  for (const Vector3d& axis : {Vector3d(1, 0, 0), Vector3d(0, 0.6, 0.8), Vector3d(0, 0, -1)}) {
    const auto recording = Signals(
        [&](double) -> Vector3d { return 5.0 * axis; },
        [](double t) -> Vector3d { return 0.2 * Vector3d(std::sin(9 * t), std::cos(9 * t), 0.0); },
        5.0);
    EXPECT_TRUE(DetectRests(recording, {}).empty());
  }
}

TEST(DetectRests, FindsNothingWhereTheSensorOnlyTurnsSlowly) {
  EXPECT_TRUE(
      DetectRests(Signals([](double) { return Vector3d(0.0, 5.0, 0.0); }, Zero, 5.0), {}).empty());
}

TEST(DetectRests, FindsNothingWhereTheSensorIsOnlyShaken) {
  EXPECT_TRUE(
      DetectRests(
          Signals(
              Zero, [](double t) -> Vector3d { return Vector3d(std::sin(20 * t), 0.0, 0.0); }, 5.0),
          {})
          .empty());
}

TEST(DetectRests, CallsAStillRecordingOneRestFromEndToEnd) {
  const auto recording = Signals(Zero, Zero, 5.0);
  const auto rests = DetectRests(recording, {});
  ASSERT_EQ(rests.size(), 1u);
  EXPECT_EQ(rests[0].start, recording.time.front());
  EXPECT_EQ(rests[0].end, recording.time.back());
}

TEST(DetectRests, CutsARestWhereSamplesAreMissing) {
  Recording recording = Signals(Zero, Zero, 5.0);
  Lose(recording, 200, 100);
  const auto rests = DetectRests(recording, {});
  ASSERT_EQ(rests.size(), 2u);
  EXPECT_NEAR(rests[0].end, 2.0, 0.02);
  EXPECT_NEAR(rests[1].start, 3.0, 0.02);
}

TEST(DetectRests, SaysNothingOfARecordingShorterThanItsWindow) {
  for (const double duration : {0.02, 0.03, 0.05, 0.1})
    EXPECT_TRUE(DetectRests(Signals(Zero, Zero, duration), {}).empty()) << duration;
}

TEST(RestInterval, HoldsTheSwayOfTheSegmentInIt) {
  const double amplitude = 0.1;  // [deg], at 1 Hz
  const double angular_frequency = 2 * std::numbers::pi;
  const auto recording = Signals(
      [&](double t) -> Vector3d {
        return amplitude * angular_frequency * std::cos(angular_frequency * t) * Vector3d::UnitX();
      },
      Zero, 4.0);
  const auto rests = DetectRests(recording, {});
  ASSERT_EQ(rests.size(), 1u);
  EXPECT_NEAR(rests[0].sway, amplitude * kDegree / std::sqrt(6.0), 0.1 * amplitude * kDegree);
}

TEST(PartOfRest, HasItsOwnMeansAndTheProbabilityOfTheWhole) {
  const auto recording =
      Signals([](double t) { return Vector3d(t < 2.5 ? 0.2 : 0.4, 0.0, 0.0); }, Zero, 5.0);
  const auto rests = DetectRests(recording, {});
  ASSERT_EQ(rests.size(), 1u);
  const RestInterval part = PartOfRest(recording, rests[0], 2.6, 3.6);
  EXPECT_NEAR(part.start, 2.6, 1e-9);
  EXPECT_NEAR(part.end, 3.6, 1e-9);
  EXPECT_NEAR(part.mean_rate.x(), 0.4 * kDegree, 0.03 * kDegree);
  EXPECT_EQ(part.probability, rests[0].probability);
}

TEST(PartOfRest, HasNoProbabilityWhereHardlyASampleIsInside) {
  const auto recording = Signals(Zero, Zero, 5.0);
  const auto rests = DetectRests(recording, {});
  ASSERT_EQ(rests.size(), 1u);
  EXPECT_EQ(PartOfRest(recording, rests[0], 2.001, 2.019).probability, 0.0);
  EXPECT_EQ(PartOfRest(recording, rests[0], 2.001, 2.029).probability, 0.0);
  EXPECT_EQ(PartOfRest(recording, rests[0], 7.0, 8.0).probability, 0.0);
}

}  // namespace
}  // namespace brachium
