#include "problems/position_errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/support/smooth_motion.h"

namespace brachium {
namespace {

using Eigen::Matrix3Xd, Eigen::Vector3d;

const std::vector<double> kTimes = EvenTimes(0.0, 0.005, 4000);

template <typename Function>
Matrix3Xd Path(const Function& f) {
  Matrix3Xd points(3, static_cast<Eigen::Index>(kTimes.size()));
  for (std::size_t i = 0; i < kTimes.size(); ++i)
    points.col(static_cast<Eigen::Index>(i)) = f(kTimes[i]);
  return points;
}

Vector3d Circle(double t) { return {std::cos(t), std::sin(t), 0.75 * t}; }  // 1.25 m/s

TEST(PositionErrors, GiveBackAConstantShift) {
  const Matrix3Xd reference = Path(SmoothPoint);
  const Matrix3Xd estimate = reference.colwise() + Vector3d(0.003, -0.004, 0.012);
  const PositionErrors errors = PositionErrorsOf(estimate, reference);
  EXPECT_NEAR(errors.distance.rmse, 0.013, 1e-12);
  EXPECT_NEAR(errors.horizontal.rmse, 0.005, 1e-12);
  EXPECT_NEAR(errors.horizontal.sd, 0.0, 1e-12);
  EXPECT_NEAR(errors.vertical.value().bias, 0.012, 1e-12);
  EXPECT_NEAR(errors.distance.correlation.value(), 1.0, 1e-12);
}

TEST(PositionErrors, AreHorizontalWhereNoHeightIsKnown) {
  Matrix3Xd reference = Path(SmoothPoint);
  const Matrix3Xd estimate = reference.colwise() + Vector3d(0.003, -0.004, 0.012);
  reference.row(2).setConstant(std::nan(""));
  const PositionErrors errors = PositionErrorsOf(estimate, reference);
  EXPECT_NEAR(errors.distance.rmse, 0.005, 1e-12);
  EXPECT_EQ(errors.distance.used, kTimes.size());
  EXPECT_FALSE(errors.vertical.has_value());
}

TEST(PathLength, IsTheWayInSpaceOrInThePlane) {
  const double seconds = kTimes.back();
  Matrix3Xd path = Path(Circle);
  EXPECT_NEAR(PathLength(SampleTimes(kTimes), path), 1.25 * seconds, 1e-3 * seconds);
  path.row(2).setConstant(std::nan(""));
  EXPECT_NEAR(PathLength(SampleTimes(kTimes), path), seconds, 1e-3 * seconds);
}

TEST(PathLength, AddsLittleOfTheNoise) {
  Matrix3Xd path = Path(Circle);
  const double truth = PathLength(SampleTimes(kTimes), path);
  std::mt19937 random(11);
  std::normal_distribution<double> normal(0.0, 0.002);
  for (double& x : path.reshaped()) x += normal(random);
  EXPECT_NEAR(PathLength(SampleTimes(kTimes), path), truth, 0.01 * truth);
}

TEST(PathLength, LeavesGapsOut) {
  Matrix3Xd path = Path(Circle);
  path.middleCols(1001, 998).setConstant(std::nan(""));  // from 5.0 s to 9.995 s
  const double seconds = kTimes.back() - 4.995;
  EXPECT_NEAR(PathLength(SampleTimes(kTimes), path), 1.25 * seconds, 2e-3 * seconds);

  std::vector<double> times = kTimes;  // three seconds without a row
  for (std::size_t i = 2000; i < times.size(); ++i) times[i] += 3.0;
  Matrix3Xd apart = Path(Circle);
  for (Eigen::Index i = 2000; i < apart.cols(); ++i)
    apart.col(i) = Circle(times[static_cast<std::size_t>(i)]);
  EXPECT_NEAR(PathLength(SampleTimes(times), apart), 1.25 * (kTimes.back() - 0.005), 0.03);
}

TEST(PathLength, IsZeroWithoutPoints) {
  EXPECT_EQ(PathLength(SampleTimes(std::vector<double>{}), Matrix3Xd(3, 0)), 0.0);
  EXPECT_EQ(PathLength(SampleTimes({1.0}), Matrix3Xd::Zero(3, 1)), 0.0);
}

}  // namespace
}  // namespace brachium
