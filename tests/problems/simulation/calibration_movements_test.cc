#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "tests/support/scenarios.h"

namespace brachium {
namespace {

using Eigen::Vector3d;

constexpr Side kSides[] = {Side::kRight, Side::kLeft};

Scenario Make(const std::string& name, Side side = Side::kRight, double duration = 60.0) {
  return MakeScenario({.name = name, .seed = 4, .side = side, .duration = duration});
}

void ExpectStill(const ArmMotion& arm) {
  for (const BodyMotion& body : {arm.upper_arm, arm.forearm}) {
    EXPECT_EQ(body.turning.omega_AB_B, Vector3d::Zero());
    EXPECT_EQ(body.joint_W.a, Vector3d::Zero());
  }
}

TEST(Scenario, OfACalibrationLabelsFiveOfEachMovementFromARestToARest) {
  for (const Side side : kSides) {
    const Scenario scenario = Make("calibration", side);
    std::map<std::string, int> count;
    for (const Interval& interval : scenario.intervals) {
      ++count[interval.label];
      for (const double t : {interval.start, interval.start + 0.25, interval.end - 0.25})
        ExpectStill(scenario.At(t));
      EXPECT_LT(interval.end, 60.0 - kRestAtEnd);
    }
    for (const char* movement :
         {"forearm_pronation", "forearm_supination", "upper_arm_endorotation",
          "upper_arm_exorotation", "upper_arm_abduction"})
      EXPECT_EQ(count["calibration:" + std::string(movement)], 5) << movement;
    EXPECT_EQ(count["calibration:static_pose"], 1);
  }
}

TEST(Scenario, OfACalibrationHasThePalmDownBeforeSupinationAndAfterPronation) {
  for (const Side side : kSides) {
    const Scenario scenario = Make("calibration", side);
    for (const Interval& interval : scenario.intervals) {
      const bool before = interval.label == "calibration:forearm_supination";
      if (!before && interval.label != "calibration:forearm_pronation") continue;
      const ArmMotion arm = scenario.At(before ? interval.start : interval.end);
      EXPECT_LT((arm.forearm.turning.q_AB * Vector3d::UnitX()).z(), -0.999);
    }
  }
}

TEST(Scenario, OfACalibrationIsRefusedATimeThatIsTooShortForIt) {
  std::string why;
  EXPECT_FALSE((ScenarioOptions{.name = "calibration", .duration = 50}.IsValid(&why)));
  EXPECT_TRUE((ScenarioOptions{.name = "calibration", .duration = 60}.IsValid(&why))) << why;
}

TEST(Scenario, OfACalibrationMayBeExecutedImperfectly) {
  const Scenario exact = Make("calibration");
  ScenarioOptions options = exact.options;
  options.execution_error = 5 * kDegree;
  const Scenario poor = MakeScenario(options);
  double squares = 0.0;
  int count = 0;
  for (const Interval& interval : exact.intervals) {
    const MovingJoints wanted = exact.JointsAt(interval.end), got = poor.JointsAt(interval.end);
    if (interval.end < kRestAtStart) continue;
    for (const Joint joint : {kShoulderFlexion, kShoulderAbduction, kElbowFlexion}) {
      squares += std::pow(got[joint].value - wanted[joint].value, 2);
      ++count;
    }
  }
  EXPECT_NEAR(std::sqrt(squares / count), 5 * kDegree, 1.5 * kDegree);
  EXPECT_NEAR(Elbow(poor, 60.0).flexion, 10 * kDegree, 1e-12);
}

TEST(ShoulderStill, LabelsTwentyReachesBetweenRestsWithAShoulderThatKeepsItsPlace) {
  for (const Side side : kSides) {
    const Scenario scenario = MakeUsual("shoulder_still", side);
    int reaches = 0;
    const Vector3d shoulder = scenario.At(0.0).upper_arm.joint_W.p;
    for (const Interval& interval : scenario.intervals) {
      if (interval.label != "calibration:shoulder_still") continue;
      ++reaches;
      ExpectStill(scenario.At(interval.start + 0.1));
      ExpectStill(scenario.At(interval.end - 0.1));
      for (double t = interval.start; t < interval.end; t += 0.05)
        EXPECT_LT((scenario.At(t).upper_arm.joint_W.p - shoulder).norm(), 0.015);
    }
    EXPECT_EQ(reaches, 20);
  }
}

TEST(StaticPose, LastsAMinuteAndIsLabelled) {
  const Scenario scenario = MakeUsual("static_pose");
  ASSERT_EQ(scenario.intervals.size(), 1u);
  EXPECT_EQ(scenario.intervals[0].label, "calibration:static_pose");
  EXPECT_GE(scenario.intervals[0].end - scenario.intervals[0].start, 60.0);
  ExpectStill(scenario.At(30.0));
}

}  // namespace
}  // namespace brachium
