#include "solver/baselines/heading_corrected.h"

#include <gtest/gtest.h>

#include "tests/support/hinged_arm.h"
#include "tests/support/simulated_trial.h"

namespace brachium {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;

constexpr double kDrift = 0.3 * kDegree;  // [rad/s]: 18 deg in a minute

Quaterniond TurnedAboutVertical(double angle, const Quaterniond& q) {
  return Quaterniond(Eigen::AngleAxisd(angle, Vector3d::UnitZ())) * q;
}

TEST(AdductionOfHeading, IsThatOfTheTurnedForearm) {
  const Quaterniond q_WU = SmoothRotation(0.4), q_WF = SmoothRotation(2.0, 1.0);
  const AdductionOfHeading adduction(q_WU, q_WF);
  for (const double heading : {-2.0, 0.0, 0.7}) {
    const Vector3d y_W = TurnedAboutVertical(heading, q_WF) * Vector3d::UnitY();
    const auto [beta, slope] = adduction.At(heading);
    EXPECT_NEAR(beta, std::asin((q_WU * Vector3d::UnitZ()).dot(y_W)), 1e-12);
    EXPECT_NEAR(slope, (adduction.At(heading + 1e-6).first - beta) / 1e-6, 1e-5);
  }
}

TEST(HeadingWindow, FindsTheHeadingThatThePosturesShareAndRatesIt) {
  const HingedArmOptions arm{.carrying_angle = 8 * kDegree};
  std::vector<AdductionOfHeading> postures;
  for (double t = 0; t < 4; t += 0.1)
    postures.emplace_back(arm.q_WU, TurnedAboutVertical(-0.4, HingedForearm(arm, t).turning.q_AB));
  const HeadingWindow window =
      SolveWindow(postures.data(), postures.data() + postures.size(), -8 * kDegree, 0.0);
  EXPECT_NEAR(window.heading, 0.4, 1e-6);
  EXPECT_GT(window.rating, 0.8);
}

TEST(HeadingWindow, StaysWhereItIsWhereTheFlexionAxisIsVertical) {
  const HingedArmOptions arm{.q_WU = kFlexionAxisVertical};
  std::vector<AdductionOfHeading> postures;
  for (double t = 0; t < 4; t += 0.1)
    postures.emplace_back(arm.q_WU, HingedForearm(arm, t).turning.q_AB);
  const HeadingWindow window =
      SolveWindow(postures.data(), postures.data() + postures.size(), 0.1, 0.2);
  EXPECT_NEAR(window.heading, 0.2, 1e-9);
  EXPECT_NEAR(window.rating, 0.0, 1e-9);
}

TEST(HeadingCorrected, HoldsADriftingHeadingWhereTheElbowSeesIt) {
  for (const Side side : {Side::kRight, Side::kLeft}) {
    const Trial trial = HingedArm({.side = side,
                                   .carrying_angle = 10 * kDegree,
                                   .forearm_heading_drift = kDrift,
                                   .duration = 60});
    const double before =
        RelativeError(LuingeUnconstrained({}).Run(trial.observations), *trial.reference);
    const double after =
        RelativeError(HeadingCorrected({}).Run(trial.observations), *trial.reference);
    EXPECT_GT(before, 9 * kDegree) << Name(side);
    EXPECT_LT(after, 3 * kDegree) << Name(side);
  }
}

TEST(HeadingCorrected, LeavesTheHeadingAloneWhereTheElbowIsBlindToIt) {
  const Trial trial = HingedArm({.q_WU = kFlexionAxisVertical, .forearm_heading_drift = kDrift});
  const Estimate corrected = HeadingCorrected({}).Run(trial.observations);
  const Estimate before = LuingeUnconstrained({}).Run(trial.observations);
  EXPECT_LT(RmsAngle(ForearmInUpperArm(corrected.q_WB), ForearmInUpperArm(before.q_WB)),
            0.5 * kDegree);
}

TEST(HeadingCorrected, TurnsTheForearmAboutTheVerticalOnly) {
  const Trial trial = HingedArm({.forearm_heading_drift = kDrift});
  const Estimate corrected = HeadingCorrected({}).Run(trial.observations);
  const Estimate before = LuingeUnconstrained({}).Run(trial.observations);
  EXPECT_EQ(RmsAngle(corrected.q_WB.at(Segment::kUpperArm), before.q_WB.at(Segment::kUpperArm)),
            0.0);
  const auto& q_WF = corrected.q_WB.at(Segment::kForearm);
  for (std::size_t i = 0; i < q_WF.size(); ++i) {
    const Vector3d up = q_WF[i].conjugate() * Vector3d::UnitZ();
    const Vector3d up_before = before.q_WB.at(Segment::kForearm)[i].conjugate() * Vector3d::UnitZ();
    ASSERT_LT((up - up_before).norm(), 1e-9);
  }
}

}  // namespace
}  // namespace brachium
