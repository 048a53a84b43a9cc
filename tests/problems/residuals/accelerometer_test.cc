#include "problems/residuals/accelerometer.h"

#include <gtest/gtest.h>

#include "tests/support/jacobian_check.h"
#include "tests/support/moving_sensor.h"
#include "tests/support/smooth_motion.h"

namespace brachium {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d, Eigen::VectorXd;

constexpr double kStart = 0.2, kEnd = 0.3, kDuration = kEnd - kStart, kAlpha = 0.3;
constexpr std::size_t kPlace = 1, kVelocity = 3;
const Mounting kMounting{.q_BS = Exp<double>(Vector3d(0.4, -1.0, 0.7)),
                         .p_BS_B = Vector3d(0.03, -0.15, 0.02)};

// Errors of the sensor, as the unknowns have them.
struct SensorFaults {
  Vector3d b_j = Vector3d::Zero(), b_j1 = Vector3d::Zero(), gyro_scale = Vector3d::Zero();
  Vector3d accel_bias = Vector3d::Zero(), accel_scale = Vector3d::Zero();
};

// A sensor on a swaying segment.
struct Example {
  BlockValues x;
  Preintegrated interval;

  explicit Example(const SensorFaults& faults = {}) {
    const auto body = [](double t) { return SwayingBody(t, 0.3); };
    const MovingSensor sensor = [&](double t) { return SensorOn(body(t), kMounting); };
    Recording recording = Recorded(sensor, EvenTimes(0.0005, 0.001, 500));
    for (Vector3d& gyr : recording.gyr_S)
      gyr = (gyr + (1 - kAlpha) * faults.b_j + kAlpha * faults.b_j1)
                .cwiseQuotient(Vector3d::Ones() - faults.gyro_scale);
    for (Vector3d& acc : recording.acc_S)
      acc = (acc + faults.accel_bias).cwiseQuotient(Vector3d::Ones() - faults.accel_scale);
    interval = Preintegrator(recording).Sum(kStart, kEnd, Vector3d::Zero());
    const SensorInstant before = sensor(kStart), after = sensor(kEnd);
    x = {body(kStart).turning.q_AB.coeffs(),
         before.p_W,
         after.p_W,
         before.v_W,
         after.v_W,
         faults.b_j,
         faults.b_j1,
         faults.gyro_scale,
         faults.accel_bias,
         faults.accel_scale};
  }

