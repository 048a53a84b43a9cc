#include "io/rate_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/spoiled_trials.h"

namespace brachium {
namespace {

using testing::HasSubstr;

// What is said of the forearm's sensor in half a minute whose time runs `faster` times too fast.
std::string SaidAt(double faster) {
  Trial trial = SoundTrial({.name = "daily_brisk", .duration = 30.0});
  Retime(trial, 1.0 / faster);
  Findings findings;
  CheckRate(Fore(trial), "forearm", &findings);
  return findings.warnings.empty() ? "" : findings.warnings.front();
}

// Between the rates that are tried first, too.
TEST(RateCheck, TellsTheRateAtWhichTheRecordingWasMade) {
  for (const double faster : {0.5, 0.8, 0.86, 1.17, 1.25, 1.6}) {
    const std::string said = SaidAt(faster);
    ASSERT_THAT(said, HasSubstr("[rate]")) << faster;
    const double told = std::stod(said.substr(said.find("about ") + 6));
    EXPECT_NEAR(told / 100.0, 1.0, 0.04) << faster;
  }
}

// Here by a gyroscope that is turned in its case: slower, it errs less, but not much less.
TEST(RateCheck, IsSilentWhereNoRateMakesThingsMuchBetter) {
  Trial trial = SoundTrial({.name = "daily_brisk", .duration = 30.0});
  for (Eigen::Vector3d& gyr : Fore(trial).gyr_S)
    gyr = Exp<double>(Eigen::Vector3d(1.0, 0.0, 0.0)) * gyr;
  Findings findings;
  CheckRate(Fore(trial), "forearm", &findings);
  EXPECT_TRUE(findings.warnings.empty());
}

TEST(RateCheck, IsSilentOnARateThatIsNearlyRight) {
  for (const double faster : {0.95, 1.0, 1.05}) EXPECT_EQ(SaidAt(faster), "") << faster;
}

// Seven short windows of the upper arm would have it 10 % too fast, longer ones as told.
TEST(RateCheck, IsSilentWhereLongerWindowsFitTheRateAsTold) {
  const Trial trial =
      SoundTrial({.name = "reach", .seed = 1405, .duration = 20.0}, Drawn(SimulationOptions{}));
  Findings findings;
  for (const Recording& recording : trial.observations.recordings)
    CheckRate(recording, "sensor", &findings);
  EXPECT_TRUE(findings.warnings.empty());
}

}  // namespace
}  // namespace brachium
