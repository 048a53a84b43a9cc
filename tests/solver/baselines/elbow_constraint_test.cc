#include "solver/baselines/elbow_constraint.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "problems/joint_angles.h"
#include "problems/rotation.h"
#include "tests/support/smooth_motion.h"

namespace brachium {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;
using Row6 = Eigen::Matrix<double, 1, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

constexpr double kDeg = std::numbers::pi / 180;

// Upper arm hanging, elbow bent by 90 deg: n is vertical.
const Quaterniond kHanging(Eigen::AngleAxisd(std::numbers::pi / 2, Vector3d::UnitX()));
const Quaterniond kBent(Eigen::AngleAxisd(std::numbers::pi / 2, Vector3d::UnitZ()));

Quaterniond TurnedAboutVertical(double angle, const Quaterniond& q) {
  return Quaterniond(Eigen::AngleAxisd(angle, Vector3d::UnitZ())) * q;
}

TEST(ElbowConstraint, GivesTheSineOfTheAdductionWithItsOwnSignNotThePrintedOne) {
  for (const double adduction : {-20 * kDeg, 5 * kDeg, 30 * kDeg}) {
    const ElbowAngles angles{.flexion = 1.1, .carrying = -adduction, .pronation = 0.6};
    const Quaterniond q_WU = SmoothRotation(0.3), q_WF = q_WU * ElbowRotation(angles, Side::kRight);
    const double sine = PredictAdduction(q_WF, q_WU).sine;
    EXPECT_NEAR(sine, std::sin(adduction), 1e-12);
    EXPECT_NEAR(std::acos(sine) - std::numbers::pi / 2, -adduction, 1e-12);  // (6) as printed
  }
}

TEST(ElbowConstraint, TellsHowTheAdductionChangesFromTheEstimateToTheTruth) {
  const Quaterniond q_WF = SmoothRotation(0.3), q_WU = SmoothRotation(1.7, 0.5);
  const PredictedAdduction predicted = PredictAdduction(q_WF, q_WU);
  for (int i = 0; i < 6; ++i) {
    const Vector6 theta = 1e-6 * Vector6::Unit(i);
    const double truth =
        PredictAdduction(Exp<double>(theta.head<3>()) * q_WF, Exp<double>(theta.tail<3>()) * q_WU)
            .sine;
    EXPECT_NEAR((predicted.sine - truth) / 1e-6, (predicted.H_W * theta)(0) / 1e-6, 1e-5) << i;
  }
}

struct Headings {
  double relative = 0.0, common = 0.0;  // [rad]
};

// Starts 15 deg wrong in the relative heading and updates 3000 times by the paper's (10), (11).
Headings AfterUpdates(bool as_printed, double sigma_F, double sigma_U) {
  Quaterniond q_WF = TurnedAboutVertical(15 * kDeg, kHanging * kBent), q_WU = kHanging;
  Matrix6 Q = Matrix6::Zero();
  Q.topLeftCorner<3, 3>().diagonal().setConstant(sigma_F * sigma_F);
  Q.bottomRightCorner<3, 3>().diagonal().setConstant(sigma_U * sigma_U);
  const double R = 10 * kDeg * 10 * kDeg;
  for (int i = 0; i < 3000; ++i) {
    const PredictedAdduction predicted = PredictAdduction(q_WF, q_WU);
    Row6 H = predicted.H_W;
    if (as_printed) H.tail<3>() *= -1;
    const Vector6 K = Q * H.transpose() / ((H * Q * H.transpose())(0) + R);
    const Vector6 theta = K * predicted.sine;
    Q -= K * H * Q;
    q_WF = Exp<double>(theta.head<3>()) * q_WF;
    q_WU = Exp<double>(theta.tail<3>()) * q_WU;
  }
  const double fore = Log<double>(q_WF * (kHanging * kBent).conjugate()).z();
  const double upper = Log<double>(q_WU * kHanging.conjugate()).z();
  return {fore - upper, upper};
}

TEST(ElbowConstraint, TakesARelativeHeadingErrorAwayWhichThePrintedMatrixKeeps) {
  const Headings printed = AfterUpdates(true, 3 * kDeg, 3 * kDeg);
  EXPECT_NEAR(printed.relative, 15 * kDeg, 0.1 * kDeg);
  EXPECT_GT(std::abs(printed.common), 15 * kDeg);  // and it spins
  const Headings corrected = AfterUpdates(false, 3 * kDeg, 3 * kDeg);
  EXPECT_LT(std::abs(corrected.relative), 1.5 * kDeg);
  EXPECT_LT(std::abs(corrected.common), 8 * kDeg);
}

TEST(ElbowConstraint, CorrectsTheSegmentThatTheCovariancesInTheStatesOrderCallUncertain) {
  EXPECT_NEAR(AfterUpdates(false, 3 * kDeg, 0.01 * kDeg).common, 0.0, 0.01 * kDeg);
  EXPECT_NEAR(AfterUpdates(false, 0.01 * kDeg, 3 * kDeg).common, 15 * kDeg, 1.5 * kDeg);
}

TEST(ElbowConstraint, SeesNoHeadingOfAStraightHangingArm) {
  const PredictedAdduction predicted = PredictAdduction(kHanging, kHanging);
  EXPECT_NEAR(predicted.H_W[2], 0.0, 1e-12);
  EXPECT_NEAR(predicted.H_W[5], 0.0, 1e-12);
}

}  // namespace
}  // namespace brachium
