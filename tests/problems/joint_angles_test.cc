#include "problems/joint_angles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "problems/arm_model.h"

namespace brachium {
namespace {

using Eigen::AngleAxisd, Eigen::Matrix3d, Eigen::Quaterniond, Eigen::Vector3d;

constexpr Side kSides[] = {Side::kRight, Side::kLeft};

Quaterniond RandomRotation(std::mt19937& random) {
  std::normal_distribution<double> normal;
  Eigen::Vector4d v;
  for (double& component : v) component = normal(random);
  return Quaterniond(v.normalized());
}

// The segment whose axes are these, in the axes of its parent.
Quaterniond WithAxes(const Vector3d& x, const Vector3d& y) {
  Matrix3d R;
  R << x, y, x.cross(y);
  return Quaterniond(R);
}

const Vector3d kX = Vector3d::UnitX(), kY = Vector3d::UnitY(), kZ = Vector3d::UnitZ();

TEST(ElbowAngles, SurviveTheRoundTripOnBothSides) {
  for (const Side side : kSides)
    for (double flexion = -0.3; flexion < 2.8; flexion += 0.37)
      for (double carrying = -0.5; carrying < 0.6; carrying += 0.11)
        for (double pronation = -0.4; pronation < 3.1; pronation += 0.41) {
          const ElbowAngles angles =
              ElbowAnglesFrom(ElbowRotation({flexion, carrying, pronation}, side), side);
          EXPECT_NEAR(angles.flexion, flexion, 1e-12);
          EXPECT_NEAR(angles.carrying, carrying, 1e-12);
          EXPECT_NEAR(angles.pronation, pronation, 1e-12);
        }
}

TEST(ElbowAngles, AreZeroWhenTheArmIsStraightAndThePalmFacesForward) {
  for (const Side side : kSides) {
    const ElbowAngles angles = ElbowAnglesFrom(Quaterniond::Identity(), side);
    EXPECT_EQ(angles.flexion, 0.0);
    EXPECT_EQ(angles.carrying, 0.0);
    EXPECT_EQ(angles.pronation, 0.0);
  }
}

TEST(ElbowAngles, SayNinetyDegreesOfPronationWhenTheThumbOfAHangingArmPointsForward) {
  for (const Side side : kSides) {
    const Vector3d medial = -Sign(side) * kZ;  // where the palm then faces
    const ElbowAngles angles = ElbowAnglesFrom(WithAxes(medial, kY), side);
    EXPECT_NEAR(angles.pronation, 90 * kDegree, 1e-12);
    EXPECT_NEAR(angles.flexion, 0.0, 1e-12);
  }
}

TEST(ElbowAngles, SayFlexionWhenTheForearmPointsForward) {
  for (const Side side : kSides)  // the palm faces up
    EXPECT_NEAR(ElbowAnglesFrom(WithAxes(kY, -kX), side).flexion, 90 * kDegree, 1e-12);
}

TEST(ElbowAngles, SayPositiveCarryingWhenTheForearmDeviatesFromTheBody) {
  for (const Side side : kSides) {
    const Vector3d lateral = Sign(side) * kZ;
    const Vector3d distal = -std::cos(0.2) * kY + std::sin(0.2) * lateral;
    EXPECT_NEAR(ElbowAnglesFrom(WithAxes(kX, -distal), side).carrying, 0.2, 1e-12);
  }
}

TEST(ElbowAngles, StayFiniteAndDescribeTheRotationWhereFlexionAndPronationShareAnAxis) {
  for (const Side side : kSides)
    for (const double carrying : {-90.0, 90.0})
      for (const double off : {0.0, 1e-12, 1e-9, 1e-6, 1e-3}) {
        const Quaterniond q_UF = ElbowRotation({0.7, carrying * kDegree - off, 0.4}, side);
        const ElbowAngles angles = ElbowAnglesFrom(q_UF, side);
        EXPECT_LT(ElbowRotation(angles, side).angularDistance(q_UF), 1e-7);
      }
}

TEST(ElbowAngles, StayFiniteForAnyRotation) {
  std::mt19937 random(1);
  for (int i = 0; i < 1000; ++i) {
    const Quaterniond q_UF = RandomRotation(random);
    for (const Side side : kSides)
      EXPECT_LT(ElbowRotation(ElbowAnglesFrom(q_UF, side), side).angularDistance(q_UF), 1e-7);
  }
}

TEST(JointAngles, AreTheSameForTheMirroredArm) {
  std::mt19937 random(2);
  for (int i = 0; i < 1000; ++i) {
    const Quaterniond q = RandomRotation(random), q_mirror = Mirrored(q);
    const ElbowAngles elbow = ElbowAnglesFrom(q, Side::kRight);
    const ElbowAngles left_elbow = ElbowAnglesFrom(q_mirror, Side::kLeft);
    EXPECT_NEAR(elbow.flexion, left_elbow.flexion, 1e-12);
    EXPECT_NEAR(elbow.carrying, left_elbow.carrying, 1e-12);
    EXPECT_NEAR(elbow.pronation, left_elbow.pronation, 1e-12);
    const ShoulderAngles shoulder = ShoulderAnglesFrom(q, Side::kRight);
    const ShoulderAngles left_shoulder = ShoulderAnglesFrom(q_mirror, Side::kLeft);
    EXPECT_EQ(shoulder.plane.has_value(), left_shoulder.plane.has_value());
    EXPECT_NEAR(shoulder.plane.value_or(0), left_shoulder.plane.value_or(0), 1e-12);
    EXPECT_NEAR(shoulder.elevation, left_shoulder.elevation, 1e-12);
    EXPECT_NEAR(shoulder.rotation.value_or(0), left_shoulder.rotation.value_or(0), 1e-12);
    const WristAngles wrist = WristAnglesFrom(q, Side::kRight);
    const WristAngles left_wrist = WristAnglesFrom(q_mirror, Side::kLeft);
    EXPECT_NEAR(wrist.flexion, left_wrist.flexion, 1e-12);
    EXPECT_NEAR(wrist.deviation, left_wrist.deviation, 1e-12);
    EXPECT_NEAR(wrist.rotation, left_wrist.rotation, 1e-12);
  }
}

TEST(Mirrored, IsTheRotationOfTheReflectedAxes) {
  std::mt19937 random(3);
  const Matrix3d M = Vector3d(1, 1, -1).asDiagonal();
  const Quaterniond q = RandomRotation(random);
  EXPECT_LT((Mirrored(q).toRotationMatrix() - M * q.toRotationMatrix() * M).norm(), 1e-14);
}

TEST(ShoulderAngles, ReadAbductionInPlaneZeroAndFlexionInPlaneNinety) {
  for (const Side side : kSides) {
    const Vector3d lateral = Sign(side) * kZ;
    const ShoulderAngles abducted = ShoulderAnglesFrom(WithAxes(kX, -lateral), side);
    EXPECT_NEAR(abducted.plane.value(), 0.0, 1e-12);
    EXPECT_NEAR(abducted.elevation, 90 * kDegree, 1e-12);
    EXPECT_NEAR(abducted.rotation.value(), 0.0, 1e-12);
    const ShoulderAngles flexed = ShoulderAnglesFrom(WithAxes(kY, -kX), side);
    EXPECT_NEAR(flexed.plane.value(), 90 * kDegree, 1e-12);
    EXPECT_NEAR(flexed.elevation, 90 * kDegree, 1e-12);
    EXPECT_NEAR(flexed.rotation.value(), -90 * kDegree, 1e-12);
  }
}

TEST(ShoulderAngles, ReadInternalRotationPositive) {
  for (const Side side : kSides) {  // abducted, the anterior face turned down: forearm points down
    const Vector3d lateral = Sign(side) * kZ;
    EXPECT_NEAR(ShoulderAnglesFrom(WithAxes(-kY, -lateral), side).rotation.value(), 90 * kDegree,
                1e-12);
  }
}

TEST(ShoulderAngles, AreTheYxyAnglesOfARightArm) {
  for (double plane = -3.0; plane < 3.1; plane += 0.5)
    for (double elevation = 0.2; elevation < 3.0; elevation += 0.4)
      for (double rotation = -3.0; rotation < 3.1; rotation += 0.5) {
        const Quaterniond q_TU =
            AngleAxisd(plane, kY) * AngleAxisd(-elevation, kX) * AngleAxisd(rotation, kY);
        const ShoulderAngles angles = ShoulderAnglesFrom(q_TU, Side::kRight);
        EXPECT_NEAR(angles.plane.value(), plane, 1e-12);
        EXPECT_NEAR(angles.elevation, elevation, 1e-12);
        EXPECT_NEAR(angles.rotation.value(), rotation, 1e-12);
      }
}

TEST(ShoulderAngles, LeavePlaneAndRotationEmptyCloseToThePoles) {
  for (const Side side : kSides)
    for (const double pole : {0.0, 180.0})
      for (const double off : {-0.11, -0.09, -1e-9, 0.0, 1e-9, 0.09, 0.11}) {
        const double elevation = pole * kDegree + off;
        const ShoulderAngles angles =
            ShoulderAnglesFrom(Quaterniond(AngleAxisd(0.8, kY) * AngleAxisd(-elevation, kX)), side);
        EXPECT_EQ(angles.plane.has_value(), std::abs(off) > 0.1) << elevation;
        EXPECT_EQ(angles.rotation.has_value(), std::abs(off) > 0.1) << elevation;
        EXPECT_NEAR(std::cos(angles.elevation), std::cos(elevation), 1e-12);
      }
}

TEST(ShoulderElevation, IsTheAngleFromHangingWhateverTheHeadingAndTheRotation) {
  const Quaterniond hanging = WithAxes(kX, kZ);  // Y of the upper arm up, z of the world up
  for (double elevation = 0.0; elevation < 3.14; elevation += 0.2)
    for (double turn = 0.0; turn < 6.0; turn += 0.7) {
      const Quaterniond q_WU =
          AngleAxisd(turn, kZ) * hanging * AngleAxisd(elevation, kX) * AngleAxisd(1.0 - turn, kY);
      EXPECT_NEAR(ShoulderElevation(q_WU), elevation, 1e-12);
    }
}

TEST(WristAngles, ReadPalmarFlexionAndUlnarDeviationPositive) {
  for (const Side side : kSides) {
    const Vector3d ulnar = -Sign(side) * kZ;
    const Vector3d distal_flexed = -std::cos(0.3) * kY + std::sin(0.3) * kX;
    const Vector3d palm = kX * std::cos(0.3) + kY * std::sin(0.3);
    EXPECT_NEAR(WristAnglesFrom(WithAxes(palm, -distal_flexed), side).flexion, 0.3, 1e-12);
    const Vector3d distal_deviated = -std::cos(0.3) * kY + std::sin(0.3) * ulnar;
    EXPECT_NEAR(WristAnglesFrom(WithAxes(kX, -distal_deviated), side).deviation, 0.3, 1e-12);
  }
}

TEST(WristAngles, ReadRotationInTheSenseOfPronation) {
  for (const Side side : kSides)
    EXPECT_NEAR(WristAnglesFrom(ElbowRotation({0, 0, 0.4}, side), side).rotation, 0.4, 1e-12);
}

}  // namespace
}  // namespace brachium
