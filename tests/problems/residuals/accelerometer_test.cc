#include "problems/residuals/accelerometer.h"

#include <gtest/gtest.h>

#include "tests/support/jacobian_check.h"
#include "tests/support/moving_sensor.h"
#include "tests/support/smooth_motion.h"

namespace brachium {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d, Eigen::VectorXd;

constexpr double kStart = 0.2, kEnd = 0.3, kDuration = kEnd - kStart, kAlpha = 0.3;
const Mounting kMounting{.q_BS = Exp<double>(Vector3d(0.4, -1.0, 0.7)),
                         .p_BS_B = Vector3d(0.03, -0.15, 0.02)};

// Errors of the sensor, as the unknowns have them.
struct SensorFaults {
  Vector3d b_j = Vector3d::Zero(), b_j1 = Vector3d::Zero();
  Vector3d accel_bias = Vector3d::Zero(), accel_scale = Vector3d::Zero();
};

// A chain of swaying segments; the last one wears the sensor.
template <int kChain>
struct Example {
  BlockValues x;
  Preintegrated interval;

  static Vector3d Joint(int i) { return {0.02 * i, -0.3 + 0.03 * i, 0.01}; }

  // The segments' motions at t, each hanging from the one before.
  static std::vector<BodyMotion> Bodies(double t) {
    std::vector<BodyMotion> bodies;
    for (int i = 0; i < kChain; ++i) {
      bodies.push_back(SwayingBody(t, 0.3 + 0.8 * i));
      if (i > 0) bodies[U(i)].joint_W = PointOn(bodies[U(i) - 1], {.p = Joint(i - 1)});
    }
    return bodies;
  }

  explicit Example(const SensorFaults& faults = {}) {
    const MovingSensor sensor = [](double t) { return SensorOn(Bodies(t).back(), kMounting); };
    Recording recording = Recorded(sensor, EvenTimes(0.0005, 0.001, 500));
    for (Vector3d& gyr : recording.gyr_S) gyr += (1 - kAlpha) * faults.b_j + kAlpha * faults.b_j1;
    for (Vector3d& acc : recording.acc_S)
      acc = (acc + faults.accel_bias).cwiseQuotient(Vector3d::Ones() - faults.accel_scale);
    interval = Preintegrator(recording).Sum(kStart, kEnd, Vector3d::Zero());

    for (const double t : {kStart, kEnd})
      for (const BodyMotion& body : Bodies(t)) x.push_back(body.turning.q_AB.coeffs());
    for (const double t : {kStart, kEnd}) x.push_back(Bodies(t)[0].joint_W.p);
    for (const double t : {kStart, kEnd}) x.push_back(sensor(t).v_W);
    x.insert(x.end(),
             {faults.b_j, faults.b_j1, faults.accel_bias, faults.accel_scale, kMounting.p_BS_B});
    for (int i = 0; i + 1 < kChain; ++i) x.push_back(Joint(i));
  }

  Accelerometer<kChain> Residual(const Whitening2& whitening = {}) const {
    return {interval, kMounting.q_BS, kAlpha, whitening};
  }

