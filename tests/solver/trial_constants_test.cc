// What is the same over a whole trial is estimated with it.
#include <gtest/gtest.h>

#include "problems/alignment.h"
#include "solver/batch_smoother.h"
#include "tests/support/simulated_trial.h"

namespace brachium {
namespace {

using Eigen::Vector3d;

// Sensors strapped on and measured by eye, each on a clock of its own.
SimulatedTrial WornByEye() {
  SimulationOptions errors;
  errors.draw_sizes = true;
  errors.mounting_error = 3 * kDegree;
  errors.lever_arm_error = 0.015;
  errors.length_error = 0.008;
  errors.clock_offset = 0.005;
  return Simulate(MakeScenario(BriskScenario(60)), errors);
}

const Constant& Found(const Estimate& estimate, const std::string& name) {
  for (const Constant& constant : estimate.diagnostics.constants)
    if (constant.name == name) return constant;
  ADD_FAILURE() << "no " << name;
  static const Constant none;
  return none;
}

// Of the forearm in the upper arm [rad]; after one constant turn on each side.
double AlignedError(const Estimate& estimate, const Reference& reference) {
  RotationPairs pairs{.estimate = {}, .reference = {}};
  const auto estimated = ForearmInUpperArm(estimate.q_WB),
             truth = ForearmInUpperArm(reference.q_VB);
  for (std::size_t i = 0; i < estimated.size(); ++i) {
    if (!estimated[i].coeffs().allFinite()) continue;
    pairs.estimate.push_back(estimated[i]);
    pairs.reference.push_back(truth[i]);
  }
  return RmsAngle(AlignBothSides(pairs).Apply(pairs.estimate), pairs.reference);
}

TEST(TrialConstants, AreFoundOnAnArmWhoseSensorsAreWornByEye) {
  const SimulatedTrial worn = WornByEye();
  const Estimate estimate = BatchSmoother({}).Run(worn.trial.observations);
  EXPECT_LT(AlignedError(estimate, *worn.trial.reference), 0.2 * kDegree);
  EXPECT_NEAR(Found(estimate, "forearm.clock_offset_s").value.at(0),
              worn.True("forearm.clock_offset_s").at(0), 3e-4);
  const Constant& lever = Found(estimate, "forearm.p_BS_m");
  for (std::size_t axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(lever.value.at(axis), worn.True("forearm.p_BS_m").at(axis),
                std::min(0.007, 3 * lever.sd.at(axis)))
        << axis;
}

TEST(TrialConstants, LeaveOfAMountingWhatTheElbowDoesNotShowToItsPrior) {
  const Estimate estimate = BatchSmoother({}).Run(WornByEye().trial.observations);
  const Constant &upper_arm = Found(estimate, "upper_arm.mounting_turn_deg"),
                 &forearm = Found(estimate, "forearm.mounting_turn_deg");
  EXPECT_GT(forearm.sd.at(1), 2.5);  // about the forearm: the zero of pronation
  EXPECT_LT(forearm.sd.at(0), 1.5);
  EXPECT_LT(upper_arm.sd.at(0), 2.0);
  bool said = false;
  for (const std::string& sentence : estimate.diagnostics.held_by_prior)
    said = said || sentence.starts_with("forearm.mounting_turn_deg (y)");
  EXPECT_TRUE(said);
}

// The estimate of a clock must not be drawn to zero by the noise of what tells it.
TEST(TrialConstants, FindTheClockWhereTheArmMovesSlowlyToo) {
  SimulationOptions errors;
  errors.clock_offset = 0.01;
  const SimulatedTrial slow =
      Simulate(MakeScenario({.name = "daily_slow", .seed = 3, .duration = 120}), errors);
  const Estimate estimate = BatchSmoother({}).Run(slow.trial.observations);
  const Constant& clock = Found(estimate, "forearm.clock_offset_s");
  const double truth = slow.True("forearm.clock_offset_s").at(0);
  EXPECT_GT(clock.value.at(0) / truth, 0.9);
  EXPECT_NEAR(clock.value.at(0), truth, 3 * clock.sd.at(0));
  EXPECT_LT(clock.sd.at(0), 1.5e-3);
}

// Beyond what the first-order effect of a clock is good for.
TEST(TrialConstants, FindClocksThatAreFarApart) {
  SimulationOptions errors;
  errors.clock_offset = 0.05;
  const SimulatedTrial brisk = Simulate(MakeScenario(BriskScenario(60)), errors);
  const Estimate estimate = BatchSmoother({}).Run(brisk.trial.observations);
  EXPECT_NEAR(Found(estimate, "forearm.clock_offset_s").value.at(0),
              brisk.True("forearm.clock_offset_s").at(0), 5e-4);
  EXPECT_LT(AlignedError(estimate, *brisk.trial.reference), 0.2 * kDegree);
}

TEST(TrialConstants, HaveSamplesSummedAgainAboutAClockOnlyWhereMovementTellsIt) {
  const auto solved_again = [](const std::string& scenario) {
    SimulationOptions errors;
    errors.clock_offset = 0.03;
    const Trial trial =
        Simulate(MakeScenario({.name = scenario, .seed = 3, .duration = 45}), errors).trial;
    int weights = 0;
    const Estimate estimate = BatchSmoother({}).Run(
        trial.observations,
        [&](std::string_view stage, double) { weights += stage == "weights" ? 1 : 0; });
    EXPECT_GT(std::abs(Found(estimate, "forearm.clock_offset_s").value.at(0)), 6e-3);
    return weights - 1;
  };
  EXPECT_GT(solved_again("daily_brisk"), 0);
  EXPECT_EQ(solved_again("daily_slow"), 0);
}

TEST(TrialConstants, MayBeSwitchedOff) {
  SmootherOptions options;
  options.model.estimate_mountings = false;
  options.model.clock_offset_sigma_s = 0.0;
  options.model.gyro_scale_sigma = options.model.accel_scale_sigma = 0.0;
  const Estimate estimate = BatchSmoother(options).Run(WornByEye().trial.observations);
  for (const Constant& constant : estimate.diagnostics.constants)
    for (const char* off : {"mounting_turn", "clock_offset", "_scale"})
      EXPECT_EQ(constant.name.find(off), std::string::npos) << constant.name;
}

// Of a mounting that wobbles the elbow's axes show anything.
TEST(TrialConstants, LeaveMountingsAsToldWhereSensorsMoveOnTheirSegments) {
  SimulationOptions errors;
  errors.draw_sizes = true;
  errors.mounting_error = 3 * kDegree;
  errors.soft_tissue = TypicalSoftTissue();
  const Trial trial = Simulate(MakeScenario(BriskScenario(60)), errors).trial;
  const Estimate estimate = BatchSmoother({}).Run(trial.observations);
  for (const Constant& constant : estimate.diagnostics.constants)
    EXPECT_EQ(constant.name.find("mounting_turn"), std::string::npos) << constant.name;
  EXPECT_GT(estimate.sd_B.at(Segment::kForearm)[3000].minCoeff(), 3 * kDegree);
  bool said = false;
  for (const std::string& note : estimate.diagnostics.notes)
    said = said || note.find("mountings are taken as they were told") != std::string::npos;
  EXPECT_TRUE(said);
}

TEST(SoftTissue, IsFollowedWhereItIsAskedFor) {
  SimulationOptions errors;
  errors.soft_tissue = TypicalSoftTissue();
  const Trial trial =
      Simulate(MakeScenario({.name = "daily_slow", .seed = 3, .duration = 60}), errors).trial;
  SmootherOptions follows;
  follows.model.soft_tissue_deg = 3.0;
  const double with =
                   AlignedError(BatchSmoother(follows).Run(trial.observations), *trial.reference),
               without = AlignedError(BatchSmoother({}).Run(trial.observations), *trial.reference);
  EXPECT_LT(with, 0.85 * without);
}

}  // namespace
}  // namespace brachium
