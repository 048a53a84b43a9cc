#include "solver/elbow_zeros.h"

#include <gtest/gtest.h>

#include "problems/rotation.h"

namespace brachium {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;

const Quaterniond kQ_AU = Exp<double>(Vector3d(0.3, -0.8, 1.1));
const Quaterniond kQ_BF = Exp<double>(Vector3d(-1.0, 0.4, 0.2));

// An elbow that starts 10 deg flexed, thumb forward, and then stretches to `least`.
BallJoint Stretching(double least, Side side) {
  BallJoint joint;
  for (int i = 0; i <= 100; ++i) {
    const double part = i / 100.0;
    joint.time.push_back(0.1 * i);
    const Quaterniond q_UF = ElbowRotation({.flexion = 10 * kDegree + part * (least - 10 * kDegree),
                                            .carrying = 8 * kDegree,
                                            .pronation = (90 - 40 * part) * kDegree},
                                           side);
    joint.R_AB.push_back((kQ_AU * q_UF * kQ_BF.conjugate()).toRotationMatrix());
  }
  return joint;
}

// Axes that are right, and a line to the shoulder that makes flexion `too_much`.
ElbowFrames Frames(double too_much) {
  const Vector3d line_U = Exp<double>(Vector3d(0, 0, -too_much)) * Vector3d::UnitY();
  return FramesFrom(kQ_AU * Vector3d::UnitZ(), kQ_BF * Vector3d::UnitY(), kQ_AU * line_U);
}

HeldPose Pose(double sigma) {
  return {.time = 0.0,
          .elbow_flexion = 10 * kDegree,
          .forearm_pronation = 90 * kDegree,
          .shoulder_elevation = {},
          .sigma = sigma};
}

TEST(ElbowZeros, ComeFromTheStartPoseAndTheLineByTheirWeights) {
  for (const Side side : {Side::kRight, Side::kLeft}) {
    const BallJoint joint = Stretching(5 * kDegree, side);
    const ElbowZeros zeros =
        SetZeros(joint, Frames(15 * kDegree), 10 * kDegree, Pose(5 * kDegree), side);
    const ElbowAngles start = zeros.frames.AnglesAt(joint.R_AB.front(), side);
    EXPECT_NEAR(start.flexion, 13 * kDegree, 1e-9) << Name(side);
    EXPECT_NEAR(start.pronation, 90 * kDegree, 1e-9) << Name(side);
    EXPECT_NEAR(start.carrying, 8 * kDegree, 1e-9) << Name(side);
    EXPECT_NEAR(zeros.frames.AnglesAt(joint.R_AB.back(), side).pronation, 50 * kDegree, 1e-9);
    EXPECT_NEAR(zeros.flexion_sd, std::sqrt(20.0) * kDegree, 1e-9);
    EXPECT_EQ(zeros.pronation_sd, 5 * kDegree);
    EXPECT_EQ(zeros.moved, 0.0);
  }
}

TEST(ElbowZeros, AreMovedWhereTheElbowWouldOverstretchAndDoubtedByAsMuch) {
  for (const Side side : {Side::kRight, Side::kLeft}) {
    const BallJoint joint = Stretching(-17 * kDegree, side);
    const ElbowZeros zeros = SetZeros(joint, Frames(0.0), 6 * kDegree, Pose(6 * kDegree), side);
    EXPECT_NEAR(zeros.moved, 12 * kDegree, 0.5 * kDegree);
    EXPECT_NEAR(zeros.frames.AnglesAt(joint.R_AB.back(), side).flexion, -5 * kDegree,
                0.5 * kDegree);
    EXPECT_EQ(zeros.flexion_sd, zeros.moved);
  }
}

TEST(ElbowZeros, TakeAPoseForGrantedOnlyWhereTheArmHangs) {
  const BallJoint joint = Stretching(0.0, Side::kRight);
  const auto observed = [&](const Vector3d& up_U) {
    Observations observations;
    for (const Segment segment : {Segment::kUpperArm, Segment::kForearm}) {
      const Quaterniond& q_SB = segment == Segment::kUpperArm ? kQ_AU : kQ_BF;
      Recording recording;
      recording.segment = segment;
      recording.time = {0.1, 0.2};
      recording.acc_S.assign(2, kGravity * (q_SB * up_U));
      observations.recordings.push_back(recording);
    }
    return observations;
  };
  const ElbowFrames frames = Frames(0.0);
  const auto hanging = PoseForZeros(observed(Vector3d::UnitY()), joint, frames);
  ASSERT_TRUE(hanging);
  EXPECT_EQ(hanging->sigma, 30 * kDegree);
  EXPECT_FALSE(PoseForZeros(observed(Vector3d::UnitX()), joint, frames));
  Observations told = observed(Vector3d::UnitX());
  told.start_pose = Pose(7 * kDegree);
  EXPECT_EQ(PoseForZeros(told, joint, frames)->sigma, 7 * kDegree);
}

}  // namespace
}  // namespace brachium
