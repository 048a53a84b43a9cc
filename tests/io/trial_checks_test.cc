#include "io/trial_checks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/spoiled_trials.h"

namespace brachium {
namespace {

// Half a minute each; benchmarks/spoiled_trials.cc tries more and longer ones.
std::vector<Trial> SoundTrials() {
  std::vector<Trial> trials;
  for (const std::string scenario : {"daily_brisk", "daily_slow", "reach"})
    for (const Side side : {Side::kRight, Side::kLeft})
      trials.push_back(SoundTrial({.name = scenario, .side = side, .duration = 30.0}));
  return trials;
}

TEST(TrialChecks, AreSilentOnSoundTrials) {
  for (Trial& trial : SoundTrials()) {
    trial.observations.intervals.push_back({"rest", 0.5, 2.5});
    Orient(trial, [](const Eigen::Quaterniond& q) { return q; });
    EXPECT_EQ(Said(trial), "") << trial.name;
  }
}

TEST(TrialChecks, NameNearlyEveryTrialWithAMistake) {
  const std::vector<Trial> sound = SoundTrials();
  for (const Mistake& mistake : Mistakes()) {
    std::size_t named = 0;
    std::string otherwise;
    for (Trial trial : sound) {
      mistake.make(trial);
      const std::string said = Said(trial);
      if (Names(said, mistake))
        ++named;
      else
        otherwise += trial.name + ": " + said + "\n";
    }
    EXPECT_GE(static_cast<double>(named), 0.95 * static_cast<double>(sound.size()))
        << mistake.what << " is not named in\n"
        << otherwise;
  }
}

// Skin that turns by 3 deg, 8 deg about the upper arm, so that nothing rests between the movements.
SimulationOptions OnSkin() {
  SimulationOptions errors = WornLoosely(3 * kDegree);
  errors.soft_tissue.upper_arm_along_rms = 8 * kDegree;
  return errors;
}

TEST(TrialChecks, AreSilentOnSkinThatMovesWhileTheArmHardlyDoes) {
  for (const std::string scenario : {"goniometer_steps", "static_pose", "shrug", "daily_slow"}) {
    ScenarioOptions options{.name = scenario};
    options.duration = UsualDuration(options);
    EXPECT_EQ(Said(SoundTrial(options, OnSkin())), "") << scenario;
  }
}

// Chance and skin explain much of few movements: of the carrying angle, of the force and of both.
TEST(TrialChecks, AreSilentOnShortTrialsOfFewMovements) {
  const SimulationOptions skin = WornLoosely(1 * kDegree);
  const ScenarioOptions scenarios[] = {{.name = "daily_slow", .seed = 1505, .duration = 30.0},
                                       {.name = "daily_slow", .seed = 2014, .duration = 30.0},
                                       {.name = "daily_slow", .seed = 2004, .duration = 40.0},
                                       {.name = "goniometer_steps", .seed = 1305},
                                       {.name = "goniometer_swing", .seed = 2035}};
  for (const ScenarioOptions& scenario : scenarios)
    EXPECT_EQ(Said(SoundTrial(scenario, skin)), "") << scenario.name;
}

TEST(TrialChecks, NameRatesExchangedSensorsAndClocksOnSkin) {
  std::vector<Trial> sound;
  for (const std::string scenario : {"daily_brisk", "daily_slow", "reach"})
    sound.push_back(SoundTrial({.name = scenario}, WornLoosely(3 * kDegree)));
  for (const Mistake& mistake : Mistakes()) {
    if (mistake.name != "rate" && mistake.name != "sensors_swapped" && mistake.name != "clock")
      continue;
    for (Trial trial : sound) {
      mistake.make(trial);
      EXPECT_TRUE(Names(Said(trial), mistake)) << trial.name << ", " << mistake.what;
    }
  }
}

// Its place for the elbow stays: only the carrying angle tells.
TEST(TrialChecks, NameASensorThatTurnsAboutTheUpperArm) {
  Trial trial = SoundTrial({.name = "daily_brisk"});
  Recording& upper = Upper(trial);
  const Eigen::Vector3d axis_S = upper.mounting->q_BS.conjugate() * Eigen::Vector3d::UnitY();
  const Eigen::Quaterniond turn = Exp<double>(Eigen::Vector3d(-30 * kDegree * axis_S));
  for (std::size_t i = upper.size() / 2; i < upper.size(); ++i) {
    upper.acc_S[i] = turn * upper.acc_S[i];
    upper.gyr_S[i] = turn * upper.gyr_S[i];
  }
  EXPECT_THAT(Said(trial), testing::HasSubstr("[slip]"));
}

TEST(TrialChecks, TakeTheGravityOfThePlaceAsTold) {
  Trial trial = SoundTrial({.name = "reach", .duration = 20.0});
  for (Recording& recording : trial.observations.recordings)
    Scale(recording.acc_S, 9.50 / kGravity);
  trial.observations.gravity = 9.78;
  EXPECT_EQ(Said(trial), "");
  trial.observations.gravity = 9.85;
  EXPECT_THAT(Said(trial), testing::HasSubstr("[gravity]"));
}

Trial Touching(const std::vector<double>& times) {
  Trial trial = SoundTrial({.name = "daily_brisk", .duration = 30.0});
  trial.observations.contacts = {{.place = "cup", .segment = Segment::kForearm, .times = times}};
  return trial;
}

TEST(TrialChecks, NameContactsOfOneInstantAndOfAnArmThatMoves) {
  EXPECT_EQ(Said(Touching({0.5, 2.0, 29.0})), "");
  EXPECT_THAT(Said(Touching({0.5})), testing::HasSubstr("[single_contact]"));
  EXPECT_THAT(Said(Touching({0.5, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0})),
              testing::HasSubstr("[moving_contact]"));
}

TEST(TrialChecks, NameAnAccelerometerTurnedRoundInAToldEndPose) {
  Trial trial = SoundTrial({.name = "daily_brisk", .duration = 30.0});
  trial.observations.start_pose.reset();
  for (Recording& recording : trial.observations.recordings) Scale(recording.acc_S, -1.0);
  EXPECT_THAT(Said(trial), testing::Not(testing::HasSubstr("in the end pose")));
  trial.observations.end_pose = HeldPose{
      .time = 29.5, .elbow_flexion = 0.2, .forearm_pronation = {}, .shoulder_elevation = 0.0};
  EXPECT_THAT(Said(trial), testing::HasSubstr("in the end pose, hanging"));
}

}  // namespace
}  // namespace brachium
