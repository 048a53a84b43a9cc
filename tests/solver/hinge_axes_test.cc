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
constexpr double kCarrying = 12 * kDegree;
const Quaterniond kQ_AU = Exp<double>(Vector3d(0.3, -0.8, 1.1));
const Quaterniond kQ_BF = Exp<double>(Vector3d(-1.0, 0.4, 0.2));

struct Turning {
  double flexion, pronation;  // amplitudes about 70 and 90 deg [rad]
  double adduction = 0.0;     // rms, new every second [rad]
};

std::vector<Matrix3d> Move(const Turning& turning, Side side) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  std::vector<Matrix3d> R_AB;
  double adduction = 0.0;
  for (int i = 0; i < 400; ++i) {
    const double t = i * kPeriod;
    if (i % 10 == 0) adduction = turning.adduction * normal(random);
    const Quaterniond q_UF =
        ElbowRotation({.flexion = 70 * kDegree + turning.flexion * std::sin(2.1 * t),
                       .carrying = kCarrying + adduction,
                       .pronation = 90 * kDegree + turning.pronation * std::sin(1.3 * t + 0.4)},
                      side);
    R_AB.push_back((kQ_AU * q_UF * kQ_BF.conjugate()).toRotationMatrix());
  }
  return R_AB;
}

HingeAnatomy Anatomy(Side side) {
  return {.to_shoulder_A = kQ_AU * Exp<double>(Vector3d(0.1, 0, 0.2)) * Vector3d::UnitY(),
          .to_shoulder_sd = 10 * kDegree,
          .to_elbow_B = kQ_BF * Exp<double>(Vector3d(0.2, 0, 0)) * Vector3d::UnitY(),
          .to_elbow_sd = 20 * kDegree,
          .beta = -Sign(side) * 10 * kDegree,
          .beta_sd = 8 * kDegree};
}

HingeAxes Found(const Turning& turning, Side side) {
  return FindHingeAxes(Move(turning, side), kPeriod, Anatomy(side));
}

double FlexionAxisError(const HingeAxes& axes) {
  return AngleBetween(axes.j1_A, kQ_AU * Vector3d::UnitZ());
}

double PronationAxisError(const HingeAxes& axes) {
  return AngleBetween(axes.j2_B, kQ_BF * Vector3d::UnitY());
}

TEST(HingeAxes, AreFoundWithTheirSignsOnBothSides) {
  for (const Side side : {Side::kRight, Side::kLeft}) {
    const HingeAxes axes = Found({.flexion = 60 * kDegree, .pronation = 70 * kDegree}, side);
    EXPECT_LT(FlexionAxisError(axes), 3 * kDegree) << Name(side);
    EXPECT_LT(PronationAxisError(axes), 3 * kDegree) << Name(side);
    EXPECT_LT(axes.misfit, 0.5 * kDegree);
  }
}

TEST(HingeAxes, StayWithinThreeSdsWhereAdductionWanders) {
  for (const Side side : {Side::kRight, Side::kLeft}) {
    const HingeAxes axes =
        Found({.flexion = 60 * kDegree, .pronation = 70 * kDegree, .adduction = 4 * kDegree}, side);
    EXPECT_LT(FlexionAxisError(axes), 3 * axes.j1_sd);
    EXPECT_LT(PronationAxisError(axes), 3 * axes.j2_sd);
    EXPECT_LT(axes.j1_sd, 10 * kDegree);
    EXPECT_NEAR(axes.misfit, 4 * kDegree, 1.5 * kDegree);
  }
}

TEST(HingeAxes, AreSaidToBeUnknownWithoutTheMovementThatShowsThem) {
  const HingeAxes unturned = Found({.flexion = 60 * kDegree, .pronation = 0.0}, Side::kRight);
  EXPECT_GT(unturned.j2_sd, 15 * kDegree);
  EXPECT_LT(unturned.j1_sd, 12 * kDegree);
  const HingeAxes unbent = Found({.flexion = 0.0, .pronation = 70 * kDegree}, Side::kRight);
  EXPECT_GT(unbent.j1_sd, 12 * kDegree);
}

}  // namespace
}  // namespace brachium
