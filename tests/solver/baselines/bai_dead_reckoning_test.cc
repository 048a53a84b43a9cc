#include "solver/baselines/bai_dead_reckoning.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "io/trial_folder.h"
#include "problems/evaluation.h"
#include "tests/support/moving_sensor.h"
#include "tests/support/simulated_trial.h"
#include "tests/support/smooth_motion.h"

namespace brachium {
namespace {

using Eigen::Vector3d;

constexpr double kStart = 2.0, kEnd = 4.0;

// A hand that goes 0.3 m along x, turning on the way, and stands before and after.
BodyMotion Passing(double t) {
  Motion way, turn;
  way.AddStep(kStart, kEnd - kStart, 0.3);
  turn.AddStep(kStart, kEnd - kStart, 0.8);
  return {About(Vector3d::UnitZ(), turn.At(t)), PointOf(way.At(t), {}, {})};
}

// With the orientation as its maker would tell it.
Observations PassingHand(const Vector3d& accel_bias) {
  Observations observations;
  observations.arm.segments[Segment::kHand].p_distal_B = {0.0, -0.08, 0.0};
  observations.recordings.push_back(
      Recorded([](double t) { return SensorOn(Passing(t), {}); }, EvenTimes(0.005, 0.01, 700)));
  Recording& recording = observations.recordings.back();
  recording.segment = Segment::kHand;
  for (Vector3d& acc : recording.acc_S) acc += accel_bias;
  for (const double t : recording.time) recording.q_WS.push_back(Passing(t).turning.q_AB);
  return observations;
}

double FinalError(const Estimate& estimate) {
  return (estimate.p_W.at("hand").back() - Vector3d(0.3, 0.0, 0.0)).norm();
}

// Half of a difference of 0.05 m/s^2 times seven seconds squared.
TEST(BaiDeadReckoning, TakesOffTheGravityOfThePlace) {
  Observations observations = PassingHand({0, 0, 9.78 - kGravity});
  observations.gravity = 9.78;
  const BaiDeadReckoning method{BaiDeadReckoningOptions{}};
  EXPECT_LT(FinalError(method.Run(observations)), 1e-4);
  observations.gravity = 9.83;
  EXPECT_NEAR(FinalError(method.Run(observations)), 0.5 * 0.05 * 7.0 * 7.0, 0.02);
}

TEST(BaiDeadReckoning, FollowsOneIdealSensor) {
  const Estimate estimate = BaiDeadReckoning(BaiDeadReckoningOptions{}).Run(PassingHand({0, 0, 0}));
  EXPECT_LT(FinalError(estimate), 1e-4);
  EXPECT_EQ(estimate.p_W.size(), 1u);
}

TEST(BaiDeadReckoning, RunsAwayWithABiasThatZeroVelocityUpdatesTakeOff) {
  const Observations observations = PassingHand({0.0, 0.0, 0.1});
  EXPECT_GT(FinalError(BaiDeadReckoning(BaiDeadReckoningOptions{}).Run(observations)), 1.0);
  const Estimate updated = BaiDeadReckoning(BaiDeadReckoningZuptOptions{}).Run(observations);
  EXPECT_LT(FinalError(updated), 0.01);
  const auto& hand = updated.p_W.at("hand");
  for (const std::size_t still : {50u, 150u, 450u, 650u})
    EXPECT_EQ(hand[still], hand[still + 20]) << still;
}

TEST(BaiDeadReckoning, TellsWhenTheMovementBeganAndEnded) {
  const Estimate estimate = BaiDeadReckoning(BaiDeadReckoningOptions{}).Run(PassingHand({0, 0, 0}));
  ASSERT_EQ(estimate.diagnostics.epochs.size(), 1u);
  EXPECT_NEAR(estimate.diagnostics.epochs[0].start, kStart, 0.25);
  EXPECT_NEAR(estimate.diagnostics.epochs[0].end, kEnd, 0.25);
}

TEST(BaiDeadReckoning, FollowsTheMostDistalOfSeveralSensorsToTheJointBeyondIt) {
  Trial trial =
      Simulate(MakeScenario({.name = "reach", .seed = 2, .duration = 16}), NoErrors()).trial;
  std::swap(trial.observations.recordings[0], trial.observations.recordings[1]);
  const Estimate fore_first =
      BaiDeadReckoning(BaiDeadReckoningZuptOptions{}).Run(trial.observations);
  std::swap(trial.observations.recordings[0], trial.observations.recordings[1]);
  const Estimate upper_first =
      BaiDeadReckoning(BaiDeadReckoningZuptOptions{}).Run(trial.observations);
  ASSERT_TRUE(upper_first.p_W.contains("wrist"));
  EXPECT_LT((upper_first.p_W.at("wrist").back() - fore_first.p_W.at("wrist").back()).norm(), 1e-9);
  const Evaluation evaluation = Evaluate(upper_first, *trial.reference);
  EXPECT_LT(evaluation.positions.at("wrist").aligned.distance.rmse, 0.05);
}

TEST(BaiDeadReckoning, OfARealFootWithUpdatesStaysWithinAPercentOfItsPath) {
  const auto folder =
      std::filesystem::path(BRACHIUM_SOURCE_DIR) / "../shared/data/trials/foot_dead_reckoning";
  if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << "no recordings at hand";
  const Trial trial = ReadTrial(folder.string()).trial;
  const Estimate estimate = BaiDeadReckoning(BaiDeadReckoningZuptOptions{}).Run(trial.observations);
  const PositionEvaluation hand = Evaluate(estimate, *trial.reference).positions.at("hand");
  EXPECT_LT(hand.final_horizontal, 0.008 * hand.path_length);
  EXPECT_LT(hand.aligned.horizontal.rmse, 0.008 * hand.path_length);
}

}  // namespace
}  // namespace brachium
