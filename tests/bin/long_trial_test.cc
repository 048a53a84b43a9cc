// Trials that go through the program without being held.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/support/run_program.h"

namespace brachium {
namespace {

using testing::HasSubstr;

class LongTrial : public ProgramTest {
 protected:
  std::string HeaderOf(const std::string& file) const {
    const std::string text = ReadText(file);
    return text.substr(0, text.find('\n'));
  }
};

TEST_F(LongTrial, ComesOutInTheSameFilesAndColumnsAsOneThatIsHeld) {
  const std::string trial = Simulate();
  ASSERT_EQ(Reconstruct(trial, Path("held")).exit_code, 0);
  const Outcome outcome = Reconstruct(trial, Path("streamed"), {"--whole_trial=false"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(HeaderOf(Path("held/estimate.csv")), HeaderOf(Path("streamed/estimate.csv")));
  const auto json = [&](const std::string& name) {
    return nlohmann::json::parse(ReadText(Path(name + "/summary.json")));
  };
  EXPECT_EQ(json("held")["samples"], json("streamed")["samples"]);
  EXPECT_EQ(json("held")["inputs"], json("streamed")["inputs"]);
  EXPECT_EQ(json("held")["recordings"], json("streamed")["recordings"]);
  EXPECT_EQ(json("held")["repairs"], json("streamed")["repairs"]);
  const Outcome judged = Run({"evaluate", "--trial=" + trial, "--estimate=" + Path("streamed")});
  EXPECT_EQ(judged.exit_code, 0) << judged.err;
}

TEST_F(LongTrial, ComesOutTheSameTwice) {
  const std::string trial = Simulate();
  for (const char* estimate : {"one", "other"})
    ASSERT_EQ(Reconstruct(trial, Path(estimate), {"--whole_trial=false"}).exit_code, 0);
  EXPECT_EQ(Bytes(Path("one"), "timing.json"), Bytes(Path("other"), "timing.json"));
}

TEST_F(LongTrial, LeavesNothingBehindWhereALateLineIsWrong) {
  const std::string trial = Simulate();
  const std::string file = trial + "/forearm.csv";
  std::string text = ReadText(file);
  const std::size_t last = text.rfind('\n', text.size() - 2);
  text[last + 1] = 'x';
  Write("trial/forearm.csv", text);
  const Outcome outcome = Reconstruct(trial, Path("estimate"), {"--whole_trial=false"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("forearm.csv:"));
  std::vector<std::string> left;
  for (const auto& entry : std::filesystem::directory_iterator(Path("")))
    left.push_back(entry.path().filename().string());
  EXPECT_THAT(left, testing::ElementsAre("trial"));
}

TEST_F(LongTrial, IsNotWrittenOverAnOlderResult) {
  const std::string trial = Simulate();
  ASSERT_EQ(Reconstruct(trial, Path("estimate")).exit_code, 0);
  const auto before = Bytes(Path("estimate"));
  EXPECT_EQ(Reconstruct(trial, Path("estimate"), {"--whole_trial=false"}).exit_code, 1);
  EXPECT_EQ(Bytes(Path("estimate")), before);
}

}  // namespace
}  // namespace brachium
