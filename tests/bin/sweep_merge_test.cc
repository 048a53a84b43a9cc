#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/sweep_program_test.h"

namespace brachium {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

class SweepMerge : public SweepProgramTest {
 protected:
  void PlanSmall(const std::string& vary = "luinge_adduction_sigma_deg=1:30:4:log") const {
    const std::string trials = Trial("one") + "," + Trial("two", {"--seed=2"}) + "," +
                               Trial("three", {"--seed=3", "--side=left"});
    ASSERT_EQ(Plan(trials, "luinge,luinge_rts", vary).exit_code, 0);
  }

  json Merged() const { return json::parse(ReadText(Path("sweep/sweep.json"))); }
};

TEST_F(SweepMerge, WritesATableTheChoicesAndFiguresAndRepeatsItself) {
  PlanSmall();
  ASSERT_EQ(Sweep("run").exit_code, 0);
  const Outcome outcome = Sweep("merge");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("24 tasks on 3 trials: 24 done"),
                                 HasSubstr("each trial at the point that the others chose")));
  const auto first = Files();
  const std::string& csv = first.at("sweep.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 25);
  EXPECT_THAT(csv,
              HasSubstr("task,trial,method,luinge_adduction_sigma_deg,outcome,trusted,reason,"));
  EXPECT_THAT(first.at("sweep_lines.svg"), AllOf(HasSubstr("rms adduction [deg]"),
                                                 HasSubstr(">luinge<"), HasSubstr(">luinge_rts<")));
  EXPECT_EQ(Sweep("merge").exit_code, 0);
  EXPECT_EQ(Files(), first);
}

TEST_F(SweepMerge, RecommendsThePointOfTheLeastMeanErrorAndJudgesItByOthers) {
  PlanSmall();
  ASSERT_EQ(Sweep("run").exit_code, 0);
  ASSERT_EQ(Sweep("merge").exit_code, 0);
  const json merged = Merged(), method = merged["methods"][0];
  EXPECT_EQ(merged["complete"], true);
  double least = 1e9;
  for (const auto& point : method["points"])
    least = std::min(least, point["mean_error"].get<double>());
  EXPECT_NEAR(method["overall_mean_error"].get<double>(), least, 1e-9);
  double sum = 0.0;
  for (const auto& trial : method["trials"]) {
    EXPECT_LE(trial["best_error"], trial["error_there"]);
    sum += trial["error_there"].get<double>();
  }
  const double expected = method["leave_one_trial_out_mean_error"];
  EXPECT_NEAR(expected, sum / 3.0, 1e-9);
  EXPECT_GE(expected, least - 1e-9);
}

TEST_F(SweepMerge, DrawsAMapForTwoNumbers) {
  PlanSmall("luinge_adduction_sigma_deg=1,10;luinge_acceleration_sigma_m_s2=2,3,4");
  ASSERT_EQ(Sweep("run").exit_code, 0);
  ASSERT_EQ(Sweep("merge").exit_code, 0);
  EXPECT_TRUE(fs::exists(Path(
      "sweep/sweep_map_luinge_luinge_adduction_sigma_deg_luinge_acceleration_sigma_m_s2.svg")));
}

TEST_F(SweepMerge, RefusesAnIncompleteSweepUnlessPartialWhichALaterOneReplaces) {
  PlanSmall();
  ASSERT_EQ(Sweep("run", {"--shard=0/3"}).exit_code, 0);
  const Outcome outcome = Sweep("merge");
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_THAT(outcome.err, HasSubstr("16 tasks are missing"));
  EXPECT_FALSE(fs::exists(Path("sweep/sweep.csv")));
  ASSERT_EQ(Sweep("merge", {"--partial"}).exit_code, 0);
  EXPECT_EQ(Merged()["complete"], false);
  EXPECT_EQ(Merged()["missing"], 16);
  ASSERT_EQ(Sweep("run").exit_code, 0);
  ASSERT_EQ(Sweep("merge").exit_code, 0);
  EXPECT_EQ(Merged()["complete"], true);
}

TEST_F(SweepMerge, ChoosesByAnotherFigureOnlyWhenAsked) {
  PlanSmall();
  ASSERT_EQ(Sweep("run").exit_code, 0);
  ASSERT_EQ(Sweep("merge").exit_code, 0);
  const Outcome unknown = Sweep("merge", {"--figure=joint_angles.elbow_flexion.rms_deg"});
  EXPECT_EQ(unknown.exit_code, 1);
  EXPECT_THAT(unknown.err, HasSubstr("did you mean 'joint_angles.elbow_flexion.rmse_deg'?"));
  const std::string other = "--figure=joint_angles.elbow_flexion.rmse_deg";
  EXPECT_EQ(Sweep("merge", {other}).exit_code, 1);
  EXPECT_EQ(Sweep("merge", {other, "--overwrite"}).exit_code, 0);
  EXPECT_EQ(Merged()["figure"], "joint_angles.elbow_flexion.rmse_deg");
}

TEST_F(SweepMerge, CountsAMethodThatRefusesATrialAsDone) {
  Trial("ball");
  json trial = json::parse(ReadText(Path("ball/trial.json")));
  trial["arm"]["elbow"] = {{"constraint", "none"}};
  Write("ball/trial.json", trial.dump());
  ASSERT_EQ(Plan(Path("ball"), "gyroscope,luinge", "luinge_adduction_sigma_deg=1,2").exit_code, 0);
  ASSERT_EQ(Sweep("run").exit_code, 0);
  ASSERT_EQ(Sweep("merge").exit_code, 0);
  EXPECT_EQ(Merged()["refused"], 2);
  EXPECT_TRUE(Merged()["methods"][1]["overall"].is_null());
}

TEST_F(SweepMerge, IsWhatSubmittingToThisMachineEndsWith) {
  PlanSmall();
  EXPECT_THAT(Sweep("submit", {"--engine=local", "--dry_run"}).out, HasSubstr("sweep run"));
  ASSERT_EQ(Sweep("submit", {"--engine=local"}).exit_code, 0);
  EXPECT_EQ(Merged()["complete"], true);
  EXPECT_EQ(Sweep("submit", {"--engine=locl"}).exit_code, 1);
}

TEST_F(SweepMerge, ShowsTheScriptsForSlurmWithoutSubmitting) {
  PlanSmall();
  ASSERT_EQ(Sweep("run", {"--task=3"}).exit_code, 0);
  const Outcome outcome =
      Sweep("submit", {"--dry_run", "--account=lab", "--at_a_time=7", "--shard_minutes=0.0000001"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("#SBATCH --array=0-2,4-23%7\n"), HasSubstr("#SBATCH --account=lab\n"),
                    HasSubstr("/24\n"), HasSubstr("sweep merge")));
  EXPECT_FALSE(fs::exists(Path("sweep/slurm")));
}

}  // namespace
}  // namespace brachium
