#include "problems/simulation/scenario.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "problems/joint_angles.h"
#include "problems/rotation.h"
#include "problems/simulation/mirror.h"

namespace brachium {
namespace {

using Eigen::Vector3d;

constexpr Side kSides[] = {Side::kRight, Side::kLeft};

Scenario Make(const std::string& name, Side side = Side::kRight, double duration = 60.0) {
  return MakeScenario({.name = name, .seed = 4, .side = side, .duration = duration});
}

ElbowAngles Elbow(const Scenario& scenario, double t) {
  const ArmMotion arm = scenario.At(t);
  return ElbowAnglesFrom(arm.upper_arm.turning.q_AB.conjugate() * arm.forearm.turning.q_AB,
                         scenario.options.side);
}

// Calls check(scenario) for every scenario and both sides.
template <typename Check>
void ForAll(const Check& check) {
  for (const std::string& name : ScenarioNames())
    for (const Side side : kSides) {
      SCOPED_TRACE(name + ", " + std::string(Name(side)));
      check(Make(name, side));
    }
}

void ExpectStill(const ArmMotion& arm) {
  for (const BodyMotion& body : {arm.upper_arm, arm.forearm}) {
    EXPECT_EQ(body.turning.omega_AB_B, Vector3d::Zero());
    EXPECT_EQ(body.turning.alpha_AB_B, Vector3d::Zero());
    EXPECT_EQ(body.joint_W.v, Vector3d::Zero());
    EXPECT_EQ(body.joint_W.a, Vector3d::Zero());
  }
}

TEST(Scenario, IsStillAtBothEnds) {
  ForAll([](const Scenario& scenario) {
    for (double t = 0.0; t <= kRestAtStart; t += 0.25) ExpectStill(scenario.At(t));
    for (double t = 0.0; t <= kRestAtEnd; t += 0.25)
      ExpectStill(scenario.At(scenario.options.duration - t));
  });
}

TEST(Scenario, StartsAndEndsHangingWithTheThumbForward) {
  ForAll([](const Scenario& scenario) {
    for (const double t : {0.0, 2.9, scenario.options.duration}) {
      EXPECT_NEAR(Elbow(scenario, t).flexion, 10 * kDegree, 1e-12);
      EXPECT_NEAR(Elbow(scenario, t).pronation, 90 * kDegree, 1e-12);
      EXPECT_NEAR(ShoulderElevation(scenario.At(t).upper_arm.turning.q_AB), 8 * kDegree, 1e-12);
    }
  });
}

TEST(Scenario, MovesBetweenTheRests) {
  ForAll([](const Scenario& scenario) {
    double path = 0.0;
    for (double t = 0.0; t < 60.0; t += 0.01) path += 0.01 * scenario.At(t).wrist_W.v.norm();
    EXPECT_GT(path, 1.0);
  });
}

TEST(Scenario, KeepsTheSegmentsLengths) {
  ForAll([](const Scenario& scenario) {
    for (double t = 0.0; t < 60.0; t += 0.37) {
      const ArmMotion arm = scenario.At(t);
      const Vector3d elbow = arm.forearm.joint_W.p;
      EXPECT_NEAR((elbow - arm.upper_arm.joint_W.p).norm(), 0.31, 1e-12);
      EXPECT_NEAR((arm.wrist_W.p - elbow).norm(), 0.26, 1e-12);
      const Vector3d down_U = arm.upper_arm.turning.q_AB * Vector3d(0.0, -0.31, 0.0);
      EXPECT_TRUE((elbow - arm.upper_arm.joint_W.p).isApprox(down_U, 1e-12));
    }
  });
}

TEST(Scenario, HasTheDerivativesItClaims) {
  constexpr double kStep = 1e-5;
  const auto body_is_consistent = [](const BodyMotion& before, const BodyMotion& here,
                                     const BodyMotion& after) {
    const auto near = [](const Vector3d& a, const Vector3d& b) { return (a - b).norm() < 1e-5; };
    const Vector3d turn = Log<double>(before.turning.q_AB.conjugate() * after.turning.q_AB);
    return near(here.turning.omega_AB_B, turn / (2 * kStep)) &&
           near(here.turning.alpha_AB_B,
                (after.turning.omega_AB_B - before.turning.omega_AB_B) / (2 * kStep)) &&
           near(here.joint_W.v, (after.joint_W.p - before.joint_W.p) / (2 * kStep)) &&
           near(here.joint_W.a, (after.joint_W.v - before.joint_W.v) / (2 * kStep));
  };
  ForAll([&](const Scenario& scenario) {
    for (double t = 2.0; t < 60.0; t += 0.23) {
      const ArmMotion before = scenario.At(t - kStep), here = scenario.At(t),
                      after = scenario.At(t + kStep);
      EXPECT_TRUE(body_is_consistent(before.upper_arm, here.upper_arm, after.upper_arm)) << t;
      EXPECT_TRUE(body_is_consistent(before.forearm, here.forearm, after.forearm)) << t;
    }
  });
}

TEST(Scenario, KeepsWithinEverydayJointLimits) {
  ForAll([](const Scenario& scenario) {
    if (scenario.options.name == "calibration") return;  // palm down is the end of the range
    for (double t = 0.0; t < 60.0; t += 0.05) {
      const ElbowAngles elbow = Elbow(scenario, t);
      EXPECT_GT(elbow.flexion, 0.0);
      EXPECT_LT(elbow.flexion, 145 * kDegree);
      EXPECT_GT(elbow.pronation, 0.0);
      EXPECT_LT(elbow.pronation, 170 * kDegree);
      EXPECT_LT(std::abs(elbow.carrying), 25 * kDegree);
      EXPECT_LT(ShoulderElevation(scenario.At(t).upper_arm.turning.q_AB), 135 * kDegree);
    }
  });
}

TEST(Scenario, HasTheCarryingAngleItWasGivenAndAdductionAboutIt) {
  for (const Side side : kSides) {
    const Scenario scenario = Make("daily_brisk", side, 300.0);
    double sum = 0.0, squares = 0.0;
    int count = 0;
    for (double t = 0.0; t < 300.0; t += 0.05, ++count) {
      const ElbowAngles elbow = Elbow(scenario, t);
      const double adduction =
          elbow.carrying - (8 * kDegree + 3 * kDegree * std::cos(elbow.flexion));
      sum += adduction;
      squares += adduction * adduction;
    }
    EXPECT_NEAR(sum / count, 0.0, 0.5 * kDegree);
    EXPECT_NEAR(std::sqrt(squares / count), 3 * kDegree, 0.5 * kDegree);
  }
}

TEST(Scenario, OfALeftArmIsTheMirrorImageOfTheRight) {
  for (const std::string& name : ScenarioNames()) {
    const Scenario right = Make(name), left = Make(name, Side::kLeft);
    for (double t = 0.0; t < 60.0; t += 0.7) {
      EXPECT_NEAR(Elbow(left, t).flexion, Elbow(right, t).flexion, 1e-9);
      EXPECT_NEAR(Elbow(left, t).carrying, Elbow(right, t).carrying, 1e-9);
      EXPECT_NEAR(Elbow(left, t).pronation, Elbow(right, t).pronation, 1e-9);
      const Vector3d p = right.At(t).wrist_W.p;
      EXPECT_TRUE(left.At(t).wrist_W.p.isApprox(Vector3d(p.x(), -p.y(), p.z()), 1e-12));
    }
  }
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

TEST(Scenario, IsAnotherOneForAnotherSeed) {
  const Scenario one = MakeScenario({.seed = 1}), two = MakeScenario({.seed = 2});
  EXPECT_GT(std::abs(Elbow(one, 10.0).flexion - Elbow(two, 10.0).flexion), 1e-3);
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

TEST(ScenarioOptions, SayWhatIsWrong) {
  std::string why;
  for (const std::string& name : ScenarioNames())
    EXPECT_TRUE(ScenarioOptions{.name = name}.IsValid(&why)) << why;
  EXPECT_FALSE(ScenarioOptions{.name = "flying"}.IsValid(&why));
  EXPECT_EQ(why, "scenario.name \"flying\" is not a known scenario");
  EXPECT_FALSE((ScenarioOptions{.name = "daily_slow", .duration = 30.0}.IsValid(&why)));
  EXPECT_FALSE(ScenarioOptions{.time_scale = 0.0}.IsValid(&why));
  EXPECT_EQ(why, "scenario.time_scale must be > 0");
  EXPECT_FALSE(ScenarioOptions{.adduction_rms = -1.0}.IsValid(&why));
  EXPECT_FALSE(ScenarioOptions{.carrying_angle = 1.0}.IsValid(&why));
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

}  // namespace
}  // namespace brachium
