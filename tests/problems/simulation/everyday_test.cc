#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/scenarios.h"

namespace brachium {
namespace {

using Eigen::Vector3d;

Scenario Make(const std::string& name, Side side = Side::kRight, double duration = 60.0) {
  return MakeScenario({.name = name, .seed = 4, .side = side, .duration = duration});
}

TEST(Scenario, IsTheSamePathFourTimesSlowerWhenSlow) {
  const Scenario brisk = Make("daily_brisk", Side::kRight, 65.0);
  const Scenario slow = Make("daily_slow", Side::kRight, 245.0);
  for (double t = 0.0; t < 60.0; t += 0.31) {
    const BodyMotion fast = brisk.At(kRestAtStart + t).forearm;
    const BodyMotion body = slow.At(kRestAtStart + 4 * t).forearm;
    EXPECT_LT(fast.turning.q_AB.angularDistance(body.turning.q_AB), 1e-9);
    EXPECT_LT((fast.joint_W.p - body.joint_W.p).norm(), 1e-9);
    EXPECT_LT((fast.turning.omega_AB_B - 4 * body.turning.omega_AB_B).norm(), 1e-9);
    EXPECT_LT((fast.joint_W.a - 16 * body.joint_W.a).norm(), 1e-8);
  }
}

TEST(Scenario, BeginsWithTheSameMovementsHoweverLongItIs) {
  const Scenario one = Make("daily_brisk", Side::kRight, 60.0);
  const Scenario two = Make("daily_brisk", Side::kRight, 120.0);
  for (double t = 0.0; t < 50.0; t += 0.5)
    EXPECT_NEAR(Elbow(one, t).flexion, Elbow(two, t).flexion, 1e-12);
}

TEST(DailyBrisk, HasTheSpeedsOfBriskMovementAndAWanderingShoulder) {
  const Scenario scenario = Make("daily_brisk", Side::kRight, 300.0);
  double peak = 0.0, squares = 0.0;
  Vector3d mean = Vector3d::Zero(), power = Vector3d::Zero();
  constexpr int kCount = 30000;
  for (int i = 0; i < kCount; ++i) {
    const ArmMotion arm = scenario.At(0.01 * i);
    const double speed = arm.forearm.turning.omega_AB_B.norm();
    peak = std::max(peak, speed);
    squares += speed * speed;
    mean += arm.upper_arm.joint_W.p / kCount;
    power += arm.upper_arm.joint_W.p.cwiseAbs2() / kCount;
  }
  EXPECT_GT(peak, 250 * kDegree);
  EXPECT_LT(peak, 600 * kDegree);
  EXPECT_NEAR(std::sqrt(squares / kCount), 120 * kDegree, 40 * kDegree);
  const double rms = std::sqrt((power - mean.cwiseAbs2()).sum() / 3.0);
  EXPECT_NEAR(rms, 0.03, 0.005);
}

TEST(Reach, FlexesTheElbowToAHundredDegreesAgainAndAgain) {
  const Scenario scenario = Make("reach");
  int times = 0;
  bool flexed = false;
  for (double t = 0.0; t < 60.0; t += 0.01) {
    const double flexion = Elbow(scenario, t).flexion;
    EXPECT_LT(flexion, 100 * kDegree + 1e-9);
    if (!flexed && flexion > 99.9 * kDegree) ++times;
    flexed = flexion > 99.9 * kDegree || (flexed && flexion > 90 * kDegree);
  }
  EXPECT_GE(times, 16);  // twice in each cycle
}

TEST(Shrug, LiftsTheShoulderByEightCentimetresWhileTheArmHangs) {
  const Scenario scenario = Make("shrug");
  const double rest = scenario.At(0.0).upper_arm.joint_W.p.z();
  double top = 0.0, bottom = 0.0;
  for (double t = 0.0; t < 60.0; t += 0.01) {
    const ArmMotion arm = scenario.At(t);
    top = std::max(top, arm.upper_arm.joint_W.p.z() - rest);
    bottom = std::min(bottom, arm.upper_arm.joint_W.p.z() - rest);
    EXPECT_LT(ShoulderElevation(arm.upper_arm.turning.q_AB), 15 * kDegree);
    EXPECT_LT(Elbow(scenario, t).flexion, 15 * kDegree);
  }
  EXPECT_NEAR(top, 0.08, 0.012);
  EXPECT_NEAR(bottom, 0.0, 0.012);
}

TEST(Shrug, PausesBetweenMovementsForUpToFourSeconds) {
  const Scenario scenario = Make("shrug", Side::kRight, 300.0);
  std::vector<double> pauses;
  double still = 0.0;
  for (double t = kRestAtStart + 1.0; t < 290.0; t += 0.01) {
    if (scenario.At(t).upper_arm.joint_W.v.norm() == 0.0) {
      still += 0.01;
    } else if (still > 0.0) {
      pauses.push_back(still);
      still = 0.0;
    }
  }
  ASSERT_GT(pauses.size(), 50u);
  const auto [shortest, longest] = std::minmax_element(pauses.begin(), pauses.end());
  EXPECT_GT(*shortest, 0.18);
  EXPECT_LT(*shortest, 1.0);
  EXPECT_GT(*longest, 3.0);
  EXPECT_LT(*longest, 4.5);
}

TEST(ForearmRotation, TurnsTheBentForearmToAndFroAndLabelsEachCycle) {
  for (const Side side : {Side::kRight, Side::kLeft}) {
    const Scenario scenario = Make("forearm_rotation", side, 20.0);
    EXPECT_GE(scenario.intervals.size(), 3u);
    for (const Interval& cycle : scenario.intervals) {
      EXPECT_EQ(cycle.label, "cycle:forearm_rotation");
      double least = 180 * kDegree, most = 0.0;
      for (double t = cycle.start; t <= cycle.end; t += 0.01) {
        const ElbowAngles elbow = Elbow(scenario, t);
        EXPECT_NEAR(elbow.flexion, 90 * kDegree, 1e-9);
        least = std::min(least, elbow.pronation);
        most = std::max(most, elbow.pronation);
      }
      EXPECT_NEAR(least, 30 * kDegree, 0.1 * kDegree);
      EXPECT_NEAR(most, 150 * kDegree, 0.1 * kDegree);
    }
  }
}

}  // namespace
}  // namespace brachium
