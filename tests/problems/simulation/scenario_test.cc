#include "problems/simulation/scenario.h"

#include <gtest/gtest.h>

#include <cmath>

#include "problems/joint_angles.h"
#include "problems/rotation.h"
#include "tests/support/scenarios.h"

namespace brachium {
namespace {

using Eigen::Vector3d;

constexpr Segment kWearable[] = {Segment::kGirdle, Segment::kUpperArm, Segment::kForearm,
                                 Segment::kHand};

void ExpectStill(const ArmMotion& arm) {
  for (const Segment segment : kWearable) {
    const BodyMotion& body = arm[segment];
    EXPECT_LT(body.turning.omega_AB_B.norm(), 1e-13);
    EXPECT_LT(body.turning.alpha_AB_B.norm(), 1e-13);
    EXPECT_LT(body.joint_W.v.norm(), 1e-13);
    EXPECT_LT(body.joint_W.a.norm(), 1e-13);
  }
}

TEST(Scenario, IsStillAtBothEnds) {
  ForAllScenarios([](const Scenario& scenario) {
    for (double t = 0.0; t <= kRestAtStart; t += 0.25) ExpectStill(scenario.At(t));
    for (double t = 0.0; t <= kRestAtEnd; t += 0.25)
      ExpectStill(scenario.At(scenario.options.duration - t));
  });
}

TEST(Scenario, StartsAndEndsHangingWithTheThumbForwardUnlessItIsARig) {
  ForAllScenarios([](const Scenario& scenario) {
    for (const double t : {0.0, 2.9, scenario.options.duration}) {
      const double elevation = ShoulderElevation(scenario.At(t).upper_arm.turning.q_AB);
      EXPECT_NEAR(Elbow(scenario, t).flexion, scenario.rig ? 0.0 : 10 * kDegree, 1e-12);
      EXPECT_NEAR(Elbow(scenario, t).pronation, scenario.rig ? 0.0 : 90 * kDegree, 1e-12);
      EXPECT_NEAR(elevation, scenario.rig ? 90 * kDegree : 8 * kDegree, 1e-12);
    }
  });
}

TEST(Scenario, MovesBetweenTheRestsUnlessItIsAStaticPose) {
  ForAllScenarios([](const Scenario& scenario) {
    double path = 0.0;
    for (double t = 0.0; t < scenario.options.duration; t += 0.01)
      path += 0.01 * scenario.At(t).wrist_W.v.norm();
    if (scenario.options.name == "static_pose")
      EXPECT_EQ(path, 0.0);
    else
      EXPECT_GT(path, 0.25);
  });
}

TEST(Scenario, KeepsTheSegmentsLengths) {
  ForAllScenarios([](const Scenario& scenario) {
    const ArmShape& shape = scenario.shape;
    const double girdle = shape.DistalJoint(Segment::kGirdle).norm();
    for (double t = 0.0; t < scenario.options.duration; t += 0.37) {
      const ArmMotion arm = scenario.At(t);
      const Vector3d shoulder = arm.upper_arm.joint_W.p, elbow = arm.forearm.joint_W.p;
      EXPECT_NEAR((shoulder - arm.girdle.joint_W.p).norm(), girdle, 1e-12);
      EXPECT_NEAR((elbow - shoulder).norm(), shape.upper_arm, 1e-12);
      EXPECT_NEAR((arm.wrist_W.p - elbow).norm(), shape.forearm, 1e-12);
      EXPECT_NEAR((arm.fingertip_W.p - arm.wrist_W.p).norm(), shape.hand, 1e-12);
      const Vector3d down_U = arm.upper_arm.turning.q_AB * shape.DistalJoint(Segment::kUpperArm);
      EXPECT_TRUE((elbow - shoulder).isApprox(down_U, 1e-12));
    }
  });
}

bool IsConsistent(const BodyMotion& before, const BodyMotion& here, const BodyMotion& after,
                  double step) {
  const auto near = [](const Vector3d& a, const Vector3d& b) { return (a - b).norm() < 2e-4; };
  const Vector3d turn = Log<double>(before.turning.q_AB.conjugate() * after.turning.q_AB);
  return near(here.turning.omega_AB_B, turn / (2 * step)) &&
         near(here.turning.alpha_AB_B,
              (after.turning.omega_AB_B - before.turning.omega_AB_B) / (2 * step)) &&
         near(here.joint_W.v, (after.joint_W.p - before.joint_W.p) / (2 * step)) &&
         near(here.joint_W.a, (after.joint_W.v - before.joint_W.v) / (2 * step));
}

// Between whole milliseconds, where minimum-jerk movements may begin.
TEST(Scenario, HasTheDerivativesItClaims) {
  constexpr double kStep = 1e-5;
  ForAllScenarios([](const Scenario& scenario) {
    for (double t = 2.0005; t < scenario.options.duration; t += 0.23) {
      const ArmMotion before = scenario.At(t - kStep), here = scenario.At(t),
                      after = scenario.At(t + kStep);
      for (const Segment segment : kWearable)
        EXPECT_TRUE(IsConsistent(before[segment], here[segment], after[segment], kStep))
            << t << ' ' << Name(segment);
    }
  });
}

// Boone & Azen 1979, with what a person can still do comfortably; the elbow's own stops.
void ExpectWithinTheJointsRanges(const Scenario& scenario, double step) {
  for (double t = 0.0; t < scenario.options.duration; t += step) {
    const MovingJoints q = scenario.JointsAt(t);
    const auto expect_within = [&](Joint joint, double low, double high) {
      EXPECT_GE(q[joint].value, low * kDegree) << "joint " << joint << " at " << t;
      EXPECT_LE(q[joint].value, high * kDegree) << "joint " << joint << " at " << t;
    };
    expect_within(kShoulderFlexion, -45, 170);
    expect_within(kShoulderAbduction, -45, 175);
    expect_within(kShoulderRotation, -70, 100);
    expect_within(kElbowFlexion, 0, 145);
    expect_within(kForearmPronation, 0, 180);
    expect_within(kWristFlexion, -75, 80);
    expect_within(kWristDeviation, -21, 39);
    EXPECT_LT(std::abs(Elbow(scenario, t).carrying), 25 * kDegree) << t;
  }
}

TEST(Scenario, KeepsWithinTheJointsRanges) {
  ForAllScenarios([](const Scenario& scenario) { ExpectWithinTheJointsRanges(scenario, 0.05); });
  for (const std::string& name : ScenarioNames())
    for (std::uint64_t seed = 10; seed < 20; ++seed) {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      ExpectWithinTheJointsRanges(MakeUsual(name, Side::kRight, seed), 0.2);
    }
}

TEST(Scenario, HasTheAnglesOfItsJointsInItsPoses) {
  ForAllScenarios([](const Scenario& scenario) {
    for (double t = 0.0; t < scenario.options.duration; t += 1.3) {
      const MovingJoints q = scenario.JointsAt(t);
      EXPECT_NEAR(Elbow(scenario, t).flexion, q[kElbowFlexion].value, 1e-9);
      EXPECT_NEAR(Elbow(scenario, t).pronation, q[kForearmPronation].value, 1e-9);
      const WristAngles wrist = WristOf(scenario, t);
      EXPECT_NEAR(wrist.flexion, q[kWristFlexion].value, 1e-9);
      EXPECT_NEAR(wrist.deviation, q[kWristDeviation].value, 1e-9);
      EXPECT_NEAR(wrist.rotation, 0.0, 1e-9);
    }
  });
}

TEST(Scenario, OfALeftArmIsTheMirrorImageOfTheRight) {
  for (const std::string& name : ScenarioNames()) {
    const Scenario right = MakeUsual(name), left = MakeUsual(name, Side::kLeft);
    for (double t = 0.0; t < right.options.duration; t += 0.7) {
      EXPECT_NEAR(Elbow(left, t).flexion, Elbow(right, t).flexion, 1e-9);
      EXPECT_NEAR(Elbow(left, t).carrying, Elbow(right, t).carrying, 1e-9);
      EXPECT_NEAR(Elbow(left, t).pronation, Elbow(right, t).pronation, 1e-9);
      EXPECT_NEAR(WristOf(left, t).deviation, WristOf(right, t).deviation, 1e-9);
      const Vector3d p = right.At(t).fingertip_W.p;
      EXPECT_TRUE(left.At(t).fingertip_W.p.isApprox(Vector3d(p.x(), -p.y(), p.z()), 1e-12));
      const Vector3d c7 = right.At(t).girdle.joint_W.p;
      EXPECT_NEAR((left.At(t).girdle.joint_W.p - Vector3d(c7.x(), -c7.y(), c7.z())).norm(), 0.0,
                  1e-12);
    }
  }
}

TEST(Scenario, IsTheSameForTheSameSeedAndAnotherOneForAnother) {
  for (const std::string& name : ScenarioNames()) {
    if (name == "goniometer_steps" || name == "goniometer_swing") continue;  // nothing is drawn
    const Scenario one = MakeUsual(name), again = MakeUsual(name),
                   other = MakeUsual(name, Side::kRight, 5);
    const double t = 0.5 * one.options.duration;
    EXPECT_EQ(one.At(t).wrist_W.p, again.At(t).wrist_W.p) << name;
    EXPECT_GT((one.At(t).wrist_W.p - other.At(t).wrist_W.p).norm(), 1e-3) << name;
  }
}

// With several seeds: what is drawn must not carry the movements beyond the trial's end.
TEST(Scenario, EndsItsMovementsBeforeTheRestAtTheEnd) {
  for (const std::string& name : ScenarioNames())
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const Scenario scenario = MakeUsual(name, Side::kRight, seed);
      const double end = scenario.options.duration - kRestAtEnd;
      for (const TrueValue& fact : scenario.facts)
        if (fact.name == "movements.end_s") {
          EXPECT_LE(fact.value.back(), end + 1e-9) << name;
        }
      for (const Interval& interval : scenario.intervals)
        EXPECT_LE(interval.end, end + 1e-9) << name << ' ' << interval.label;
    }
}

TEST(Scenario, IsTheSamePathSlowerWhenSlow) {
  for (const char* name : {"daily_brisk", "circle", "eating", "nine_hole_peg_test"}) {
    const Scenario brisk = MakeUsual(name);
    ScenarioOptions options = brisk.options;
    options.time_scale = 4.0;
    options.duration =
        kRestAtStart + kRestAtEnd + 4.0 * (brisk.options.duration - kRestAtStart - kRestAtEnd);
    const Scenario slow = MakeScenario(options);
    for (double t = 0.0; t < brisk.options.duration - 5.0; t += 0.31) {
      const BodyMotion fast = brisk.At(kRestAtStart + t).forearm;
      const BodyMotion body = slow.At(kRestAtStart + 4 * t).forearm;
      EXPECT_LT(fast.turning.q_AB.angularDistance(body.turning.q_AB), 0.01) << name;
      EXPECT_LT((fast.joint_W.p - body.joint_W.p).norm(), 0.004) << name;
    }
  }
}

TEST(Scenario, HasTheCarryingAngleItWasGivenAndAdductionAboutIt) {
  for (const Side side : {Side::kRight, Side::kLeft}) {
    const Scenario scenario =
        MakeScenario({.name = "daily_brisk", .seed = 4, .side = side, .duration = 300.0});
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

TEST(ScenarioOptions, SayWhatIsWrong) {
  std::string why;
  for (const std::string& name : ScenarioNames()) {
    ScenarioOptions options{.name = name};
    options.duration = UsualDuration(options);
    EXPECT_TRUE(options.IsValid(&why)) << why;
    options.duration = 4.0;
    EXPECT_FALSE(options.IsValid(&why)) << name;
  }
  EXPECT_FALSE(ScenarioOptions{.name = "flying"}.IsValid(&why));
  EXPECT_EQ(why, "scenario.name \"flying\" is not a known scenario");
  EXPECT_FALSE((ScenarioOptions{.name = "daily_slow", .duration = 30.0}.IsValid(&why)));
  EXPECT_EQ(why, "scenario.duration: daily_slow takes 45 s or more, rests and slowness included");
  EXPECT_FALSE(ScenarioOptions{.time_scale = 0.0}.IsValid(&why));
  EXPECT_EQ(why, "scenario.time_scale must be > 0");
  EXPECT_FALSE(ScenarioOptions{.adduction_rms = -1.0}.IsValid(&why));
  EXPECT_FALSE(ScenarioOptions{.carrying_angle = 1.1}.IsValid(&why));
  EXPECT_FALSE(ScenarioOptions{.patient_week = 3}.IsValid(&why));
  EXPECT_EQ(why, "scenario.patient_week: daily_brisk is not done by a patient");
  EXPECT_FALSE((ScenarioOptions{.name = "range_of_motion", .patient_week = 11}.IsValid(&why)));
}

}  // namespace
}  // namespace brachium
