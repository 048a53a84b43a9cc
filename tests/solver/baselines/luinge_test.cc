#include "solver/baselines/luinge.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/hinged_arm.h"
#include "tests/support/simulated_trial.h"

namespace brachium {
namespace {

using testing::HasSubstr;

constexpr double kDrift = 0.3 * kDegree;  // [rad/s]: 9 deg in 30 s

Estimate Unconstrained(const Trial& trial) {
  return LuingeUnconstrained({}).Run(trial.observations);
}
Estimate Constrained(const Trial& trial, const LuingeOptions& options = {}) {
  return Luinge(options).Run(trial.observations);
}

// Of the forearm in the upper arm at the end [rad].
double FinalError(const Estimate& estimate, const Trial& trial) {
  return Angles(ForearmInUpperArm(estimate.q_WB), ForearmInUpperArm(trial.reference->q_VB)).back();
}

double HeadingVariance(const Estimate& estimate, Segment segment, std::size_t i) {
  const Eigen::Vector3d up_B = estimate.q_WB.at(segment)[i].conjugate() * Eigen::Vector3d::UnitZ();
  return estimate.sd_B.at(segment)[i].cwiseAbs2().dot(up_B.cwiseAbs2());
}

TEST(Luinge, TakesMostOfTheDriftAwayWhereTheAdductionSeesTheHeading) {
  const Trial trial = HingedArm({.forearm_heading_drift = kDrift});
  EXPECT_GT(FinalError(Unconstrained(trial), trial), 8 * kDegree);
  EXPECT_LT(FinalError(Constrained(trial), trial), 1 * kDegree);
}

TEST(Luinge, DriftsAsBeforeWhereTheFlexionAxisIsVertical) {
  const Trial trial = HingedArm({.q_WU = kFlexionAxisVertical, .forearm_heading_drift = kDrift});
  const double drift = FinalError(Unconstrained(trial), trial);
  EXPECT_GT(drift, 8 * kDegree);
  EXPECT_GT(FinalError(Constrained(trial), trial), 0.9 * drift);
}

TEST(Luinge, TurnsTheSegmentWhoseGyroscopeIsTheLessCertain) {
  const Trial trial = HingedArm({.forearm_heading_drift = kDrift});
  const Estimate estimate = Constrained(trial);
  const auto error =
      Angles(estimate.q_WB.at(Segment::kUpperArm), trial.reference->q_VB.at(Segment::kUpperArm));
  EXPECT_LT(Worst(error), 0.5 * kDegree);
}

TEST(Luinge, ExpectsThePapersStraightElbowUnlessToldToExpectTheCarryingAngle) {
  for (const Side side : {Side::kRight, Side::kLeft}) {
    const Trial trial = HingedArm({.side = side, .carrying_angle = 12 * kDegree});
    EXPECT_GT(FinalError(Constrained(trial), trial), 8 * kDegree) << Name(side);
    const LuingeOptions expecting{
        .filter = {}, .luinge_adduction_sigma_deg = 10, .luinge_expects_carrying_angle = true};
    EXPECT_LT(FinalError(Constrained(trial, expecting), trial), 0.5 * kDegree) << Name(side);
  }
}

TEST(Luinge, KnowsNoGyroBiasAtTheStartWhereItIsNotToTakeItFromRests) {
  const Trial trial = Brisk(20);
  const LuingeUnconstrainedOptions switched_on{.luinge_bias_from_rests = false};
  const auto start = [&](const LuingeUnconstrainedOptions& options) {
    const Estimate estimate = LuingeUnconstrained(options).Run(trial.observations);
    return estimate.diagnostics.constants.at(0);
  };
  EXPECT_GT(Eigen::Vector3d(start({}).value.data()).norm(), 0.3);
  EXPECT_EQ(Eigen::Vector3d(start(switched_on).value.data()).norm(), 0.0);
  EXPECT_GT(start(switched_on).sd[0], 10 * start({}).sd[0]);
}

TEST(Luinge, SaysHowCertainEachAttitudeIs) {
  const Trial trial = HingedArm({.forearm_heading_drift = kDrift});
  const Estimate free = Unconstrained(trial), tied = Constrained(trial);
  const std::size_t last = free.time.size() - 1;
  EXPECT_GT(HeadingVariance(free, Segment::kForearm, last),
            HeadingVariance(free, Segment::kForearm, 0));
  EXPECT_LT(HeadingVariance(tied, Segment::kForearm, last),
            HeadingVariance(free, Segment::kForearm, last) / 10);
}

TEST(Luinge, HasNoPositionsSinceItEstimatesNone) {
  EXPECT_TRUE(Constrained(HingedArm({.q_WU = kFlexionAxisVertical, .duration = 5})).p_W.empty());
}

TEST(Luinge, RefusesAnElbowThatIsNoHingeAndNamesTheMethodThatDoesWithout) {
  Observations observations = Brisk(16).observations;
  observations.arm.elbow.adduction_constraint = false;
  std::string why;
  EXPECT_FALSE(Luinge(LuingeOptions{}).Accepts(observations, &why));
  EXPECT_THAT(why, HasSubstr("luinge_unconstrained"));
  EXPECT_TRUE(LuingeUnconstrained({}).Accepts(observations, &why));
}

TEST(Luinge, RefusesAnArmOfOneSegment) {
  Observations observations = Brisk(16).observations;
  observations.recordings.pop_back();
  std::string why;
  EXPECT_FALSE(Luinge(LuingeOptions{}).Accepts(observations, &why));
  EXPECT_THAT(why, HasSubstr("forearm"));
}

TEST(Luinge, FiltersEachSensorOnItsOwnSamples) {
  const Trial trial = Brisk(16, NoErrors());
  Observations halved = trial.observations;
  Recording& forearm = halved.recordings[1];
  ASSERT_EQ(forearm.segment, Segment::kForearm);
  for (std::size_t i = 0; i + 1 < forearm.size(); ++i) {  // pairs of cells, at half the rate
    forearm.time[i] = (forearm.time[i] + forearm.time[i + 1]) / 2;
    forearm.gyr_S[i] = (forearm.gyr_S[i] + forearm.gyr_S[i + 1]) / 2;
    forearm.acc_S[i] = (forearm.acc_S[i] + forearm.acc_S[i + 1]) / 2;
    Lose(forearm, i + 1);
  }
  const double error =
      RmsAngle(ForearmInUpperArm(LuingeUnconstrained({}).Run(halved).q_WB),
               ForearmInUpperArm(LuingeUnconstrained({}).Run(trial.observations).q_WB));
  EXPECT_GT(error, 0.0);
  EXPECT_LT(error, 0.2 * kDegree);
}

TEST(LuingeRts, EndsWhereTheFilterEndsAndIsBetterBefore) {
  const Trial trial = HingedArm({.forearm_heading_drift = kDrift});
  const Estimate filtered = Constrained(trial);
  const Estimate smoothed = Luinge(LuingeRtsOptions{}).Run(trial.observations);
  EXPECT_EQ(smoothed.q_WB.at(Segment::kForearm).back().coeffs(),
            filtered.q_WB.at(Segment::kForearm).back().coeffs());
  EXPECT_LT(RelativeError(smoothed, *trial.reference),
            0.7 * RelativeError(filtered, *trial.reference));
}

TEST(LuingeRts, IsNeverLessCertainThanTheFilter) {
  const Trial trial = HingedArm({.forearm_heading_drift = kDrift, .duration = 10});
  const Estimate filtered = Constrained(trial);
  const Estimate smoothed = Luinge(LuingeRtsOptions{}).Run(trial.observations);
  for (std::size_t i = 0; i < filtered.time.size(); ++i)
    ASSERT_LT(smoothed.sd_B.at(Segment::kForearm)[i].norm(),
              filtered.sd_B.at(Segment::kForearm)[i].norm() + 1e-9);
}

}  // namespace
}  // namespace brachium
