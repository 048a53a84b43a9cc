// What every method promises.
#include "solver/estimators.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "problems/joint_angles.h"
#include "problems/simulation/mirror.h"
#include "tests/support/longer_chain.h"
#include "tests/support/simulated_trial.h"

namespace brachium {
namespace {

using testing::HasSubstr;

// What rounding may make of the same arm, after an iteration to convergence [rad].
constexpr double kSameArm = 1e-6;

// Of a mirrored arm: the signs by which the smoother's weights are estimated (unmodelled.h) are not
// mirrored, and so the weights differ in the third digit.
constexpr double kMirroredArm = 2e-5;

class EveryMethod : public testing::TestWithParam<std::string> {
 protected:
  std::unique_ptr<Estimator> method_ = MakeEstimator(*DefaultOptions(GetParam()));

  std::string ReasonAgainst(const Observations& observations) {
    std::string why;
    EXPECT_FALSE(method_->Accepts(observations, &why));
    return why;
  }
  Estimate Estimated(const Observations& observations) {
    std::string why;
    EXPECT_TRUE(method_->Accepts(observations, &why)) << why;
    return method_->Run(observations);
  }
};

// What each method may be off by on an ideal arm: what its own model leaves out.
struct Ideals {
  double tolerance;                     // rms of the forearm in the upper arm [rad]
  double carrying_angle = 8 * kDegree;  // of the elbow that the method is made for [rad]
};
const std::map<std::string, Ideals> kIdeals = {
    {"smoother", {0.1 * kDegree}},
    {"gyroscope", {0.5 * kDegree}},  // slow movement taken for a rest has a mean rate
    // Acceleration is taken for tilt, in part.
    {"luinge_unconstrained", {2 * kDegree}},
    {"luinge", {2 * kDegree, 0.0}},
    {"luinge_rts", {2 * kDegree, 0.0}},
    {"heading_corrected", {2 * kDegree}},
    {"zhou", {80 * kDegree}},  // its high-pass forgets every posture that is held
    {"bai_kinematic", {2 * kDegree}},
    {"bai_dead_reckoning", {2 * kDegree}},
    {"bai_dead_reckoning_zupt", {2 * kDegree}},
};

// An arm for which every relation of the model holds, recorded and told without an error.
Trial Ideal(Side side, double carrying_angle) {
  ScenarioOptions scenario = BriskScenario(30);
  scenario.side = side;
  scenario.carrying_angle = carrying_angle;
  scenario.adduction_rms = 0.0;
  scenario.carrying_slope = 0.0;
  SimulationOptions simulation = NoErrors();
  simulation.tell_carrying_angle = true;
  return Simulate(MakeScenario(scenario), simulation).trial;
}

TEST_P(EveryMethod, HasValidDefaults) {
  std::string why;
  const MethodOptions defaults = *DefaultOptions(GetParam());
  EXPECT_TRUE(std::visit([&](const auto& options) { return options.IsValid(&why); }, defaults))
      << why;
}

TEST_P(EveryMethod, RefusesAnArmWithoutMountingsAndSaysHowToGetThem) {
  Observations observations = Brisk(16).observations;
  observations.recordings[1].mounting.reset();
  const std::string why = ReasonAgainst(observations);
  EXPECT_THAT(why, HasSubstr("forearm"));
  EXPECT_THAT(why, HasSubstr("calibration"));
}

TEST_P(EveryMethod, RefusesAHandWithoutTheForearmThatItHangsOn) {
  const Scenario scenario = MakeScenario(BriskScenario(16));
  Trial trial = Simulate(scenario, {}).trial;
  AddHand(scenario, trial);
  trial.observations.recordings.erase(trial.observations.recordings.begin() + 1);
  EXPECT_THAT(ReasonAgainst(trial.observations), HasSubstr("forearm"));
}

TEST_P(EveryMethod, GivesTheSameBitsTwice) {
  const Observations observations = Brisk(16).observations;
  const Estimate a = Estimated(observations), b = Estimated(observations);
  for (const auto& [segment, q_WB] : a.q_WB)
    for (std::size_t i = 0; i < q_WB.size(); ++i)
      ASSERT_EQ(q_WB[i].coeffs(), b.q_WB.at(segment)[i].coeffs());
  for (const auto& [name, p_W] : a.p_W)
    for (std::size_t i = 0; i < p_W.size(); ++i) ASSERT_EQ(p_W[i], b.p_W.at(name)[i]);
  ASSERT_EQ(a.diagnostics.constants.size(), b.diagnostics.constants.size());
  for (std::size_t i = 0; i < a.diagnostics.constants.size(); ++i) {
    EXPECT_EQ(a.diagnostics.constants[i].value, b.diagnostics.constants[i].value);
    EXPECT_EQ(a.diagnostics.constants[i].sd, b.diagnostics.constants[i].sd);
  }
  EXPECT_EQ(a.diagnostics.final_cost, b.diagnostics.final_cost);
}

TEST_P(EveryMethod, GivesUnitQuaternionsAndFiniteNumbersOnTheFirstRecordingsClock) {
  const Observations observations = Brisk(16).observations;
  const Estimate estimate = Estimated(observations);
  EXPECT_EQ(estimate.method, GetParam());
  EXPECT_EQ(estimate.side, observations.arm.side);
  EXPECT_EQ(estimate.time, observations.recordings.front().time);
  ASSERT_TRUE(estimate.q_WB.contains(Segment::kForearm));
  for (const auto& [segment, q_WB] : estimate.q_WB) {
    ASSERT_EQ(q_WB.size(), estimate.time.size());
    for (const Eigen::Quaterniond& q : q_WB) ASSERT_NEAR(q.norm(), 1.0, 1e-12);
  }
  for (const auto& [segment, sd_B] : estimate.sd_B) {
    ASSERT_EQ(sd_B.size(), estimate.time.size()) << Name(segment);
    for (const Eigen::Vector3d& sd : sd_B) ASSERT_TRUE((sd.array() > 0).all()) << Name(segment);
  }
  for (const auto& [name, p_W] : estimate.p_W) {
    ASSERT_EQ(p_W.size(), estimate.time.size()) << name;
    for (const Eigen::Vector3d& p : p_W) ASSERT_TRUE(p.allFinite()) << name;
  }
}

TEST_P(EveryMethod, FollowsAnIdealArmOfEitherSide) {
  const Ideals& ideals = kIdeals.at(GetParam());
  for (const Side side : {Side::kRight, Side::kLeft}) {
    const Trial trial = Ideal(side, ideals.carrying_angle);
    EXPECT_LT(RelativeError(Estimated(trial.observations), *trial.reference), ideals.tolerance)
        << Name(side);
  }
}

TEST_P(EveryMethod, FindsTheSameArmWhicheverWayThePersonFaces) {
  Scenario scenario = MakeScenario(BriskScenario(16));
  const Estimate here = Estimated(Simulate(scenario, {}).trial.observations);
  scenario.trunk_heading += 2.0;
  const Estimate turned = Estimated(Simulate(scenario, {}).trial.observations);
  for (const auto& [segment, q_WB] : here.q_WB)
    EXPECT_LT(RmsAngle(q_WB, turned.q_WB.at(segment)), kSameArm) << Name(segment);
}

TEST_P(EveryMethod, FindsTheMirroredArmAsItsMirrorImage) {
  const Trial trial = Brisk(16);
  const Estimate right = Estimated(trial.observations);
  const Estimate left = Estimated(Mirrored(trial).observations);
  std::vector<Eigen::Quaterniond> mirrored;
  for (const Eigen::Quaterniond& q_UF : ForearmInUpperArm(left.q_WB))
    mirrored.push_back(Mirrored(q_UF));
  EXPECT_LT(Worst(Angles(ForearmInUpperArm(right.q_WB), mirrored)), kMirroredArm);
}

INSTANTIATE_TEST_SUITE_P(, EveryMethod, testing::ValuesIn(MethodNames()),
                         [](const auto& method) { return method.param; });

TEST(Estimators, KnowNoMethodOfAnotherName) {
  EXPECT_FALSE(DefaultOptions("no_such_method").has_value());
}

}  // namespace
}  // namespace brachium
