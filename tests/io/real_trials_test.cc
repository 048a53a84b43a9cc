// The recordings that the program is meant for, where they are at hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "io/trial_folder.h"

namespace brachium {
namespace {

namespace fs = std::filesystem;

const fs::path kTrials = fs::path(BRACHIUM_SOURCE_DIR) / "../shared/data/trials";

TEST(RealTrials, AreReadWithoutASuspicion) {
  if (!fs::is_directory(kTrials)) GTEST_SKIP() << "no recordings at hand";
  int read = 0;
  for (const auto& entry : fs::directory_iterator(kTrials)) {
    const TrialFolder folder = ReadTrial(entry.path().string());
    EXPECT_THAT(folder.warnings, testing::IsEmpty()) << entry.path();
    EXPECT_GE(folder.trial.observations.recordings.size(), 1u) << entry.path();
    for (const Recording& recording : folder.trial.observations.recordings)
      EXPECT_GT(recording.size(), 1000u) << entry.path();
    ++read;
  }
  EXPECT_GT(read, 0);
}

TEST(RealTrials, HaveTheReferencesThatTheyName) {
  if (!fs::is_directory(kTrials)) GTEST_SKIP() << "no recordings at hand";
  const Trial foot = ReadTrial((kTrials / "foot_dead_reckoning").string()).trial;
  EXPECT_TRUE(foot.reference.value().p_V.contains("hand"));
  EXPECT_TRUE(foot.reference.value().q_VB.empty());
  const Trial robot = ReadTrial((kTrials / "kuka_trial1_imu2_imu3").string()).trial;
  EXPECT_TRUE(robot.reference.value().q_VB.contains(Segment::kForearm));
}

}  // namespace
}  // namespace brachium
