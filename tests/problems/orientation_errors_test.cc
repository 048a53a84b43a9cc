#include "problems/orientation_errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "problems/rotation.h"
#include "tests/support/smooth_motion.h"

namespace brachium {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;

const std::vector<double> kTimes = EvenTimes(0.0, 0.01, 2000);

// Errors of an estimate that is world_error * truth * body_error.
template <typename WorldError, typename BodyError>
OrientationErrors ErrorsWith(const WorldError& world_error, const BodyError& body_error) {
  std::vector<Quaterniond> estimate, reference;
  std::vector<Vector3d> vertical;
  for (const double t : kTimes) {
    reference.push_back(SmoothRotation(t));
    estimate.push_back(Exp(Vector3d(world_error(t))) * reference.back() *
                       Exp(Vector3d(body_error(t))));
    vertical.push_back(reference.back().conjugate() * Vector3d::UnitZ());
  }
  return OrientationErrorsOf(estimate, reference, vertical);
}

Vector3d None(double) { return Vector3d::Zero(); }

TEST(SplitAbout, PutsTheTwoTurnsBackTogether) {
  const Vector3d axis = Vector3d(1, -2, 3).normalized();
  for (double t = 0.0; t < 10.0; t += 0.1) {
    const Quaterniond q = SmoothRotation(t);
    const SwingTwist split = SplitAbout(q, axis);
    EXPECT_LT(Quaterniond(Exp(Vector3d(split.twist * axis)) * Exp(split.swing)).angularDistance(q),
              1e-7);
    EXPECT_NEAR(split.swing.dot(axis), 0.0, 1e-12);
    EXPECT_LE(std::abs(split.twist), M_PI);
  }
}

TEST(OrientationErrors, GiveBackAConstantTurnInTheBody) {
  const OrientationErrors errors =
      ErrorsWith(None, [](double) { return Vector3d(0.05 * Vector3d(2, -1, 2) / 3.0); });
  EXPECT_NEAR(errors.rotation.rmse, 0.05, 1e-9);
  EXPECT_NEAR(errors.rotation.bias, 0.05, 1e-9);
  EXPECT_NEAR(errors.rotation.sd, 0.0, 1e-9);
  EXPECT_NEAR(errors.rotation.max, 0.05, 1e-9);
  EXPECT_EQ(errors.rotation.used, kTimes.size());
  EXPECT_GT(errors.rotation.correlation.value(), 0.99);
}

TEST(OrientationErrors, CallATurnAboutTheVerticalHeading) {
  const OrientationErrors errors =
      ErrorsWith([](double t) { return Vector3d(0, 0, 0.02 * t - 0.1); }, None);
  EXPECT_NEAR(errors.inclination.max, 0.0, 1e-7);
  EXPECT_NEAR(errors.heading.bias, 0.02 * 0.5 * (kTimes.front() + kTimes.back()) - 0.1, 1e-9);
  EXPECT_NEAR(errors.heading.max, 0.02 * kTimes.back() - 0.1, 1e-9);
  EXPECT_NEAR(errors.rotation.rmse, errors.heading.rmse, 1e-9);
}

TEST(OrientationErrors, CallATurnAboutTheHorizonInclination) {
  const OrientationErrors errors = ErrorsWith(
      [](double t) { return Vector3d(0.03 * std::cos(t), 0.03 * std::sin(t), 0); }, None);
  EXPECT_NEAR(errors.inclination.rmse, 0.03, 1e-9);
  EXPECT_NEAR(errors.heading.max, 0.0, 1e-9);
}

TEST(OrientationErrors, GiveBackTheSpreadOfNoise) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal(0.0, 0.01);
  const OrientationErrors errors = ErrorsWith(
      None, [&](double) { return Vector3d(normal(random), normal(random), normal(random)); });
  EXPECT_NEAR(errors.rotation.rmse, 0.01 * std::sqrt(3.0), 3e-4);
  EXPECT_NEAR(errors.inclination.rmse, 0.01 * std::sqrt(2.0), 3e-4);
  EXPECT_NEAR(errors.heading.sd, 0.01, 3e-4);
  EXPECT_LT(errors.rotation.bias, 1e-3);
}

TEST(OrientationErrors, TakeTheShortWayRoundWhateverTheSignOfAQuaternion) {
  const Quaterniond q = Exp(Vector3d(0.1, 0.2, 3.0));
  const Quaterniond same(Eigen::Vector4d(-q.coeffs()));
  EXPECT_NEAR(OrientationErrorsOf({same}, {q}, {Vector3d::UnitZ()}).rotation.max, 0.0, 1e-12);
  EXPECT_NEAR(OrientationErrorsOf({same}, {q}, {Vector3d::UnitZ()}).heading.max, 0.0, 1e-12);
}

}  // namespace
}  // namespace brachium
