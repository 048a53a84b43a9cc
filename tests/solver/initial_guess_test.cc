#include "solver/initial_guess.h"

#include <gtest/gtest.h>

#include "problems/joint_angles.h"
#include "tests/support/simulated_trial.h"

namespace brachium {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;
using Attitude = Eigen::Map<const Quaterniond>;

double Heading(const Quaterniond& q_WB) {
  const Vector3d x_W = q_WB * Vector3d::UnitX();
  return std::atan2(x_W.y(), x_W.x());
}

Quaterniond TrueAttitude(const Trial& trial, Segment segment, double time) {
  const SampleTimes times(trial.reference->time);
  return Interpolate(times, trial.reference->q_VB.at(segment), {time}).front();
}

TEST(FirstKnot, StandsUprightByTheSpecificForceOfTheFirstSeconds) {
  const Trial trial = Brisk(16, NoErrors());
  const ArmProblem problem(trial.observations, {}, 0.05);
  State state = problem.PriorState();
  SetFirstKnot(problem, state);
  for (int sensor = 0; sensor < 2; ++sensor) {
    const Segment segment =
        problem.observations().recordings[static_cast<std::size_t>(sensor)].segment;
    const Quaterniond q_VB = trial.reference->q_VB.at(segment).front();
    const Vector3d up = Attitude(state.Attitude(0, sensor)).conjugate() * Vector3d::UnitZ();
    EXPECT_LT((up - q_VB.conjugate() * Vector3d::UnitZ()).norm(), 0.2 * kDegree);
  }
  EXPECT_NEAR(Heading(Attitude(state.Attitude(0, 0))), 0.0, 1e-12);
}

TEST(FirstKnot, TurnsTheForearmAsTheStartPoseSays) {
  const Trial trial = Brisk(16, NoErrors());
  const ArmProblem problem(trial.observations, {}, 0.05);
  State state = problem.PriorState();
  SetFirstKnot(problem, state);
  const Quaterniond q_UF =
      Attitude(state.Attitude(0, 0)).conjugate() * Attitude(state.Attitude(0, 1));
  const ElbowAngles angles = ElbowAnglesFrom(q_UF, Side::kRight);
  EXPECT_NEAR(angles.pronation, *trial.observations.start_pose->forearm_pronation, 2 * kDegree);
  EXPECT_NEAR(angles.flexion, *trial.observations.start_pose->elbow_flexion, 2 * kDegree);
}

TEST(FirstKnot, GivesEverySegmentTheSameHeadingWhenNoPoseWasTold) {
  Trial trial = Brisk(16, NoErrors());
  trial.observations.start_pose.reset();
  const ArmProblem problem(trial.observations, {}, 0.05);
  State state = problem.PriorState();
  SetFirstKnot(problem, state);
  EXPECT_NEAR(Heading(Attitude(state.Attitude(0, 0))), 0.0, 1e-12);
  EXPECT_NEAR(Heading(Attitude(state.Attitude(0, 1))), 0.0, 1e-12);
  TurnFirstKnot(state, 1, 0.7);
  EXPECT_NEAR(Heading(Attitude(state.Attitude(0, 1))), 0.7, 1e-12);
}

TEST(DeadReckoning, FollowsTheMotionOfExactSamples) {
  const Trial trial = Brisk(16, NoErrors());
  const ArmProblem problem(trial.observations, {}, 0.05);
  State state = problem.PriorState();
  for (int node = 0; node < problem.size().nodes; ++node)
    for (int sensor = 0; sensor < 2; ++sensor) std::fill_n(state.GyroBias(node, sensor), 3, 0.0);
  const auto& knots = problem.timeline().knots;
  for (int sensor = 0; sensor < 2; ++sensor)
    Eigen::Map<Quaterniond>{state.Attitude(0, sensor)} =
        TrueAttitude(trial, kSegments[2 + static_cast<std::size_t>(sensor)], 0.5);
  state.Root(0, 0)[1] = 0.25;
  const int last = problem.timeline().Intervals();
  DeadReckon(problem, state, 0, last);
  const int at = problem.timeline().KnotBefore(12.0);
  for (int sensor = 0; sensor < 2; ++sensor) {
    const Quaterniond q_true = TrueAttitude(trial, kSegments[2 + static_cast<std::size_t>(sensor)],
                                            knots[static_cast<std::size_t>(at)]);
    EXPECT_LT(Log<double>(q_true.conjugate() * Attitude(state.Attitude(at, sensor))).norm(), 1e-3);
    const Eigen::Map<const Vector3d> v_end(state.Velocity(last, sensor));
    EXPECT_LT(v_end.norm(), 0.02);  // the trial ends at rest
  }
  EXPECT_EQ(state.Root(last, 0)[1], 0.25);
}

TEST(DeadReckoning, LeavesTheKnotsOutsideItsStretchAlone) {
  const Trial trial = Brisk(16, NoErrors());
  const ArmProblem problem(trial.observations, {}, 0.05);
  State state = problem.PriorState();
  SetFirstKnot(problem, state);
  DeadReckon(problem, state, 0, 10);
  const State before = state;
  DeadReckon(problem, state, 10, 20);
  EXPECT_EQ(Attitude(before.Attitude(10, 1)).coeffs(), Attitude(state.Attitude(10, 1)).coeffs());
  EXPECT_EQ(Attitude(before.Attitude(21, 1)).coeffs(), Attitude(state.Attitude(21, 1)).coeffs());
  EXPECT_NE(Attitude(before.Attitude(20, 1)).coeffs(), Attitude(state.Attitude(20, 1)).coeffs());
}

TEST(HeldBias, IsThatOfItsNodeAtAllLaterOnes) {
  const Trial trial = Brisk(16);
  const ArmProblem problem(trial.observations, {}, 0.05);
  ASSERT_GT(problem.size().nodes, 2);
  State state = problem.PriorState();
  const double first = state.GyroBias(0, 1)[2];
  state.GyroBias(1, 1)[2] = 0.125;
  HoldBias(problem, state, 1);
  EXPECT_EQ(state.GyroBias(0, 1)[2], first);
  for (int node = 2; node < problem.size().nodes; ++node)
    EXPECT_EQ(state.GyroBias(node, 1)[2], 0.125);
}

}  // namespace
}  // namespace brachium
