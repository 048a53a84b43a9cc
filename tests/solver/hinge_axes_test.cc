#include "solver/hinge_axes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "problems/joint_angles.h"
#include "problems/rotation.h"
#include "solver/calibration_movement.h"

namespace brachium {
namespace {

using Eigen::Matrix3d, Eigen::Quaterniond, Eigen::Vector3d;

constexpr double kPeriod = 0.1;  // [s]
const Quaterniond kQ_AU = Exp<double>(Vector3d(0.3, -0.8, 1.1));
const Quaterniond kQ_BF = Exp<double>(Vector3d(-1.0, 0.4, 0.2));

struct Turning {
  double flexion = 55 * kDegree, pronation = 60 * kDegree;  // amplitudes about 70 and 90 deg [rad]
  double carrying = 12 * kDegree;
  double slope = 0.0;      // of carrying over cos(flexion) [rad]
  double adduction = 0.0;  // rms, new every second [rad]
  double skin = 0.0;       // about the upper arm's long axis, the same
  int instants = 400;
  unsigned seed = 5;
};

Quaterniond Elbow(double flexion, double carrying, double pronation, Side side) {
  return ElbowRotation({.flexion = flexion, .carrying = carrying, .pronation = pronation}, side);
}

std::vector<Matrix3d> Move(const Turning& turning, Side side) {
  std::mt19937 random(turning.seed);
  std::normal_distribution<double> normal;
  std::vector<Matrix3d> R_AB;
  double adduction = 0.0, skin = 0.0;
  for (int i = 0; i < turning.instants; ++i) {
    const double t = i * kPeriod;
    if (i % 10 == 0) {
      adduction = turning.adduction * normal(random);
      skin = turning.skin * normal(random);
    }
    const double flexion = 70 * kDegree + turning.flexion * std::sin(2.1 * t);
    const double pronation = 90 * kDegree + turning.pronation * std::sin(1.3 * t + 0.4);
    const double carrying = turning.carrying + turning.slope * std::cos(flexion) + adduction;
    const Quaterniond q_SU = Exp<double>(skin * Vector3d::UnitY());
    const Quaterniond q_UF = Elbow(flexion, carrying, pronation, side);
    R_AB.push_back((kQ_AU * q_SU * q_UF * kQ_BF.conjugate()).toRotationMatrix());
  }
  return R_AB;
}

// Directions off by 6 deg to the shoulder and by 11 deg to the elbow, as acceleration shows them.
HingeAnatomy Anatomy(Side side) {
  return {.side = side,
          .to_shoulder_A = kQ_AU * Exp<double>(Vector3d(0.1, 0, 0.2)) * Vector3d::UnitY(),
          .to_shoulder_sd = 6 * kDegree,
          .to_elbow_B = kQ_BF * Exp<double>(Vector3d(0.2, 0, 0)) * Vector3d::UnitY(),
          .to_elbow_sd = 20 * kDegree,
          .elbow = {}};
}

HingeAxes Found(const Turning& turning, Side side) {
  return FindHingeAxes(Move(turning, side), Anatomy(side));
}

const Vector3d kTrueJ1 = kQ_AU * Vector3d::UnitZ();
const Vector3d kTrueJ2 = kQ_BF * Vector3d::UnitY();

double LongestSd(const Matrix3d& covariance) { return std::sqrt(covariance.trace()); }

// Squared error over its covariance, mean over the two directions.
double Normalised(const Vector3d& found, const Vector3d& truth, const Matrix3d& covariance) {
  const Vector3d a = found.unitOrthogonal();
  Eigen::Matrix<double, 3, 2> across;
  across << a, found.cross(a);
  const Eigen::Vector2d error = across.transpose() * (found - truth);
  const Eigen::Matrix2d P = across.transpose() * covariance * across;
  return error.dot(P.ldlt().solve(error)) / 2;
}

// How far j1 is turned about the upper arm's long axis; the tilt along it looks like a carrying angle
// that changes, and is shared out between the two.
double ErrorAboutLongAxis(const HingeAxes& axes) {
  return std::abs(axes.j1_A.dot(kQ_AU * Vector3d::UnitX()));
}

TEST(HingeAxes, AreFoundWithTheirSignsOnBothSides) {
  for (const Side side : {Side::kRight, Side::kLeft}) {
    const HingeAxes axes = Found({}, side);
    EXPECT_LT(ErrorAboutLongAxis(axes), 1 * kDegree) << Name(side);
    EXPECT_LT(AngleBetween(axes.j1_A, kTrueJ1), 3 * kDegree) << Name(side);
    EXPECT_LT(AngleBetween(axes.j2_B, kTrueJ2), 1 * kDegree) << Name(side);
    EXPECT_LT(axes.misfit, 0.2 * kDegree);
  }
}

TEST(HingeAxes, AreNotDrawnToWhereTurningSkinShowsLeast) {
  constexpr int kTrials = 6;
  double error = 0.0;
  for (unsigned seed = 0; seed < kTrials; ++seed) {
    const HingeAxes axes =
        Found({.adduction = 3 * kDegree, .skin = 10 * kDegree, .instants = 1000, .seed = seed},
              Side::kRight);
    error += axes.j1_A.dot(kQ_AU * Vector3d::UnitX()) / kTrials;
  }
  EXPECT_LT(std::abs(error), 1.5 * kDegree);
}

TEST(HingeAxes, ErrByAsMuchAsTheirCovarianceSays) {
  double j1 = 0.0, j2 = 0.0;
  constexpr int kTrials = 30;
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (unsigned seed = 0; seed < kTrials; ++seed) {
    const Side side = seed % 2 == 0 ? Side::kRight : Side::kLeft;
    const HingeAxes axes = Found({.carrying = (10 + 8 * normal(random)) * kDegree,
                                  .slope = 5 * normal(random) * kDegree,
                                  .adduction = 5 * kDegree,
                                  .seed = seed},
                                 side);
    j1 += Normalised(axes.j1_A, kTrueJ1, axes.j1_covariance) / kTrials;
    j2 += Normalised(axes.j2_B, kTrueJ2, axes.j2_covariance) / kTrials;
  }
  EXPECT_NEAR(std::sqrt(j1), 1.0, 0.3);
  EXPECT_NEAR(std::sqrt(j2), 1.0, 0.3);
}

TEST(HingeAxes, AreSaidToBeUnknownWithoutTheMovementThatShowsThem) {
  EXPECT_GT(LongestSd(Found({.pronation = 0.0}, Side::kRight).j2_covariance), 10 * kDegree);
  EXPECT_GT(LongestSd(Found({.flexion = 0.0}, Side::kRight).j1_covariance), 10 * kDegree);
}

TEST(HingeAxes, CountARestOnce) {
  const std::vector<Matrix3d> moving = Move({.adduction = 4 * kDegree}, Side::kRight);
  std::vector<Matrix3d> resting = moving;
  resting.insert(resting.begin() + 137, 3000, moving[137]);
  EXPECT_EQ(FindHingeAxes(resting, Anatomy(Side::kRight)).j1_A,
            FindHingeAxes(moving, Anatomy(Side::kRight)).j1_A);
}

}  // namespace
}  // namespace brachium
