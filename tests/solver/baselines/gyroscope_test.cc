#include "solver/baselines/gyroscope.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/hinged_arm.h"
#include "tests/support/simulated_trial.h"

namespace brachium {
namespace {

using testing::Contains, testing::HasSubstr, testing::IsEmpty, testing::Not;

TEST(GyroscopeOnly, TakesOffTheBiasThatTheRestsTell) {
  SimulationOptions errors = NoErrors();
  errors.gyro_bias = 0.5 * kDegree;
  const Trial trial = Brisk(60, errors);
  const Estimate estimate = GyroscopeOnly({}).Run(trial.observations);
  EXPECT_LT(RelativeError(estimate, *trial.reference), 2 * kDegree);  // 30 deg with the bias
  EXPECT_THAT(estimate.diagnostics.rests, Not(IsEmpty()));
}

TEST(GyroscopeOnly, StartsWithNoBiasWhereThereIsNoRestAndSaysSo) {
  const double drift = 0.3 * kDegree;
  const Trial trial = HingedArm({.forearm_heading_drift = drift});
  const Estimate estimate = GyroscopeOnly({}).Run(trial.observations);
  EXPECT_NEAR(
      Angles(ForearmInUpperArm(estimate.q_WB), ForearmInUpperArm(trial.reference->q_VB)).back(),
      30 * drift, 0.2 * kDegree);
  EXPECT_THAT(estimate.diagnostics.notes, Contains(HasSubstr("gyro bias of the forearm")));
}

TEST(GyroscopeOnly, StartsAtTheToldPoseOrAtEqualHeadingsAndSaysWhich) {
  Trial trial = Brisk(16, NoErrors());
  const Estimate told = GyroscopeOnly({}).Run(trial.observations);
  EXPECT_THAT(told.diagnostics.notes, Contains(HasSubstr("start pose")));
  trial.observations.start_pose.reset();
  const Estimate untold = GyroscopeOnly({}).Run(trial.observations);
  EXPECT_THAT(untold.diagnostics.notes, Contains(HasSubstr("no start pose")));
  for (const auto& [segment, q_WB] : untold.q_WB) {
    const Eigen::Vector3d x_W = q_WB.front() * Eigen::Vector3d::UnitX();
    EXPECT_NEAR(x_W.y(), 0.0, 1e-3) << Name(segment);
    EXPECT_GT(x_W.x(), 0.0) << Name(segment);
  }
}

TEST(GyroscopeOnly, AppliesAPoseThatWasHeldLaterAtItsOwnInstant) {
  Trial trial = HingedArm({.q_WU = kFlexionAxisVertical});
  const double later = 10.3;
  const auto q_UF = ForearmInUpperArm(trial.reference->q_VB);
  const ElbowAngles angles =
      ElbowAnglesFrom(HingedForearm({.q_WU = kFlexionAxisVertical}, later).turning.q_AB,
                      trial.observations.arm.side);
  trial.observations.start_pose->time = later;
  trial.observations.start_pose->elbow_flexion = angles.flexion;
  const Estimate estimate = GyroscopeOnly({}).Run(trial.observations);
  EXPECT_LT(RmsAngle(ForearmInUpperArm(estimate.q_WB), q_UF), 0.01 * kDegree);
}

TEST(GyroscopeOnly, LeavesInstantsThatASensorDoesNotCoverEmpty) {
  Trial trial = Brisk(16, NoErrors());
  trial.observations.recordings[1] = Cut(trial.observations.recordings[1], 2.0, 14.0);
  const Estimate estimate = GyroscopeOnly({}).Run(trial.observations);
  for (const auto& [segment, q_WB] : estimate.q_WB) {
    EXPECT_TRUE(q_WB.front().coeffs().hasNaN()) << Name(segment);
    EXPECT_TRUE(q_WB.back().coeffs().hasNaN()) << Name(segment);
    EXPECT_FALSE(q_WB[q_WB.size() / 2].coeffs().hasNaN()) << Name(segment);
  }
}

TEST(GyroscopeOnly, FollowsOneSensorAloneWithoutAMounting) {
  Observations observations = Brisk(16).observations;
  observations.recordings.pop_back();
  observations.recordings[0].mounting.reset();
  std::string why;
  ASSERT_TRUE(GyroscopeOnly({}).Accepts(observations, &why)) << why;
  EXPECT_FALSE(GyroscopeOnly({}).Run(observations).q_WB.begin()->second.back().coeffs().hasNaN());
}

}  // namespace
}  // namespace brachium