  Accelerometer Residual(const Whitening2& whitening = {}, double gravity = kGravity) const {
    return {interval, kMounting.q_BS, kAlpha, gravity, whitening};
  }
};

// Unwhitened: m/s and m.
TEST(Accelerometer, IsZeroWhereTheSensorMovesAsTheForcesSay) {
  const Example example;
  EXPECT_LT(ResidualAt(example.Residual(), example.x).norm(), 1e-6);
}

TEST(Accelerometer, FeelsTheGravityOfThePlace) {
  Example example;
  const double weaker = 0.03;
  const Quaterniond q_WB(example.x.front().data());
  const Vector3d less_S = (q_WB * kMounting.q_BS).conjugate() * Vector3d(0, 0, weaker);
  example.interval.dv -= less_S * kDuration;
  example.interval.dp -= less_S * (kDuration * kDuration / 2);
  EXPECT_LT(ResidualAt(example.Residual({}, kGravity - weaker), example.x).norm(), 1e-6);
}

TEST(Accelerometer, TakesOffBiasesAndScaleErrorsOfTheSensor) {
  const Example example({.b_j = Vector3d(1e-3, -2e-3, 1e-3),
                         .b_j1 = Vector3d(-1e-3, 0.0, 3e-3),
                         .gyro_scale = Vector3d(1e-3, -2e-3, 3e-3),
                         .accel_bias = Vector3d(0.05, -0.03, 0.1),
                         .accel_scale = Vector3d(0.01, -0.02, 0.005)});
  EXPECT_LT(ResidualAt(example.Residual(), example.x).norm(), 3e-6);
}

TEST(Accelerometer, IsBlindToHeadingToThePlaceAndToASteadyVelocityOfTheWhole) {
  const Example example;
  std::mt19937 random(1);
  BlockValues x = RandomValues(Accelerometer::Blocks(), random);
  const VectorXd r = ResidualAt(example.Residual(), x);
  std::vector<bool> is_world(x.size(), false);
  for (std::size_t i = kPlace; i < kVelocity + 2; ++i) is_world[i] = true;
  const Quaterniond q_VW(Eigen::AngleAxisd(0.9, Vector3d::UnitZ()));
  x = TurnedWorld(q_VW, x, is_world);
  const Vector3d shift(3.0, -2.0, 1.0), wind(0.5, 0.2, -0.3);
  x[kPlace] += shift;
  x[kPlace + 1] += shift + kDuration * wind;
  x[kVelocity] += wind;
  x[kVelocity + 1] += wind;
  EXPECT_LT((ResidualAt(example.Residual(), x) - r).norm(), 1e-12);
}

TEST(Accelerometer, DerivativesAgree) {
  const auto white = WhiteAccelerationCovariance(1.0, 0.5);
  Example example;
  std::mt19937 random(1);
  for (Eigen::Matrix3d* block : {&example.interval.dv_dbg, &example.interval.dp_dbg,
                                 &example.interval.dv_dsg, &example.interval.dp_dsg})
    for (int i = 0; i < 3; ++i) block->col(i) = RandomVector(3, random);
  EXPECT_TRUE(DerivativesAgreeAtRandomPoints(example.Residual(Whitening2::FromCovariance(white))));
  EXPECT_TRUE(DerivativesAgree(example.Residual(), example.x));
}

TEST(Accelerometer, IsOneWhenVelocityAndPlaceAreOffByOneSigmaOfWhiteAcceleration) {
  const double density = 0.01;
  Example example;
  const auto whitening =
      Whitening2::FromCovariance(WhiteAccelerationCovariance(density, kDuration));
  const Vector3d off = std::sqrt(density * kDuration) * Vector3d::UnitY();
  example.x[kVelocity + 1] += off;
  example.x[kPlace + 1] += kDuration / 2 * off;  // what goes along with it
  EXPECT_NEAR(ResidualAt(example.Residual(whitening), example.x).norm(), 1.0, 1e-3);
}

TEST(Accelerometer, CannotTellTiltFromBiasWhileTheSensorKeepsItsAttitude) {
  const double tilt = 1e-4;
  Preintegrated rest;
  rest.duration = kDuration;
  rest.dv = kGravity * kDuration * Vector3d::UnitZ();
  rest.dp = kGravity * kDuration * kDuration / 2 * Vector3d::UnitZ();
  rest.dv_dba = -kDuration * Eigen::Matrix3d::Identity();
  rest.dp_dba = -kDuration * kDuration / 2 * Eigen::Matrix3d::Identity();
  const Accelerometer residual(rest, Quaterniond::Identity(), 0.5, kGravity, {});
  const Vector3d zero = Vector3d::Zero();
  const Quaterniond upright = Quaterniond::Identity(), tilted = Exp<double>({tilt, 0.0, 0.0});
  const auto at = [&](const Quaterniond& q, const Vector3d& bias) {
    return ResidualAt(residual, {q.coeffs(), zero, zero, zero, zero, zero, zero, zero, bias, zero});
  };
  EXPECT_LT(at(upright, zero).norm(), 1e-12);
  EXPECT_GT(at(tilted, zero).norm(), 0.9 * kGravity * tilt * kDuration);
  EXPECT_LT(at(tilted, Vector3d(0.0, -kGravity * tilt, 0.0)).norm(),
            1e-3 * kGravity * tilt * kDuration);
}

}  // namespace
}  // namespace brachium
