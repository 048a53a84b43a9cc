#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <thread>

#include "tests/support/own_child.h"
#include "tests/support/sweep_program_test.h"

namespace brachium {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

class SweepRun : public SweepProgramTest {
 protected:
  // Two trials, two methods, four points.
  void PlanSmall() const {
    ASSERT_EQ(Plan(Trial("one") + "," + Trial("two", {"--seed=2"}), "luinge,luinge_rts",
                   "luinge_adduction_sigma_deg=1:30:4:log")
                  .exit_code,
              0);
  }

  json Result(const std::string& task) const {
    return json::parse(ReadText(Path("sweep/results/000/" + task + ".json")));
  }

  std::unique_ptr<OwnChild> StartRun() const {
    return std::make_unique<OwnChild>(std::vector<std::string>{
        BRACHIUM_PROGRAM, "sweep", "run", "--manifest=" + Manifest(), "--jobs=2"});
  }

  void WaitForAResult() const {
    for (int i = 0; i < 3000 && !fs::exists(Path("sweep/results/000/000000.json")); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
};

TEST_F(SweepRun, IsTheSameForEveryNumberOfShardsAndOrder) {
  PlanSmall();
  ASSERT_EQ(Sweep("run").exit_code, 0);
  ASSERT_EQ(Sweep("merge").exit_code, 0);
  const auto whole = Files();
  EXPECT_TRUE(whole.contains("sweep.csv"));
  for (const auto& order : {std::vector<std::string>{"0/1"},
                            {"1/2", "0/2"},
                            {"4/5", "0/5", "2/5", "1/5", "3/5"},
                            {"0/16", "16/17", "0/1"}}) {
    ForgetResults();
    for (const std::string& shard : order)
      ASSERT_EQ(Sweep("run", {"--shard=" + shard, "--jobs=3"}).exit_code, 0) << shard;
    ASSERT_EQ(Sweep("merge").exit_code, 0);
    EXPECT_EQ(Files(), whole);
    for (const auto& [task, times] : TimesRun()) EXPECT_EQ(times, 1) << task;
  }
}

TEST_F(SweepRun, FindsTheFiguresOfEvaluate) {
  PlanSmall();
  ASSERT_EQ(Sweep("run", {"--task=2"}).exit_code, 0);
  const auto sigma = Tasks()[2]["varied"]["luinge_adduction_sigma_deg"].dump();
  ASSERT_EQ(Reconstruct(Path("one"), Path("alone"),
                        {"--method=luinge", "--luinge_adduction_sigma_deg=" + sigma})
                .exit_code,
            0);
  ASSERT_EQ(Run({"evaluate", "--trial=" + Path("one"), "--estimate=" + Path("alone")}).exit_code,
            0);
  const json evaluation = json::parse(ReadText(Path("alone/evaluation.json")));
  const json figures = Result("000002")["figures"];
  EXPECT_EQ(figures["relative.forearm_in_upper_arm.rmse_deg"],
            evaluation["relative"]["forearm_in_upper_arm"]["rmse_deg"]);
  EXPECT_GT(figures["adduction.rms_deg"], 0.0);
}

TEST_F(SweepRun, FindsTheSameFiguresWithoutStandardDeviations) {
  ASSERT_EQ(Plan(Trial("one"), "smoother", "covariance=true,false").exit_code, 0);
  ASSERT_EQ(Sweep("run").exit_code, 0);
  const json with = Result("000000"), without = Result("000001");
  EXPECT_EQ(with["figures"], without["figures"]);
  EXPECT_EQ(with["trusted"], without["trusted"]);
}

TEST_F(SweepRun, TakesTheShouldersSigmaFromItsOptionBeforeTheTrial) {
  Trial("told");
  Trial("loose");
  json trial = json::parse(ReadText(Path("loose/trial.json")));
  trial["arm"]["shoulder"]["sigma_m"] = 0.1;
  Write("loose/trial.json", trial.dump());
  ASSERT_EQ(
      Plan(Path("told") + "," + Path("loose"), "smoother", "shoulder_sigma_m=0,0.1").exit_code, 0);
  ASSERT_EQ(Sweep("run").exit_code, 0);
  const json figures = Result("000001")["figures"];
  EXPECT_NE(Result("000000")["figures"], figures);
  EXPECT_EQ(Result("000002")["figures"], figures);
  EXPECT_EQ(Result("000003")["figures"], figures);
}

TEST_F(SweepRun, GoesOnAfterBeingKilledAtAnyMoment) {
  PlanSmall();
  ASSERT_EQ(Sweep("run").exit_code, 0);
  const auto whole = Files();
  ForgetResults();
  for (int i = 0; i < 12; ++i) {
    const auto run = StartRun();
    std::this_thread::sleep_for(std::chrono::milliseconds(7 * i));
    run->Kill(SIGKILL);
    run->Wait();
    for (const auto& [name, text] : Files()) EXPECT_EQ(text, whole.at(name)) << name;
  }
  ASSERT_EQ(Sweep("run").exit_code, 0);
  EXPECT_EQ(Files(), whole);
  for (const auto& [task, times] : TimesRun()) EXPECT_EQ(times, 1) << task;
}

TEST_F(SweepRun, EndsOnTerminationWith143AndLosesNothing) {
  ASSERT_EQ(Plan(Trial("one"), "smoother", "elbow_adduction_sigma_deg=1:30:40:log").exit_code, 0);
  const auto run = StartRun();
  WaitForAResult();
  run->Kill(SIGTERM);
  EXPECT_EQ(run->Wait(), 143);
  const auto results = Files();
  EXPECT_GT(results.size(), 1u);
  EXPECT_LT(results.size(), 41u);
  for (const auto& [name, text] : results)
    if (name.starts_with("results")) {
      EXPECT_EQ(json::parse(text)["outcome"], "done");
    }
}

TEST_F(SweepRun, LeavesARecordOfATaskThatFailsAndTriesItAgain) {
  PlanSmall();
  const std::string recording = ReadText(Path("one/forearm.csv"));
  Write("one/forearm.csv", "not a recording\n");
  const Outcome outcome = Sweep("run");
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_THAT(outcome.out, HasSubstr("8 tasks done, 0 were done before, 8 failed"));
  EXPECT_EQ(Result("000000")["outcome"], "unreadable");
  EXPECT_THAT(Sweep("status").out,
              AllOf(HasSubstr("8 done, 8 failed, 0 missing"), HasSubstr("forearm.csv:1")));
  EXPECT_EQ(Sweep("status", {"--missing"}).out, "0-7\n");
  EXPECT_EQ(Sweep("merge").exit_code, 4);
  Write("one/forearm.csv", recording);
  EXPECT_THAT(Sweep("run").out, HasSubstr("8 tasks done, 8 were done before, 0 failed"));
  EXPECT_EQ(Sweep("merge").exit_code, 0);
}

TEST_F(SweepRun, RefusesInputsThatWereChangedSinceThePlan) {
  PlanSmall();
  Trial("one", {"--seed=9", "--overwrite"});
  EXPECT_EQ(Sweep("run", {"--task=0"}).exit_code, 4);
  EXPECT_THAT(Result("000000")["reason"].get<std::string>(), HasSubstr("changed since"));
}

TEST_F(SweepRun, MakesADamagedResultAgain) {
  PlanSmall();
  ASSERT_EQ(Sweep("run").exit_code, 0);
  const auto whole = Files();
  Write("sweep/results/000/000003.json", "{\"task\":3,");
  Write("sweep/results/000/000004.json", whole.at("results/000/000005.json"));
  Write("sweep/results/000/000006.json", "");
  EXPECT_EQ(Sweep("status", {"--missing"}).out, "3-4,6\n");
  EXPECT_THAT(Sweep("run").out, HasSubstr("3 tasks done, 13 were done before"));
  EXPECT_EQ(Files(), whole);
}

TEST_F(SweepRun, RefusesADamagedManifest) {
  PlanSmall();
  const std::string manifest = ReadText(Manifest());
  const auto refused = [&](const std::string& text) {
    Write("sweep/manifest.jsonl", text);
    const Outcome outcome = Sweep("run");
    EXPECT_EQ(outcome.exit_code, 2);
    return outcome.err;
  };
  EXPECT_THAT(refused(manifest.substr(0, manifest.size() / 2)), HasSubstr("cut off"));
  EXPECT_THAT(refused(""), HasSubstr("manifest.jsonl:1"));
  EXPECT_THAT(refused(manifest.substr(manifest.find('\n') + 1)), HasSubstr("calls itself task 1"));
  std::string changed = manifest;
  changed.replace(changed.find("\"options\""), 9, "\"optionz\"");
  EXPECT_THAT(refused(changed), HasSubstr("manifest.jsonl:1: is no task"));
  changed = manifest;
  changed.replace(changed.find("\"method\":\"luinge\""), 17, "\"method\":\"zhou\"  ");
  EXPECT_THAT(refused(changed), HasSubstr("was changed"));
}

TEST_F(SweepRun, TakesItsTaskFromSlurm) {
  PlanSmall();
  setenv("SLURM_ARRAY_TASK_ID", "5", 1);
  setenv("SLURM_CPUS_PER_TASK", "1", 1);
  const Outcome outcome = Sweep("run");
  setenv("SLURM_ARRAY_TASK_ID", "16", 1);
  const Outcome beyond = Sweep("run");
  const Outcome told = Sweep("run", {"--task=6"});
  unsetenv("SLURM_ARRAY_TASK_ID");
  unsetenv("SLURM_CPUS_PER_TASK");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(beyond.exit_code, 1);
  EXPECT_EQ(told.exit_code, 0);
  EXPECT_EQ(TimesRun(), (std::map<int, int>{{5, 1}, {6, 1}}));
}

TEST_F(SweepRun, RefusesTasksAndShardsThatThereAreNot) {
  PlanSmall();
  for (const char* flag :
       {"--task=16", "--task=-1", "--task=a", "--shard=2/2", "--shard=1", "--shard=/",
        "--shard=0/0", "--shard=-1/2", "--shard=0/2/3", "--jobs=-1"})
    EXPECT_EQ(Sweep("run", {flag}).exit_code, 1) << flag;
  EXPECT_EQ(Sweep("run", {"--task=1", "--shard=0/2"}).exit_code, 1);
}

}  // namespace
}  // namespace brachium
