// Trials with something wrong that can be mended: read, mended, and said so.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/io/trial_fixture.h"

namespace brachium {
namespace {

using testing::Contains, testing::ElementsAre, testing::HasSubstr, testing::IsEmpty;

TrialFolder WithForearm(const std::string& bytes) {
  const TrialOnDisk disk;
  disk.Write("forearm.csv", bytes);
  return ReadTrial(disk.path());
}

const Recording& Forearm(const TrialFolder& folder) {
  return folder.trial.observations.recordings[1];
}

TEST(RepairedTrial, LeavesOutSamplesThatAreNotFinite) {
  std::string text = WithCell(RecordingText(), 5, 2, "nan");
  text = WithCell(text, 6, 3, "-inf");
  text = WithCell(text, 7, 0, "");
  const TrialFolder folder = WithForearm(text);
  EXPECT_EQ(Forearm(folder).size(), 197u);
  EXPECT_EQ(folder.recordings[1].not_finite_rows, 3u);
  EXPECT_EQ(folder.recordings[1].lost_samples, 3u);
  EXPECT_THAT(folder.repairs,
              ElementsAre("forearm.csv: 3 rows with NaN or infinite numbers left out",
                          "forearm.csv: 1 gap bridged, 3 samples lost, the longest step 0.040 s"));
}

TEST(RepairedTrial, LeavesOutDuplicatedRows) {
  const TrialFolder folder = WithForearm(WithCell(RecordingText(), 5, 0, "0.04"));
  EXPECT_EQ(Forearm(folder).size(), 199u);
  EXPECT_EQ(Forearm(folder).time[5], 0.06);
  EXPECT_THAT(folder.repairs,
              Contains("forearm.csv: 1 row left out where time_s repeats itself or runs back"));
}

TEST(RepairedTrial, LeavesOutRowsWhoseTimeRunsBack) {
  std::string text = RecordingText();
  for (std::size_t row = 50; row < 60; ++row) text = WithCell(text, row, 0, "0.2");
  const TrialFolder folder = WithForearm(text);
  EXPECT_EQ(Forearm(folder).size(), 190u);
  EXPECT_EQ(folder.recordings[1].not_later_rows, 10u);
  EXPECT_TRUE(std::ranges::is_sorted(Forearm(folder).time, std::ranges::less_equal()));
}

TEST(RepairedTrial, LeavesOutASingleTimeThatLeapsAhead) {
  const TrialFolder folder = WithForearm(WithCell(RecordingText(), 50, 0, "1000"));
  EXPECT_EQ(Forearm(folder).size(), 199u);
  EXPECT_EQ(Forearm(folder).time.back(), 1.99);
}

TEST(RepairedTrial, LeavesOutALastRowThatIsCutOff) {
  const TrialFolder folder = WithForearm(RecordingText() + "2.0,0.1,0.");
  EXPECT_EQ(Forearm(folder).size(), 200u);
  EXPECT_TRUE(folder.recordings[1].cut_off);
  EXPECT_THAT(folder.repairs,
              ElementsAre("forearm.csv:202: the last row is cut off and was left out"));
}

TEST(RepairedTrial, BridgesAGapOfMinutesAndAsksWhetherTheClockIsOne) {
  const std::string later = RecordingText(200, 300.0);
  const TrialFolder folder = WithForearm(RecordingText() + later.substr(later.find('\n') + 1));
  EXPECT_EQ(Forearm(folder).size(), 400u);
  EXPECT_EQ(folder.recordings[1].gaps, 1u);
  EXPECT_EQ(folder.recordings[1].lost_samples, 29800u);
  EXPECT_THAT(folder.warnings, Contains(HasSubstr("time_s leaps by 298.0 s after 1.99 s")));
}

TEST(RepairedTrial, TakesAJitteringClockForNoGap) {
  std::string text = RecordingText();
  for (std::size_t row = 1; row < 199; row += 2)
    text = WithCell(text, row, 0, Shortest(0.01 * static_cast<double>(row) + 0.004));
  const TrialFolder folder = WithForearm(text);
  EXPECT_EQ(folder.recordings[1].gaps, 0u);
  EXPECT_THAT(folder.repairs, IsEmpty());
}

TEST(RepairedTrial, LeavesOutAnOrientationThatIsMostlyEmpty) {
  std::string text = RecordingText();
  for (const char* name : {"q_w", "q_x", "q_y", "q_z"}) text = WithColumn(text, name, "");
  const TrialFolder folder = WithForearm(text);
  EXPECT_EQ(Forearm(folder).size(), 200u);
  EXPECT_THAT(Forearm(folder).q_WS, IsEmpty());
  EXPECT_THAT(folder.repairs, Contains(HasSubstr("q_w and its fellows are empty in 200 rows")));
}

TEST(RepairedTrial, LeavesOutTheRareRowWithoutAMagnetometer) {
  std::string text = RecordingText();
  for (const char* name : {"mag_x", "mag_y", "mag_z"}) text = WithColumn(text, name, "0.5");
  const TrialFolder folder = WithForearm(WithCell(text, 9, 8, ""));
  EXPECT_EQ(Forearm(folder).size(), 199u);
  EXPECT_EQ(Forearm(folder).mag_S.size(), 199u);
}

TEST(SuspiciousTrial, IsReadWithAWarningWhenGravityTurnsAsIfByDegreesPerSecond) {
  const auto slow = Scaled(RecordingText(), {"time_s"}, 10.0);
  const TrialFolder sound = WithForearm(Scaled(slow, {"gyr_x", "gyr_y", "gyr_z"}, 0.1));
  EXPECT_THAT(sound.warnings, IsEmpty());
  const TrialFolder folder = WithForearm(Scaled(slow, {"gyr_x", "gyr_y", "gyr_z"}, 0.1 / kDegree));
  EXPECT_THAT(folder.warnings, Contains(HasSubstr("forearm.csv: gyr looks like deg/s")));
}

TEST(SuspiciousTrial, IsReadWithAWarningWhenGravityTurnsTheOtherWay) {
  const TrialFolder folder = WithForearm(Scaled(RecordingText(), {"gyr_x"}, -1.0));
  EXPECT_THAT(folder.warnings, Contains(HasSubstr("forearm.csv: gyr looks turned round")));
}

TEST(SuspiciousTrial, IsReadWithAWarningWhenGravityIsWeak) {
  const TrialFolder folder = WithForearm(Scaled(RecordingText(), {"acc_x", "acc_y", "acc_z"}, 0.3));
  EXPECT_THAT(folder.warnings, Contains(HasSubstr("acc has the median norm 2.94")));
}

}  // namespace
}  // namespace brachium
