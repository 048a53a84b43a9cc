#include "problems/simulation/inverse_kinematics.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace brachium {
namespace {

using Eigen::Vector3d;

JointValues Bent(double flexion, double abduction, double rotation, double elbow) {
  JointValues joints = StartPoseJoints();
  joints[kShoulderFlexion] = flexion;
  joints[kShoulderAbduction] = abduction;
  joints[kShoulderRotation] = rotation;
  joints[kElbowFlexion] = elbow;
  joints[kElbowAdduction] = -0.07;
  return joints;
}

TEST(BringWristTo, FindsTheAnglesOfThePoseThatThePlacesAreFrom) {
  const ArmShape shape;
  for (const JointValues& posed : {Bent(0.0, 0.14, 0.0, 0.17), Bent(0.9, 0.3, -0.4, 1.7),
                                   Bent(1.5, 0.8, 1.2, 2.2), Bent(-0.3, 0.5, 0.3, 0.6)}) {
    const ArmMotion arm = ArmOf(posed, shape);
    MovingJoints found;
    found[kElbowAdduction].value = posed[kElbowAdduction];
    BringWristTo({.p = arm.wrist_W.p}, {.p = arm.forearm.joint_W.p}, shape, found);
    for (const Joint joint :
         {kShoulderFlexion, kShoulderAbduction, kShoulderRotation, kElbowFlexion})
      EXPECT_NEAR(found[joint].value, posed[joint], 1e-10) << joint;
  }
}

// A circle, whose wrist the chain must then carry with the circle's velocity and acceleration.
TEST(BringWristTo, MovesTheWristWithTheVelocityAndAccelerationAskedFor) {
  const ArmShape shape;
  for (double t = 0.0; t < 2.0; t += 0.17) {
    const Moving angle{3.0 * t, 3.0, 0.4};
    const MovingPoint wrist =
        PointOf(Moving{0.3, 0.1, 0.0} + 0.1 * Cos(angle), Moving{-0.2, 0.0, 0.5}, 0.1 * Sin(angle));
    MovingJoints joints;
    joints[kElbowAdduction] = {0.05, 0.3, -0.2};
    BringWristTo(wrist, PointOf({-0.4, 0.2, 0.1}, {-1.0, 0.0, 0.0}, {0.5, -0.3, 0.0}), shape,
                 joints);
    const MovingPoint reached = ArmOf(joints, shape, {}).wrist_W;
    EXPECT_LT((reached.p - wrist.p).norm(), 1e-13);
    EXPECT_LT((reached.v - wrist.v).norm(), 1e-12);
    EXPECT_LT((reached.a - wrist.a).norm(), 1e-11);
  }
}

TEST(BringWristTo, RefusesWhatIsOutOfReachAndAnElbowThatPointsNowhere) {
  MovingJoints joints;
  const MovingPoint down{.p = {0.0, -1.0, 0.0}};
  EXPECT_THROW(BringWristTo({.p = {0.6, 0.0, 0.0}}, down, {}, joints), std::domain_error);
  EXPECT_THROW(BringWristTo({.p = {0.03, 0.0, 0.0}}, down, {}, joints), std::domain_error);
  EXPECT_THROW(BringWristTo({.p = {0.0, -0.4, 0.0}}, down, {}, joints), std::domain_error);
}

TEST(BringHandTo, MeetsThePlaceWhateverTrunkShoulderAndWristDo) {
  const ArmShape shape;
  const Vector3d place(0.42, -0.28, -0.1);
  JointValues joints = StartPoseJoints();
  joints[kTrunkLean] = 0.12;
  joints[kTrunkBend] = -0.1;
  joints[kShoulderUp] = 0.04;
  joints[kElbowAdduction] = 0.06;
  joints[kForearmPronation] = 2.4;
  joints[kWristFlexion] = -0.2;
  for (const HandPlace::Part part : {HandPlace::Part::kWrist, HandPlace::Part::kFingertip}) {
    BringHandTo({.part = part, .p_T = place, .elbow_T = {-0.5, -1.0, 0.7}}, shape, joints);
    const ArmMotion arm = ArmOf(joints, shape);
    const Vector3d reached = part == HandPlace::Part::kWrist ? arm.wrist_W.p : arm.fingertip_W.p;
    EXPECT_LT((reached - place).norm(), 1e-12);
  }
}

TEST(ArmOf, TurnsTheGirdleTowardsTheShoulderAndLeansTheTrunkAboutTheHips) {
  const ArmShape shape;
  JointValues joints = StartPoseJoints();
  const ArmMotion still = ArmOf(joints, shape);
  EXPECT_LT(still.girdle.turning.q_AB.angularDistance(Eigen::Quaterniond::Identity()), 1e-15);
  joints[kShoulderUp] = 0.08;
  const ArmMotion raised = ArmOf(joints, shape);
  EXPECT_GT(raised.girdle.turning.q_AB.angularDistance(Eigen::Quaterniond::Identity()), 0.3);
  EXPECT_LT((raised.girdle.joint_W.p - still.girdle.joint_W.p).norm(), 0.02);  // C7 hardly moves
  joints[kShoulderUp] = 0.0;
  joints[kTrunkLean] = 0.1;
  EXPECT_NEAR(ArmOf(joints, shape).upper_arm.joint_W.p.x(), 0.5 * std::sin(0.1), 1e-12);
  joints[kTrunkLean] = 0.0;
  joints[kTrunkBend] = -0.1;
  EXPECT_NEAR(ArmOf(joints, shape).upper_arm.joint_W.p.z(), -0.5 * std::sin(0.1), 1e-12);
}

}  // namespace
}  // namespace brachium