  static std::size_t U(int i) { return static_cast<std::size_t>(i); }
  static constexpr std::size_t kRoot = 2 * kChain, kVelocity = kRoot + 2, kAccelBias = kRoot + 6,
                               kSensor = kRoot + 8;
};

template <typename Length>
class AccelerometerOfChain : public ::testing::Test {};

using Lengths = ::testing::Types<std::integral_constant<int, 1>, std::integral_constant<int, 2>,
                                 std::integral_constant<int, 3>, std::integral_constant<int, 4>>;
TYPED_TEST_SUITE(AccelerometerOfChain, Lengths);

// Unwhitened: m/s and m.
TYPED_TEST(AccelerometerOfChain, IsZeroWhereTheChainMovesAsTheForcesSay) {
  const Example<TypeParam::value> example;
  EXPECT_LT(ResidualAt(example.Residual(), example.x).norm(), 1e-6);
}

TYPED_TEST(AccelerometerOfChain, TakesOffBiasesAndScaleErrorsOfTheSensor) {
  const Example<TypeParam::value> example({.b_j = Vector3d(1e-3, -2e-3, 1e-3),
                                           .b_j1 = Vector3d(-1e-3, 0.0, 3e-3),
                                           .accel_bias = Vector3d(0.05, -0.03, 0.1),
                                           .accel_scale = Vector3d(0.01, -0.02, 0.005)});
  EXPECT_LT(ResidualAt(example.Residual(), example.x).norm(), 2e-6);
}

TYPED_TEST(AccelerometerOfChain, IsBlindToHeadingToThePlaceAndToASteadyVelocityOfTheWhole) {
  const Example<TypeParam::value> example;
  std::mt19937 random(1);
  BlockValues x = RandomValues(typename Accelerometer<TypeParam::value>::Blocks(), random);
  const VectorXd r = ResidualAt(example.Residual(), x);
  std::vector<bool> is_world(x.size(), false);
  for (std::size_t i = example.kRoot; i < example.kRoot + 4; ++i) is_world[i] = true;
  const Quaterniond q_VW(Eigen::AngleAxisd(0.9, Vector3d::UnitZ()));
  x = TurnedWorld(q_VW, x, is_world);
  const Vector3d shift(3.0, -2.0, 1.0), wind(0.5, 0.2, -0.3);
  x[example.kRoot] += shift;
  x[example.kRoot + 1] += shift + kDuration * wind;
  x[example.kVelocity] += wind;
  x[example.kVelocity + 1] += wind;
  EXPECT_LT((ResidualAt(example.Residual(), x) - r).norm(), 1e-12);
}

TYPED_TEST(AccelerometerOfChain, CannotSeeLeverArmsWhileTheSegmentsKeepTheirAttitudes) {
  constexpr int kChain = TypeParam::value;
  const Example<kChain> example;
  BlockValues x = example.x;
  for (std::size_t i = 0; i < kChain; ++i) x[kChain + i] = x[i];
  const VectorXd r = ResidualAt(example.Residual(), x);
  for (std::size_t i = example.kSensor; i < x.size(); ++i) x[i] += Vector3d(0.1, -0.2, 0.3);
  EXPECT_LT((ResidualAt(example.Residual(), x) - r).norm(), 1e-12);
}

TYPED_TEST(AccelerometerOfChain, DerivativesAgree) {
  const auto white = WhiteAccelerationCovariance(1.0, 0.5);
  Example<TypeParam::value> example;
  std::mt19937 random(1);
  for (Eigen::Matrix3d* block : {&example.interval.dv_dbg, &example.interval.dp_dbg})
    for (int i = 0; i < 3; ++i) block->col(i) = RandomVector(3, random);
  EXPECT_TRUE(DerivativesAgreeAtRandomPoints(example.Residual(Whitening2::FromCovariance(white))));
  EXPECT_TRUE(DerivativesAgree(example.Residual(), example.x));
}

TEST(Accelerometer, IsOneWhenVelocityAndPlaceAreOffByOneSigmaOfWhiteAcceleration) {
  const double density = 0.01;
  Example<2> example;
  const auto whitening =
      Whitening2::FromCovariance(WhiteAccelerationCovariance(density, kDuration));
  const Vector3d off = std::sqrt(density * kDuration) * Vector3d::UnitY();
  example.x[example.kVelocity + 1] += off;
  example.x[example.kRoot + 1] += kDuration / 2 * off;  // what goes along with it
  EXPECT_NEAR(ResidualAt(example.Residual(whitening), example.x).norm(), 1.0, 1e-3);
}

TEST(Accelerometer, CannotTellTiltFromBiasWhileTheSegmentsKeepTheirAttitudes) {
  const double tilt = 1e-4;
  Preintegrated rest;
  rest.duration = kDuration;
  rest.dv = kGravity * kDuration * Vector3d::UnitZ();
  rest.dp = kGravity * kDuration * kDuration / 2 * Vector3d::UnitZ();
  rest.dv_dba = -kDuration * Eigen::Matrix3d::Identity();
  rest.dp_dba = -kDuration * kDuration / 2 * Eigen::Matrix3d::Identity();
  const Accelerometer<1> residual(rest, Quaterniond::Identity(), 0.5, {});
  const Vector3d zero = Vector3d::Zero();
  const Quaterniond upright = Quaterniond::Identity(), tilted = Exp<double>({tilt, 0.0, 0.0});
  const auto at = [&](const Quaterniond& q, const Vector3d& bias) {
    return ResidualAt(residual, {q.coeffs(), q.coeffs(), zero, zero, zero, zero, zero, zero, bias,
                                 zero, Vector3d(0.1, 0.2, 0.3)});
  };
  EXPECT_LT(at(upright, zero).norm(), 1e-12);
  EXPECT_GT(at(tilted, zero).norm(), 0.9 * kGravity * tilt * kDuration);
  EXPECT_LT(at(tilted, Vector3d(0.0, -kGravity * tilt, 0.0)).norm(),
            1e-3 * kGravity * tilt * kDuration);
}

}  // namespace
}  // namespace brachium
