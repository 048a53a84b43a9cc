#include "solver/baselines/static_alignment.h"

#include <gtest/gtest.h>

#include "problems/joint_angles.h"
#include "problems/rotation.h"

namespace brachium {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;

constexpr double kFacing = 0.7;

// Sensors anywhere on an arm that hangs, told by their maker's orientation in one world.
Observations Hanging(Side side) {
  Observations observations;
  observations.arm.side = side;
  observations.intervals = {{"calibration:static_pose", 0.0, 1.0}};
  double turn = 0.3;
  for (const Segment segment : {Segment::kGirdle, Segment::kUpperArm, Segment::kForearm}) {
    Recording recording;
    recording.segment = segment;
    const Quaterniond q_BS = Exp<double>(Vector3d(turn, 1.0 - turn, -2.0 * turn));
    turn += 0.4;
    const Quaterniond q_WB = StaticPose(segment, observations, kFacing);
    for (int i = 0; i < 100; ++i) {
      recording.time.push_back(0.01 * i);
      recording.q_WS.push_back(q_WB * q_BS);
    }
    observations.recordings.push_back(recording);
  }
  return observations;
}

TEST(StaticPose, HangsWithTheThumbForwardOnBothSides) {
  for (const Side side : {Side::kRight, Side::kLeft}) {
    const Observations observations = Hanging(side);
    const Quaterniond q_WU = StaticPose(Segment::kUpperArm, observations, kFacing);
    const Vector3d forward(std::cos(kFacing), std::sin(kFacing), 0.0);
    EXPECT_LT((q_WU * Vector3d::UnitY() - Vector3d::UnitZ()).norm(), 1e-12);
    EXPECT_LT((q_WU * Vector3d::UnitX() - forward).norm(), 1e-12);
    const Quaterniond q_WF = StaticPose(Segment::kForearm, observations, kFacing);
    const ElbowAngles elbow = ElbowAnglesFrom(q_WU.conjugate() * q_WF, side);
    EXPECT_NEAR(elbow.flexion, 0.0, 1e-12);
    EXPECT_NEAR(elbow.pronation, 90 * kDegree, 1e-12);
  }
}

TEST(StaticAlignment, PutsEverySegmentWhereThePoseExpectsIt) {
  for (const Side side : {Side::kRight, Side::kLeft}) {
    const Observations observations = Hanging(side);
    const Observations aligned = AlignedByStaticPose(observations, kFacing);
    for (const Recording& recording : aligned.recordings) {
      ASSERT_TRUE(recording.mounting.has_value());
      const Quaterniond q_WB = recording.q_WS[50] * recording.mounting->q_BS.conjugate();
      const Quaterniond expected = StaticPose(recording.segment, observations, kFacing);
      EXPECT_LT(q_WB.angularDistance(expected), 1e-9) << Name(recording.segment);
    }
  }
}

TEST(StaticAlignment, AsPrintedWouldNotStayWithTheSegment) {
  // R_sensor R_expected in place of R_sensorᵀ R_expected: right for no sensor that is turned.
  const Observations observations = Hanging(Side::kRight);
  const Quaterniond q_gs = observations.recordings[1].q_WS[0];
  const Quaterniond expected = StaticPose(Segment::kUpperArm, observations, kFacing);
  EXPECT_GT((q_gs * (q_gs * expected)).angularDistance(expected), 0.5);
  EXPECT_LT((q_gs * (q_gs.conjugate() * expected)).angularDistance(expected), 1e-9);
}

TEST(StaticAlignment, KeepsAMountingThatIsToldAndLeavesOutWhatCarriesNoOrientation) {
  Observations observations = Hanging(Side::kRight);
  const Mounting told{.q_BS = Exp<double>(Vector3d(0.1, 0.2, 0.3))};
  observations.recordings[0].mounting = told;
  observations.recordings[2].q_WS.clear();
  const Observations aligned = AlignedByStaticPose(observations, kFacing);
  EXPECT_EQ(aligned.recordings[0].mounting->q_BS.coeffs(), told.q_BS.coeffs());
  EXPECT_TRUE(aligned.recordings[1].mounting.has_value());
  EXPECT_FALSE(aligned.recordings[2].mounting.has_value());
}

}  // namespace
}  // namespace brachium
