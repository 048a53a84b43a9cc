#include "problems/residuals/gyroscope.h"

#include <gtest/gtest.h>

#include "tests/support/jacobian_check.h"
#include "tests/support/moving_sensor.h"
#include "tests/support/smooth_motion.h"

namespace brachium {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;

constexpr double kSigma = 1e-3, kStart = 0.2, kEnd = 0.3, kAlpha = 0.3;
const Mounting kMounting{.q_BS = Exp<double>(Vector3d(0.4, -1.0, 0.7))};
const Vector3d kZero = Vector3d::Zero();

// A swaying segment from start to end, seen by a gyroscope that adds this bias.
struct Example {
  Quaterniond before, after;  // q_WB
  Preintegrated interval;

  explicit Example(const Vector3d& bias, const Vector3d& taken_off = kZero,
                   const Vector3d& scale = kZero, double behind = 0.0) {
    const auto body = [](double t) { return SwayingBody(t, 0.3); };
    const MovingSensor sensor = [&](double t) { return SensorOn(body(t), kMounting); };
    Recording recording = Recorded(sensor, EvenTimes(0.0005, 0.001, 500));
    for (Vector3d& gyr : recording.gyr_S)
      gyr = (gyr + bias).cwiseQuotient(Vector3d::Ones() - scale);
    for (double& time : recording.time) time -= behind;
    interval = Preintegrator(recording).Sum(kStart, kEnd, taken_off);
    before = body(kStart).turning.q_AB;
    after = body(kEnd).turning.q_AB;
  }
  Gyroscope Residual() const { return {interval, kMounting.q_BS, kAlpha, kSigma}; }
  BlockValues Values(const Vector3d& b_j, const Vector3d& b_j1, const Vector3d& scale = kZero,
                     double behind = 0.0) const {
    return {
        before.coeffs(), after.coeffs(), b_j, b_j1, scale, Eigen::VectorXd::Constant(1, behind)};
  }
};

TEST(Gyroscope, IsZeroWhereTheSegmentTurnsAsTheRatesSay) {
  const Example example(kZero);
  EXPECT_LT(ResidualAt(example.Residual(), example.Values(kZero, kZero)).norm(), 1e-4);
}

TEST(Gyroscope, TakesOffTheBiasOfTheIntervalsPlaceBetweenTheNodes) {
  const Vector3d b_j(0.01, -0.02, 0.015), b_j1(-0.01, 0.01, 0.02);
  const Example example((1 - kAlpha) * b_j + kAlpha * b_j1, Vector3d(0.005, 0.0, 0.01));
  EXPECT_LT(ResidualAt(example.Residual(), example.Values(b_j, b_j1)).norm(), 1e-3);
}

TEST(Gyroscope, TakesOffTheScaleErrorOfEachAxis) {
  const Vector3d scale(2e-3, -3e-3, 1e-3);
  const Example example(kZero, kZero, scale);
  EXPECT_LT(ResidualAt(example.Residual(), example.Values(kZero, kZero, scale)).norm(), 1e-3);
  EXPECT_GT(ResidualAt(example.Residual(), example.Values(kZero, kZero)).norm(), 0.1);
}

TEST(Gyroscope, KnowsWhatAClockThatIsBehindChanges) {
  const double behind = 2e-3;
  const Example example(kZero, kZero, kZero, behind);
  EXPECT_LT(ResidualAt(example.Residual(), example.Values(kZero, kZero, kZero, behind)).norm(),
            0.05 * ResidualAt(example.Residual(), example.Values(kZero, kZero)).norm());
}

TEST(Gyroscope, IsOneAtOneSigma) {
  Example example(kZero);
  example.after = example.after * Exp<double>(Vector3d(0.0, 0.6 * kSigma, -0.8 * kSigma));
  EXPECT_NEAR(ResidualAt(example.Residual(), example.Values(kZero, kZero)).norm(), 1.0, 1e-4);
}

TEST(Gyroscope, IsBlindToAnyRotationOfTheWorld) {
  std::mt19937 random(1);
  const Example example(kZero);
  const Gyroscope residual = example.Residual();
  const BlockValues x = RandomValues(Gyroscope::Blocks(), random, 0.01);
  const BlockValues turned = TurnedWorld(RandomRotation(random), x, std::vector<bool>(6, false));
  EXPECT_LT((ResidualAt(residual, x) - ResidualAt(residual, turned)).norm(), 1e-9);
}

TEST(Gyroscope, CannotTellABiasFromAnEqualChangeOfTheMeanRate) {
  const Vector3d shift(2e-3, -1e-3, 3e-3), bias(0.01, 0.02, 0.0);
  const Example a(kZero), b(shift);
  EXPECT_LT((ResidualAt(a.Residual(), a.Values(bias, bias)) -
             ResidualAt(b.Residual(), b.Values(bias + shift, bias + shift)))
                .norm(),
            1e-3);
}

TEST(Gyroscope, DerivativesAgreeNearAgreementAndFarFromIt) {
  std::mt19937 random(1);
  Example example(kZero);
  example.interval.dR_dbg = Eigen::Matrix3d::Identity() + 0.3 * Skew<double>({0.1, 2.0, -0.5});
  example.interval.dR_dsg = Eigen::Matrix3d::Identity() - 0.2 * Skew<double>({1.1, 0.3, -0.7});
  const Quaterniond agreed = example.after;
  for (int i = 0; i < 60; ++i) {
    const double angle = std::pow(10.0, -8.0 + 0.14 * i);  // up to 2 rad
    example.after = Near(agreed, angle, random);
    const Vector3d b_j = RandomVector(3, random, 0.1), b_j1 = RandomVector(3, random, 0.1);
    const Gyroscope residual(example.interval, kMounting.q_BS, kAlpha, 0.1);
    EXPECT_TRUE(DerivativesAgree(residual, example.Values(kZero, kZero))) << angle;
    const Vector3d scale = RandomVector(3, random, 0.1);
    const double behind = RandomVector(1, random, 0.01)[0];
    EXPECT_TRUE(DerivativesAgree(residual, example.Values(b_j, b_j1, scale, behind))) << angle;
  }
}

}  // namespace
}  // namespace brachium
