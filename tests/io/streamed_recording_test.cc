#include "io/streamed_recording.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "tests/io/trial_fixture.h"

namespace brachium {
namespace {

using testing::HasSubstr;

// A bit more than a minute, in two blocks.
const std::string& Sound() {
  static const std::string text = RecordingText(8000);
  return text;
}

constexpr std::size_t kBlock = 1 << 18;  // [byte]

// A recording as it is read, or why it is refused.
struct Reading {
  Recording recording;
  RecordingFacts facts;
  Findings findings;
  std::string refusal;
};

Reading Whole(const std::string& text, const std::string& file) {
  Reading reading;
  try {
    RecordingFile read = ParseRecording(text, file, "a.csv", Segment::kForearm, &reading.findings);
    reading.recording = std::move(read.recording);
    reading.facts = read.facts;
  } catch (const InputError& error) {
    reading.refusal = error.what();
  }
  return reading;
}

Reading InParts(const std::string& text, const TemporaryFolder& folder) {
  const std::string file = folder.File("a.csv");
  folder.Write("a.csv", text);
  Reading reading;
  try {
    const RecordingSurvey survey =
        SurveyRecording(file, "a.csv", Segment::kForearm, &reading.findings);
    reading.facts = survey.facts;
    StreamedRecording samples(file, survey);
    const double last = samples.Last();
    for (double time = samples.First();; time += 7.0) {
      const Recording part = samples.Between(time, std::min(time + 7.0, last));
      for (std::size_t i = 0; i < part.size(); ++i) {
        if (!reading.recording.time.empty() && part.time[i] <= reading.recording.time.back())
          continue;
        reading.recording.time.push_back(part.time[i]);
        reading.recording.gyr_S.push_back(part.gyr_S[i]);
        reading.recording.acc_S.push_back(part.acc_S[i]);
      }
      if (time + 7.0 >= last) break;
    }
  } catch (const InputError& error) {
    reading.refusal = error.what();
  }
  return reading;
}

void ExpectTheSame(const std::string& text) {
  const TemporaryFolder folder;
  const Reading parts = InParts(text, folder), whole = Whole(text, folder.File("a.csv"));
  EXPECT_EQ(parts.refusal, whole.refusal);
  EXPECT_EQ(parts.recording.time, whole.recording.time);
  EXPECT_EQ(parts.recording.gyr_S, whole.recording.gyr_S);
  EXPECT_EQ(parts.recording.acc_S, whole.recording.acc_S);
  if (!whole.refusal.empty()) return;
  EXPECT_EQ(parts.findings.repairs, whole.findings.repairs);
  EXPECT_EQ(parts.findings.warnings, whole.findings.warnings);
  EXPECT_EQ(parts.facts.samples, whole.facts.samples);
  EXPECT_EQ(parts.facts.rate_hz, whole.facts.rate_hz);
  EXPECT_EQ(parts.facts.duration_s, whole.facts.duration_s);
  EXPECT_EQ(parts.facts.gaps, whole.facts.gaps);
  EXPECT_EQ(parts.facts.lost_samples, whole.facts.lost_samples);
  EXPECT_EQ(parts.facts.longest_step_s, whole.facts.longest_step_s);
  EXPECT_EQ(parts.facts.not_finite_rows, whole.facts.not_finite_rows);
  EXPECT_EQ(parts.facts.not_later_rows, whole.facts.not_later_rows);
  EXPECT_EQ(parts.facts.cut_off, whole.facts.cut_off);
}

std::string WithoutLines(std::string text, std::size_t at, int lines) {
  const std::size_t begin = text.find('\n', at) + 1;
  std::size_t end = begin;
  for (int i = 0; i < lines; ++i) end = text.find('\n', end) + 1;
  return text.erase(begin, end - begin);
}

TEST(StreamedRecording, HandsOutTheSamplesThatTheWholeReadingHas) {
  ASSERT_GT(Sound().size(), kBlock + 1000);
  ExpectTheSame(Sound());
}

TEST(StreamedRecording, MendsAndReportsWhatTheWholeReadingDoes) {
  ExpectTheSame(WithCell(Sound(), 4500, 2, "nan"));
  ExpectTheSame(WithCell(Sound(), 5000, 0, "900"));        // a leap
  ExpectTheSame(WithCell(Sound(), 5001, 0, "1.5"));        // back
  ExpectTheSame(WithoutLines(Sound(), kBlock - 50, 300));  // a gap
  ExpectTheSame(Sound().substr(0, Sound().size() - 9));    // cut off
  ExpectTheSame(Sound() + "\n\r\n\n");
  ExpectTheSame("\xef\xbb\xbf" + Sound());
  ExpectTheSame(WithColumn(Sound(), "temperature", "warm"));
  for (const char* orientation : {"1", ""}) {
    std::string wider = WithColumn(Sound(), "q_w", orientation);
    for (const char* name : {"q_x", "q_y", "q_z"})
      wider = WithColumn(wider, name, *orientation == '\0' ? "" : "0");
    ExpectTheSame(wider);
  }
}

// At every byte about the end of a block.
TEST(StreamedRecording, RefusesABadLineWhereverABlockEnds) {
  for (std::size_t at = kBlock - 60; at < kBlock + 60; at += 3) {
    const std::string before = Sound().substr(0, at), after = Sound().substr(at);
    ExpectTheSame(before + "x" + after);
    const std::size_t end = after.find('\n');
    ExpectTheSame(before + after.substr(0, end) + "\n" + after.substr(end));
    ExpectTheSame(before + after.substr(0, end) + ",1" + after.substr(end));
  }
}

TEST(StreamedRecording, NamesTheLineOfAMistakeLateInTheFile) {
  const TemporaryFolder folder;
  const Reading reading = InParts(WithCell(Sound(), 7990, 3, "oops"), folder);
  EXPECT_THAT(reading.refusal, HasSubstr("a.csv:7992: gyr_z is 'oops'"));
}

TEST(StreamedRecording, RefusesWhatIsNoTable) {
  for (const std::string& text :
       {std::string(), std::string("\0\1\2", 3), std::string("time_s\n1\n2\n"),
        std::string("time_s,gyr_x,gyr_y,gyr_z,acc_x,acc_y,acc_z\n"),
        std::string("time_s;gyr_x\n1;2\n"), RecordingText(1), std::string("\n\n\n")})
    ExpectTheSame(text);
}

TEST(StreamedRecording, ReadsOrRefusesDamagedFilesAsTheWholeReadingDoes) {
  std::mt19937 random(5);
  const std::string nasty[] = {"\n", ",", "-", "1e308", "nan", "\r", ",,", "e", " ", "\n\n", "99"};
  for (int i = 0; i < 60; ++i) {
    std::string text = Sound();
    for (int wound = 0; wound < 2; ++wound) {
      const std::size_t at = random() % text.size(), length = random() % 12;
      text.replace(at, length, random() % 3 == 0 ? "" : nasty[random() % std::size(nasty)]);
    }
    ExpectTheSame(text);
  }
}

TEST(StreamedRecording, HoldsAboutABlockHoweverLongItIs) {
  const TemporaryFolder folder;
  folder.Write("long.csv", RecordingText(30000));
  Findings findings;
  const RecordingSurvey survey =
      SurveyRecording(folder.File("long.csv"), "long.csv", Segment::kForearm, &findings);
  StreamedRecording samples(folder.File("long.csv"), survey);
  std::size_t most = 0;
  for (double time = 0.0; time < 290.0; time += 1.0) {
    samples.Between(time, time + 1.0);
    most = std::max(most, samples.held());
  }
  EXPECT_GT(most, 100u);
  EXPECT_LT(most, 9000u);
}

}  // namespace
}  // namespace brachium
