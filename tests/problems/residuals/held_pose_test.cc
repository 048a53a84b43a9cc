#include "problems/residuals/held_pose.h"

#include <gtest/gtest.h>

#include "problems/arm_model.h"
#include "problems/joint_angles.h"
#include "tests/support/jacobian_check.h"

namespace brachium {
namespace {

using Eigen::AngleAxisd, Eigen::Quaterniond, Eigen::Vector3d;

constexpr Side kSides[] = {Side::kRight, Side::kLeft};
constexpr double kSigma = 10 * kDegree;

double Elbow(ElbowAngle angle, Side side, double told, const ElbowAngles& pose) {
  std::mt19937 random(1);
  const Quaterniond q_WU = RandomRotation(random);
  return ResidualAt(ElbowHeldPose(angle, side, told, kSigma),
                    {q_WU.coeffs(), (q_WU * ElbowRotation(pose, side)).coeffs()})[0];
}

// An upper arm raised by this angle from hanging, in some plane and at some heading.
Quaterniond Raised(double elevation, double heading, double twist) {
  return AngleAxisd(heading, Vector3d::UnitZ()) *
         AngleAxisd(90 * kDegree + elevation, Vector3d::UnitX()) *
         AngleAxisd(twist, Vector3d::UnitY());
}

double Elevation(double told, const Quaterniond& q_WU) {
  return ResidualAt(ElevationHeldPose(told, kSigma), {q_WU.coeffs()})[0];
}

TEST(ElbowHeldPose, IsZeroAtTheToldAngleAndOneAtOneSigmaOnBothSides) {
  for (const Side side : kSides)
    for (const double told : {0.0, 0.6, 1.5}) {
      EXPECT_NEAR(Elbow(ElbowAngle::kFlexion, side, told, {told, 0.2, 1.0}), 0.0, 1e-12);
      EXPECT_NEAR(Elbow(ElbowAngle::kPronation, side, told, {0.4, 0.2, told}), 0.0, 1e-12);
      EXPECT_NEAR(Elbow(ElbowAngle::kFlexion, side, told, {told + kSigma, 0.2, 1.0}), 1.0, 1e-12);
      EXPECT_NEAR(Elbow(ElbowAngle::kPronation, side, told, {0.4, 0.2, told + kSigma}), 1.0, 1e-12);
    }
}

TEST(ElbowHeldPose, TakesTheShorterWayAround) {
  for (const Side side : kSides) {
    EXPECT_NEAR(Elbow(ElbowAngle::kPronation, side, 175 * kDegree, {0.4, 0.1, -175 * kDegree}), 1.0,
                1e-12);
    EXPECT_NEAR(Elbow(ElbowAngle::kFlexion, side, 175 * kDegree, {-175 * kDegree, 0.1, 0.4}), 1.0,
                1e-12);
  }
}

TEST(ElbowHeldPose, IsBlindToTheCommonHeading) {
  std::mt19937 random(1);
  const ElbowHeldPose residual(ElbowAngle::kPronation, Side::kLeft, 1.5, kSigma);
  const BlockValues x = RandomValues(ElbowHeldPose::Blocks(), random);
  const Quaterniond q_VW(AngleAxisd(0.8, Vector3d::UnitZ()));
  EXPECT_NEAR(ResidualAt(residual, TurnedWorld(q_VW, x, {false, false}))[0],
              ResidualAt(residual, x)[0], 1e-10);
}

// A hanging forearm that turns about the vertical pronates: what ties the two headings together.
TEST(ElbowHeldPose, SeesTheRelativeHeadingOfAStraightHangingArm) {
  const Quaterniond hanging = Raised(0.0, 0.0, 0.0);
  for (const Side side : kSides) {
    const Quaterniond q_WF = AngleAxisd(Sign(side) * kSigma, Vector3d::UnitZ()) * hanging;
    EXPECT_NEAR(ResidualAt(ElbowHeldPose(ElbowAngle::kPronation, side, 0.0, kSigma),
                           {hanging.coeffs(), q_WF.coeffs()})[0],
                1.0, 1e-12);
  }
}

TEST(ElbowHeldPose, DerivativesAgree) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> angle(-1.4, 2.4), carrying(-1.2, 1.2);
  for (const ElbowAngle kind : {ElbowAngle::kFlexion, ElbowAngle::kPronation})
    for (const Side side : kSides)
      for (int i = 0; i < 50; ++i) {
        const Quaterniond q_WU = RandomRotation(random);
        const Quaterniond q_UF =
            ElbowRotation({angle(random), carrying(random), angle(random)}, side);
        EXPECT_TRUE(DerivativesAgree(ElbowHeldPose(kind, side, 0.5, kSigma),
                                     {q_WU.coeffs(), (q_WU * q_UF).coeffs()}, 1e-7));
      }
}

TEST(ElevationHeldPose, IsZeroAtTheToldElevation) {
  for (const double told : {0.0, 0.5, 90 * kDegree, 2.5})
    EXPECT_NEAR(Elevation(told, Raised(told, 1.0, 0.3)), 0.0, 1e-12);
}

TEST(ElevationHeldPose, IsAboutOneAtOneSigmaAwayFromHanging) {
  for (const double told : {60 * kDegree, 90 * kDegree, 120 * kDegree}) {
    EXPECT_NEAR(Elevation(told, Raised(told + kSigma, 1.0, 0.3)), 1.0, 0.06);
    EXPECT_NEAR(Elevation(told, Raised(told - kSigma, 1.0, 0.3)), -1.0, 0.06);
  }
}

// The cosine is flat at the pole: half a sigma's worth at one sigma, full strength at twice that.
TEST(ElevationHeldPose, IsSoftAboutHangingButHoldsBeyondTwoSigma) {
  EXPECT_NEAR(Elevation(0.0, Raised(kSigma, 1.0, 0.3)), 0.5, 0.01);
  EXPECT_NEAR(Elevation(0.0, Raised(2 * kSigma, 1.0, 0.3)), 2.0, 0.05);
}

TEST(ElevationHeldPose, IsBlindToHeadingAndToATurnAboutTheArm) {
  EXPECT_NEAR(Elevation(0.5, Raised(1.0, 0.0, 0.0)), Elevation(0.5, Raised(1.0, 2.0, -1.3)), 1e-12);
}

TEST(ElevationHeldPose, DerivativesAgreeAlsoAtThePole) {
  EXPECT_TRUE(DerivativesAgreeAtRandomPoints(ElevationHeldPose(0.5, kSigma)));
  EXPECT_TRUE(DerivativesAgreeAtRandomPoints(ElevationHeldPose(0.0, kSigma)));
  EXPECT_TRUE(DerivativesAgree(ElevationHeldPose(0.0, kSigma), {Raised(0.0, 0.3, 0.2).coeffs()}));
}

TEST(FacingHeldPose, IsTheTurnOfTheArmOutOfTheBodysHeadingHoweverBothAreTilted) {
  const FacingHeldPose residual(kSigma);
  for (const double tilt : {0.0, 0.3})
    for (const double turn : {-kSigma, 0.0, 2 * kSigma}) {
      const Quaterniond q_WG = Raised(0.0, 3.0, 0.0) * AngleAxisd(tilt, Vector3d::UnitX());
      const Quaterniond q_WU = AngleAxisd(turn, Vector3d::UnitZ()) * Raised(0.0, 3.0, 0.0);
      EXPECT_NEAR(ResidualAt(residual, {q_WG.coeffs(), q_WU.coeffs()})[0], turn / kSigma, 1e-12);
    }
}

TEST(FacingHeldPose, IsBlindToTheCommonHeading) {
  std::mt19937 random(1);
  const FacingHeldPose residual(kSigma);
  const BlockValues x = RandomValues(FacingHeldPose::Blocks(), random);
  const Quaterniond q_VW(AngleAxisd(0.8, Vector3d::UnitZ()));
  EXPECT_NEAR(ResidualAt(residual, TurnedWorld(q_VW, x, {false, false}))[0],
              ResidualAt(residual, x)[0], 1e-10);
}

TEST(FacingHeldPose, DerivativesAgreeWhereNoFrontIsUpright) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> heading(-3.0, 3.0), tilt(-1.0, 1.0);
  const auto pose = [&] { return Raised(tilt(random), heading(random), tilt(random)).coeffs(); };
  for (int i = 0; i < 50; ++i)
    EXPECT_TRUE(DerivativesAgree(FacingHeldPose(kSigma), {pose(), pose()}));
}

}  // namespace
}  // namespace brachium
