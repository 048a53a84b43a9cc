// The batch smoother on chains of other lengths than upper arm and forearm.
#include <gtest/gtest.h>

#include "solver/batch_smoother.h"
#include "tests/support/longer_chain.h"
#include "tests/support/simulated_trial.h"

namespace brachium {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;

Estimate Smoothed(const Observations& observations) {
  const BatchSmoother smoother({});
  std::string why;
  EXPECT_TRUE(smoother.Accepts(observations, &why)) << why;
  Estimate estimate = smoother.Run(observations);
  EXPECT_TRUE(estimate.diagnostics.converged) << estimate.diagnostics.termination;
  EXPECT_FALSE(estimate.diagnostics.singular);
  return estimate;
}

// Rms angle between a segment's estimated and true inclination [rad].
double InclinationError(const Estimate& estimate, const Reference& reference, Segment segment) {
  std::vector<double> errors;
  for (std::size_t i = 0; i < estimate.time.size(); ++i) {
    const Vector3d up = estimate.q_WB.at(segment)[i].conjugate() * Vector3d::UnitZ();
    const Vector3d truth = reference.q_VB.at(segment)[i].conjugate() * Vector3d::UnitZ();
    errors.push_back(up.cross(truth).norm());
  }
  return Rms(errors);
}

// Rms angle of the estimated against the true rotation between two segments [rad].
double ErrorBetween(const Estimate& estimate, const Reference& reference, Segment a, Segment b) {
  const auto between = [&](const AttitudesBySegment& q) {
    std::vector<Quaterniond> q_AB;
    for (std::size_t i = 0; i < q.at(a).size(); ++i)
      q_AB.push_back(q.at(a)[i].conjugate() * q.at(b)[i]);
    return q_AB;
  };
  return RmsAngle(between(estimate.q_WB), between(reference.q_VB));
}

TEST(OneSensorAlone, IsDeadReckonedFromRestToRest) {
  const Scenario scenario = MakeScenario(BriskScenario(16));
  Trial trial = Simulate(scenario, {}).trial;
  trial.observations.recordings.erase(trial.observations.recordings.begin());
  trial.observations.recordings[0].mounting.reset();
  const Estimate estimate = Smoothed(trial.observations);
  ASSERT_EQ(estimate.q_WB.size(), 1u);
  ASSERT_EQ(estimate.p_W.size(), 1u);
  const std::vector<Vector3d>& p_W = estimate.p_W.at("forearm");
  double path = 0.0;
  for (std::size_t i = 1; i < p_W.size(); ++i) path += (p_W[i] - p_W[i - 1]).norm();
  EXPECT_GT(path, 3.0);
  EXPECT_LT((p_W.back() - p_W.front()).norm(), 0.05 * path);  // the arm comes home
}

TEST(OneSensorAlone, KnowsItsInclinationAndHasNoSegmentLength) {
  const Scenario scenario = MakeScenario(BriskScenario(16));
  Trial trial = Simulate(scenario, NoErrors()).trial;
  trial.observations.recordings.erase(trial.observations.recordings.begin());
  const Quaterniond q_BS = trial.observations.recordings[0].mounting->q_BS;
  trial.observations.recordings[0].mounting.reset();
  Estimate estimate = Smoothed(trial.observations);
  for (Quaterniond& q : estimate.q_WB.at(Segment::kForearm)) q = q * q_BS.conjugate();
  EXPECT_LT(InclinationError(estimate, *trial.reference, Segment::kForearm), 0.5 * kDegree);
  for (const Constant& constant : estimate.diagnostics.constants)
    EXPECT_EQ(constant.name.find("distal_joint"), std::string::npos) << constant.name;
}

// Nothing tells the heading of a thorax that never turns: what is asked for does not depend on it.
TEST(ThoraxThatStandsStill, IsUprightAndLeavesTheElbowAsItIs) {
  const Scenario scenario = MakeScenario(BriskScenario(16));
  Trial trial = Simulate(scenario, {}).trial;
  AddThorax(scenario, trial);
  const BatchSmoother smoother({.weight_iterations = 0, .model = {}});
  const Estimate estimate = smoother.Run(trial.observations);
  EXPECT_EQ(estimate.q_WB.size(), 3u);
  EXPECT_TRUE(estimate.diagnostics.converged);
  EXPECT_LE(estimate.diagnostics.iterations, 8);
  const auto& q_WT = estimate.q_WB.at(Segment::kThorax);
  EXPECT_LT(Log<double>(q_WT.front().conjugate() * q_WT.back()).norm(), 0.2 * kDegree);
  EXPECT_LT(InclinationError(estimate, *trial.reference, Segment::kThorax), 0.5 * kDegree);
  EXPECT_LT(RelativeError(estimate, *trial.reference), 2 * kDegree);
  for (const char* joint : {"shoulder", "elbow", "wrist"})
    EXPECT_TRUE(estimate.p_W.contains(joint)) << joint;
}

TEST(Hand, FollowsTheForearmAtTheWrist) {
  const Scenario scenario = MakeScenario(BriskScenario(16));
  Trial trial = Simulate(scenario, {}).trial;
  AddHand(scenario, trial);
  const Estimate estimate = Smoothed(trial.observations);
  EXPECT_LT(ErrorBetween(estimate, *trial.reference, Segment::kForearm, Segment::kHand),
            2 * kDegree);
  EXPECT_LT(RelativeError(estimate, *trial.reference), 2 * kDegree);
  EXPECT_TRUE(estimate.p_W.contains("hand"));
}

TEST(Hand, WithItsForearmNeedsNoUpperArm) {
  const Scenario scenario = MakeScenario(BriskScenario(16));
  Trial trial = Simulate(scenario, {}).trial;
  AddHand(scenario, trial);
  trial.observations.recordings.erase(trial.observations.recordings.begin());
  const Estimate estimate = Smoothed(trial.observations);
  EXPECT_LT(ErrorBetween(estimate, *trial.reference, Segment::kForearm, Segment::kHand),
            0.3 * kDegree);
  EXPECT_FALSE(estimate.p_W.contains("shoulder"));
  EXPECT_TRUE(estimate.p_W.contains("elbow"));
}

TEST(Forearm, BesideAThoraxNeedsTheUpperArm) {
  Observations observations = Brisk(16).observations;
  observations.recordings[0].segment = Segment::kThorax;
  std::string why;
  EXPECT_FALSE(BatchSmoother({}).Accepts(observations, &why));
  EXPECT_NE(why.find("upper arm"), why.npos) << why;
}

}  // namespace
}  // namespace brachium
