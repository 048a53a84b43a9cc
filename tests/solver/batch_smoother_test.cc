#include "solver/batch_smoother.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "problems/joint_angles.h"
#include "problems/simulation/mirror.h"
#include "tests/support/simulated_trial.h"

namespace brachium {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;

Estimate Smoothed(const Observations& observations, const SmootherOptions& options = {}) {
  const BatchSmoother smoother(options);
  std::string why;
  EXPECT_TRUE(smoother.Accepts(observations, &why)) << why;
  Estimate estimate = smoother.Run(observations);
  EXPECT_TRUE(estimate.diagnostics.converged) << estimate.diagnostics.termination;
  EXPECT_FALSE(estimate.diagnostics.singular);
  return estimate;
}

// Every two samples made one: the mean over both cells.
Observations AtHalfTheRate(Observations observations) {
  for (Recording& recording : observations.recordings) {
    Recording halved = recording;
    halved.time.clear();
    halved.gyr_S.clear();
    halved.acc_S.clear();
    for (std::size_t i = 0; i + 1 < recording.size(); i += 2) {
      halved.time.push_back((recording.time[i] + recording.time[i + 1]) / 2);
      halved.gyr_S.push_back((recording.gyr_S[i] + recording.gyr_S[i + 1]) / 2);
      halved.acc_S.push_back((recording.acc_S[i] + recording.acc_S[i + 1]) / 2);
    }
    recording = halved;
  }
  return observations;
}

// A trial and, minutes later, the same movement again; nothing was recorded between.
Observations TwiceWithABreak(const Observations& once, double gap) {
  Observations twice = once;
  for (Recording& recording : twice.recordings) {
    const Recording first = recording;
    for (std::size_t i = 0; i < first.size(); ++i) {
      recording.time.push_back(first.time[i] + first.time.back() + gap);
      recording.gyr_S.push_back(first.gyr_S[i]);
      recording.acc_S.push_back(first.acc_S[i]);
    }
  }
  return twice;
}

// Its turns there settle slowly.
TEST(BatchSmoother, SolvesATrialInWhichOneSensorIsMissingForLong) {
  const Trial trial = Simulate(MakeScenario({.name = "daily_brisk", .duration = 90.0}), {}).trial;
  Observations observations = trial.observations;
  observations.recordings[1] = Without(observations.recordings[1], 20.0, 80.0);
  SmootherOptions options;
  options.knot_spacing_s = 0.2;
  options.covariance = false;
  const Estimate estimate = Smoothed(observations, options);
  EXPECT_GT(estimate.diagnostics.iterations, 200);
  const auto found = ForearmInUpperArm(estimate.q_WB),
             truth = ForearmInUpperArm(trial.reference->q_VB);
  EXPECT_LT(RmsAngle({found.end() - 500, found.end()}, {truth.end() - 500, truth.end()}),
            0.5 * kDegree);
}

TEST(BatchSmoother, CrossesAGapOfMinutes) {
  const Trial trial = Brisk(16);
  const Estimate once = Smoothed(trial.observations);
  const Estimate twice = Smoothed(TwiceWithABreak(trial.observations, 180.0));
  ASSERT_EQ(twice.time.size(), 2 * once.time.size());
  const auto q_UF = ForearmInUpperArm(twice.q_WB), truth = ForearmInUpperArm(trial.reference->q_VB);
  const auto middle = q_UF.begin() + static_cast<std::ptrdiff_t>(once.time.size());
  EXPECT_LT(RmsAngle({q_UF.begin(), middle}, truth), 0.5 * kDegree);
  EXPECT_LT(RmsAngle({middle, q_UF.end()}, truth), 0.5 * kDegree);
}

TEST(BatchSmoother, GivesTheSameAnswerAtHalfTheKnotSpacing) {
  const Observations observations = Brisk(30).observations;
  const Estimate coarse = Smoothed(observations, {.knot_spacing_s = 0.05, .model = {}});
  const Estimate fine = Smoothed(observations, {.knot_spacing_s = 0.025, .model = {}});
  EXPECT_LT(RmsAngle(ForearmInUpperArm(coarse.q_WB), ForearmInUpperArm(fine.q_WB)), 0.05 * kDegree);
}

TEST(BatchSmoother, GivesTheSameAnswerAtHalfTheSamplingRate) {
  const Observations observations = Brisk(30).observations;
  const Estimate full = Smoothed(observations), half = Smoothed(AtHalfTheRate(observations));
  EXPECT_EQ(half.time.size(), full.time.size() / 2);
  const auto expected =
      Interpolate(SampleTimes(full.time), ForearmInUpperArm(full.q_WB), half.time);
  EXPECT_LT(RmsAngle(expected, ForearmInUpperArm(half.q_WB)), 0.05 * kDegree);
}

TEST(BatchSmoother, DoesNotCareWhereTheClockStarts) {
  const Observations observations = Brisk(16).observations;
  Observations later = observations;
  for (Recording& recording : later.recordings)
    for (double& time : recording.time) time += 1000.0;
  later.start_pose->time += 1000.0;
  const Estimate a = Smoothed(observations), b = Smoothed(later);
  EXPECT_NEAR(b.time.front() - a.time.front(), 1000.0, 1e-9);
  for (const Segment segment : {Segment::kUpperArm, Segment::kForearm})
    EXPECT_LT(Worst(Angles(a.q_WB.at(segment), b.q_WB.at(segment))), 1e-6);
}

// Angles of the elbow and the elevation of the upper arm at one instant [rad].
Eigen::Vector4d ClinicalAngles(const Estimate& estimate, std::size_t i) {
  const Quaterniond& q_WU = estimate.q_WB.at(Segment::kUpperArm)[i];
  const ElbowAngles elbow =
      ElbowAnglesFrom(q_WU.conjugate() * estimate.q_WB.at(Segment::kForearm)[i], estimate.side);
  return {elbow.flexion, elbow.carrying, elbow.pronation, ShoulderElevation(q_WU)};
}

TEST(BatchSmoother, ReadsALeftArmAsTheMirrorImageOfARightOne) {
  const Trial right = Brisk(16);
  const Estimate a = Smoothed(right.observations), b = Smoothed(Mirrored(right).observations);
  EXPECT_EQ(b.side, Side::kLeft);
  ASSERT_EQ(a.time.size(), b.time.size());
  double worst = 0.0;
  for (std::size_t i = 0; i < a.time.size(); ++i)
    for (const double difference : Eigen::Vector4d(ClinicalAngles(a, i) - ClinicalAngles(b, i)))
      worst = std::max(worst, std::abs(std::remainder(difference, 2 * std::numbers::pi)));
  EXPECT_LT(worst, 2e-5);  // weights that are estimated with random signs differ a little
}

TEST(BatchSmoother, FindsTheForearmsHeadingWithoutAStartPose) {
  const Trial trial = Brisk(16);
  Observations untold = trial.observations;
  untold.start_pose.reset();
  const Estimate told = Smoothed(trial.observations), found = Smoothed(untold);
  EXPECT_LT(RmsAngle(ForearmInUpperArm(told.q_WB), ForearmInUpperArm(found.q_WB)), 0.1 * kDegree);
}

TEST(BatchSmoother, DoesNotCareWhichRecordingComesFirst) {
  const Observations observations = Brisk(16).observations;
  Observations swapped = observations;
  std::swap(swapped.recordings[0], swapped.recordings[1]);
  SmootherOptions one_clock;
  one_clock.model.clock_offset_sigma_s = 0.0;
  const Estimate a = Smoothed(observations, one_clock), b = Smoothed(swapped, one_clock);
  EXPECT_LT(Worst(Angles(ForearmInUpperArm(a.q_WB), ForearmInUpperArm(b.q_WB))), 1e-6);
}

TEST(BatchSmoother, StopsAfterTheWindowsWhenAskedTo) {
  const Trial trial = Brisk(16);
  const Estimate windows =
      Smoothed(trial.observations, {.whole_trial = false, .window_s = 4.0, .model = {}});
  EXPECT_EQ(windows.diagnostics.iterations, 0);
  EXPECT_LT(RelativeError(windows, *trial.reference), 3 * kDegree);
  EXPECT_LT(RelativeError(Smoothed(trial.observations), *trial.reference),
            RelativeError(windows, *trial.reference));
}

TEST(BatchSmoother, LeavesSamplesOutsideTheCommonSpanEmpty) {
  Observations observations = Brisk(16).observations;
  observations.recordings[1] = Cut(observations.recordings[1], 1.0, 15.0);
  const Estimate estimate = Smoothed(observations);
  EXPECT_EQ(estimate.time.size(), observations.recordings[0].size());
  for (const auto& [segment, q_WB] : estimate.q_WB) {
    EXPECT_TRUE(q_WB.front().coeffs().hasNaN()) << Name(segment);
    EXPECT_TRUE(q_WB.back().coeffs().hasNaN()) << Name(segment);
    EXPECT_TRUE(q_WB[q_WB.size() / 2].coeffs().allFinite()) << Name(segment);
  }
}

TEST(SmootherOptions, SayWhyTheyAreNotValid) {
  const auto why = [](const SmootherOptions& options) {
    std::string reason;
    EXPECT_FALSE(options.IsValid(&reason));
    return reason;
  };
  EXPECT_THAT(why({.knot_spacing_s = -0.1, .model = {}}), testing::HasSubstr("knot_spacing_s"));
  EXPECT_THAT(why({.window_s = 0.0, .model = {}}), testing::HasSubstr("window_s"));
  EXPECT_THAT(why({.window_s = 2.0, .window_advance_s = 3.0, .model = {}}),
              testing::HasSubstr("window_advance_s"));
  EXPECT_THAT(why({.weight_iterations = -1, .model = {}}), testing::HasSubstr("weight_iterations"));
  EXPECT_THAT(why({.solver = "simplex", .model = {}}), testing::HasSubstr("solver"));
  EXPECT_THAT(why({.threads = 0, .model = {}}), testing::HasSubstr("threads"));
  EXPECT_THAT(why({.model = {.elbow_adduction_sigma_deg = 0.0}}),
              testing::HasSubstr("elbow_adduction_sigma_deg"));
}

// Skin that moves under the sensors leaves residuals that bend the cost: Gauss-Newton's steps alone
// creep there and do not end.
TEST(BatchSmoother, ConvergesOnSkinWhereTheAdductionIsLittleHeld) {
  ScenarioOptions eating{.name = "eating"};
  eating.duration = UsualDuration(eating);
  SmootherOptions options;
  options.covariance = false;
  options.model.elbow_adduction_sigma_deg = 50;
  const Trial trial = Simulate(MakeScenario(eating), HonestErrors(MtxNoise())).trial;
  EXPECT_TRUE(BatchSmoother(options).Run(trial.observations).diagnostics.converged);
}

}  // namespace
}  // namespace brachium
