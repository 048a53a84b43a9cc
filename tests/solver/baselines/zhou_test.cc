#include "solver/baselines/zhou.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "problems/evaluation.h"
#include "tests/support/simulated_trial.h"

namespace brachium {
namespace {

using Eigen::Matrix3d, Eigen::Vector3d;
using testing::Contains, testing::HasSubstr, testing::Not;

Trial Reach(double duration, const SimulationOptions& errors, double shoulder_rms = 0.03) {
  return Simulate(
             MakeScenario(
                 {.name = "reach", .seed = 2, .duration = duration, .shoulder_rms = shoulder_rms}),
             errors)
      .trial;
}

ZhouOptions Unfiltered() { return {.zhou_lowpass_hz = 0.0, .zhou_highpass_hz = 0.0}; }

double WorstError(const std::string& joint, const Estimate& estimate, const Reference& reference) {
  return Evaluate(estimate, reference).positions.at(joint).aligned.distance.max;
}

// Displacement of the shoulder from the start, which is known to be none.
double ShoulderDrift(const Estimate& estimate) {
  double squares = 0.0;
  for (const Vector3d& p : estimate.p_W.at("shoulder")) squares += p.squaredNorm();
  return std::sqrt(squares / static_cast<double>(estimate.time.size()));
}

TEST(Zhou, FindsEveryJointOfAnIdealArmWithoutItsFilters) {
  // A cutoff of next to nothing passes all, and leaves no bias to be told by what looks like a rest.
  // What is left, 7 cm after 16 s, is a start that is tilted by 0.004 deg.
  const ZhouOptions options{.zhou_lowpass_hz = 0.0, .zhou_highpass_hz = 1e-9};
  SimulationOptions told = NoErrors();
  told.tell_carrying_angle = true;
  const Trial trial =
      Simulate(MakeScenario(
                   {.name = "reach", .duration = 16, .carrying_slope = 0.0, .adduction_rms = 0.0}),
               told)
          .trial;
  const Estimate estimate = Zhou(options).Run(trial.observations);
  for (const char* joint : {"shoulder", "elbow", "wrist"})
    EXPECT_LT(WorstError(joint, estimate, *trial.reference), 0.1) << joint;
}

TEST(Zhou, HangsElbowAndWristFromTheShoulderByTheToldLengths) {
  const Trial trial = Brisk(16);
  const Estimate estimate = Zhou({}).Run(trial.observations);
  const auto& segments = trial.observations.arm.segments;
  for (std::size_t i = 0; i < estimate.time.size(); i += 50) {
    const Vector3d elbow = estimate.p_W.at("elbow")[i];
    EXPECT_NEAR((elbow - estimate.p_W.at("shoulder")[i]).norm(),
                segments.at(Segment::kUpperArm).p_distal_B.norm(), 1e-6);
    EXPECT_NEAR((estimate.p_W.at("wrist")[i] - elbow).norm(),
                segments.at(Segment::kForearm).p_distal_B.norm(), 1e-6);
  }
}

TEST(Zhou, StepsWithinTheRotationsWhereThePrintedStepLeavesThem) {
  const double T = 1.0 / 25;
  const Vector3d omega(0.0, 0.0, 2.0);
  Matrix3d printed = Matrix3d::Identity(), kept = Matrix3d::Identity();
  for (int i = 0; i < 20 * 25; ++i) {
    printed += printed * Skew<double>(omega) * T;
    kept = kept * Exp<double>(omega * T).toRotationMatrix();
  }
  EXPECT_NEAR(printed.col(0).norm(), 4.9, 0.05);
  EXPECT_NEAR(kept.col(0).norm(), 1.0, 1e-9);
}

TEST(Zhou, ForgetsHeldPosturesByItsHighPass) {
  const Trial trial = Reach(16, NoErrors());
  EXPECT_GT(RelativeError(Zhou({}).Run(trial.observations), *trial.reference), 5 * kDegree);
  EXPECT_LT(
      RelativeError(Zhou({.zhou_highpass_hz = 0.0}).Run(trial.observations), *trial.reference),
      1 * kDegree);
}

TEST(Zhou, LearnsItsGainsWhereTheShoulderKeepsStill) {
  SimulationOptions errors = NoErrors();
  errors.accel_bias = 0.04;
  Trial trial = Reach(60, errors, 0.0);
  const Estimate fallback = Zhou(Unfiltered()).Run(trial.observations);
  EXPECT_THAT(fallback.diagnostics.notes, Contains(HasSubstr("-1/2")));
  trial.observations.intervals = {{"calibration:shoulder_still", 0.0, 60.0}};
  const Estimate learned = Zhou(Unfiltered()).Run(trial.observations);
  EXPECT_THAT(learned.diagnostics.notes, Not(Contains(HasSubstr("-1/2"))));
  const auto gain =
      std::find_if(learned.diagnostics.constants.begin(), learned.diagnostics.constants.end(),
                   [](const Constant& c) { return c.name == "shoulder.drift_gain"; });
  ASSERT_NE(gain, learned.diagnostics.constants.end());
  EXPECT_EQ(gain->value.size(), 3u);
  EXPECT_EQ(gain->sd.size(), 3u);
}

// On the very movements that they were learned from; a single draw may go either way.
TEST(Zhou, DriftsLessByLearnedGainsOfOrdinarySensors) {
  double learned = 0.0, fallback = 0.0;
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
    SimulationOptions errors;
    errors.seed = seed;
    Trial trial = Reach(60, errors, 0.0);
    fallback += ShoulderDrift(Zhou(Unfiltered()).Run(trial.observations));
    trial.observations.intervals = {{"calibration:shoulder_still", 3.0, 58.0}};
    learned += ShoulderDrift(Zhou(Unfiltered()).Run(trial.observations));
  }
  EXPECT_LT(learned, 0.8 * fallback);
}

TEST(Zhou, SaysThatItDoesNotFilterWhatIsSampledTooSlowly) {
  SimulationOptions slow = NoErrors();
  slow.rate = 18.0;
  const Estimate estimate = Zhou({}).Run(Reach(16, slow).observations);
  EXPECT_THAT(estimate.diagnostics.notes, Contains(HasSubstr("acceleration of the forearm is not "
                                                             "filtered")));
  slow.rate = 25.0;
  EXPECT_THAT(Zhou({}).Run(Reach(16, slow).observations).diagnostics.notes,
              Not(Contains(HasSubstr("not filtered"))));
}

TEST(Zhou, RefusesOneSensorAndSaysWhatFollowsOne) {
  Observations observations = Brisk(16).observations;
  observations.recordings.pop_back();
  std::string why;
  EXPECT_FALSE(Zhou({}).Accepts(observations, &why));
  EXPECT_THAT(why, HasSubstr("forearm"));
}

}  // namespace
}  // namespace brachium
