// A sweep through a real Slurm. Skipped where it is not installed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>

#include "tests/support/slurm_here.h"
#include "tests/support/sweep_program_test.h"

namespace brachium {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class SweepOnSlurm : public SweepProgramTest {
 protected:
  void SetUp() override {
    if (const std::string why = SlurmHere::WhyNot(); !why.empty()) GTEST_SKIP() << why;
    SweepProgramTest::SetUp();
    slurm_ = std::make_unique<SlurmHere>();
    ASSERT_TRUE(slurm_->IsReady());
    const Outcome plan = Plan(Trial("one", {"--duration_s=60"}), "smoother",
                              "elbow_adduction_sigma_deg=1:30:12:log");
    ASSERT_EQ(plan.exit_code, 0) << plan.err;
  }

  // As shards of one task, after task 0 was measured here.
  void Submit() const {
    const Outcome outcome = Sweep("submit", {"--shard_minutes=0.000001"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("the merge is job"));
  }

  std::size_t Results() const {
    std::error_code error;
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(Path("sweep/results/000"), error), {}));
  }

  std::string Merged() const { return Path("sweep/sweep.json"); }

  std::unique_ptr<SlurmHere> slurm_;
};

TEST_F(SweepOnSlurm, RunsTheArrayAndThenTheMerge) {
  Submit();
  EXPECT_THAT(SlurmHere::Said("squeue --noheader --format='%j %E'"),
              HasSubstr("brachium_merge afterany:"));
  ASSERT_TRUE(SlurmHere::WaitUntilEmpty(400));
  EXPECT_EQ(Sweep("status", {"--missing"}).out, "\n");
  ASSERT_TRUE(fs::exists(Merged()));
  EXPECT_EQ(nlohmann::json::parse(ReadText(Merged()))["complete"], true);
  EXPECT_THAT(Sweep("submit").out, HasSubstr("Nothing is left"));
}

TEST_F(SweepOnSlurm, FindsACancelledTaskAndRunsItAgain) {
  Submit();
  ASSERT_TRUE(SlurmHere::Within(200, [&] { return Results() >= 3; }));
  SlurmHere::Said("scancel --name=brachium_sweep");
  ASSERT_TRUE(SlurmHere::WaitUntilEmpty(60));
  EXPECT_NE(Sweep("status", {"--missing"}).out, "\n");
  EXPECT_FALSE(fs::exists(Merged()));
  Submit();
  ASSERT_TRUE(SlurmHere::WaitUntilEmpty(400));
  EXPECT_TRUE(fs::exists(Merged()));
  for (const auto& [task, times] : TimesRun()) EXPECT_EQ(times, 1) << task;
}

TEST_F(SweepOnSlurm, LosesNothingWhenANodeStartsAgain) {
  Submit();
  ASSERT_TRUE(SlurmHere::Within(200, [&] { return Results() >= 2; }));
  slurm_->StopNode();
  slurm_->StartNode();
  ASSERT_TRUE(SlurmHere::WaitUntilEmpty(400));
  EXPECT_EQ(Sweep("status", {"--missing"}).out, "\n");
  EXPECT_TRUE(fs::exists(Merged()));
}

}  // namespace
}  // namespace brachium
