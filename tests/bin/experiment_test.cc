// brachium compare --experiment, as a user goes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/support/run_program.h"

namespace brachium {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

class Experiment : public ProgramTest {
 protected:
  Outcome Quick(const std::string& name, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words = {"compare", "--experiment=" + name, "--quick",
                                      "--output=" + Path("experiment")};
    words.insert(words.end(), more.begin(), more.end());
    return Run(words);
  }

  std::string File(const std::string& name) const { return ReadText(Path("experiment/" + name)); }
};

TEST_F(Experiment, OfLuingePrintsHisFiguresAndWritesThem) {
  const Outcome outcome = Quick("luinge2007");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("Fig. 4"), HasSubstr("order of 20"), HasSubstr("n_z"),
                                 HasSubstr("Fig. 5"), HasSubstr("Fig. 6, filter"),
                                 HasSubstr("Fig. 6, smoother"), HasSubstr("What was found")));
  for (const char* figure : {"figure_3.svg", "figure_4.svg", "figure_5.svg", "figure_6.svg"})
    EXPECT_THAT(File(figure), HasSubstr("</svg>")) << figure;
  EXPECT_THAT(File("comparison.csv"), HasSubstr("morning,luinge_10,done"));
  const json comparison = json::parse(File("comparison.json"));
  EXPECT_EQ(comparison["options"]["luinge_2"]["luinge_adduction_sigma_deg"], 2.0);
  EXPECT_EQ(comparison["options"]["luinge_switched_on_2"]["luinge_bias_from_rests"], false);
  const json truth = json::parse(File("trials/morning/truth.json"));
  EXPECT_TRUE(truth["truth"].contains("forearm.gyro_bias")) << truth["truth"].dump();
}

TEST_F(Experiment, OfZhouPrintsHisTablesAndWritesHisFigures) {
  const Outcome outcome = Quick("zhou2008");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* text :
       {"Table 1", "Table 2", "Table 3", "Table 4", "Table 5", "p-Value", "4.83"})
    EXPECT_THAT(outcome.out, HasSubstr(text));
  for (const char* figure : {"figure_5.svg", "figure_6.svg", "figure_7.svg", "figure_8.svg"})
    EXPECT_THAT(File(figure), HasSubstr("</svg>")) << figure;
  const json comparison = json::parse(File("comparison.json"));
  EXPECT_EQ(comparison["options"]["zhou_no_highpass"]["zhou_highpass_hz"], 0.0)
      << comparison["options"]["zhou_no_highpass"];
}

// Of a table row that begins so: its cells, parted by two blanks or more.
std::vector<std::string> RowOf(const std::string& text, const std::string& name) {
  const std::size_t start = text.find(name);
  if (start == std::string::npos) return {};
  std::vector<std::string> cells;
  std::istringstream line(text.substr(start, text.find('\n', start) - start));
  for (std::string word; line >> word;) cells.push_back(word);
  return cells;
}

// The figures of the paper that a rigid hand's dead reckoning must reach: 0.8 % of the way.
TEST_F(Experiment, OfBaiPrintsHisFiguresAndReckonsARigidHandWithinHisError) {
  const Outcome outcome = Quick("bai2015", {"--threads=2"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* text :
       {"Goniometer", "Fig. 8 a", "Fig. 9", "Fig. 10", "Fig. 11", "Fig. 12", "Section II.E"})
    EXPECT_THAT(outcome.out, HasSubstr(text));
  for (const char* figure :
       {"figure_8.svg", "figure_9.svg", "figure_10.svg", "figure_11.svg", "figure_12.svg"})
    EXPECT_THAT(File(figure), HasSubstr("</svg>")) << figure;
  const std::vector<std::string> row = RowOf(outcome.out, "pegs_hand_rigid, smoother");
  ASSERT_GE(row.size(), 8u) << outcome.out;
  EXPECT_LT(std::stod(row[4]), 0.8) << "rms, % of path";
  EXPECT_LT(std::stod(row[5]), 0.8) << "at the end, % of path";
  EXPECT_LT(std::abs(std::stod(row[6])), 0.3) << "scale error";
  EXPECT_GE(std::stoi(row[7]), 18) << "onsets within 0.08 s";
}

TEST_F(Experiment, SaysTheSameASecondTimeFromTheEstimatesThatAreThere) {
  const Outcome first = Quick("luinge2007", {"--threads=2"});
  const std::string csv = File("comparison.csv");
  const Outcome again = Quick("luinge2007", {"--threads=1"});
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(again.out, first.out);
  EXPECT_EQ(File("comparison.csv"), csv);
  const json timing = json::parse(File("timing.json"));
  for (const json& pair : timing["pairs"]) EXPECT_TRUE(pair["reused"]) << pair;
}

TEST_F(Experiment, ThatIsNotKnownOrComesWithTrialsIsRefused) {
  EXPECT_EQ(Quick("luinge2008").exit_code, 1);
  EXPECT_THAT(Quick("luinge2008").err, HasSubstr("luinge2007"));
  EXPECT_EQ(Quick("luinge2007", {"--methods=smoother"}).exit_code, 1);
  EXPECT_EQ(Quick("luinge2007", {"--luinge_adduction_sigma_deg=4"}).exit_code, 1);
  EXPECT_EQ(Run({"compare", "--quick", "--trial=a", "--methods=luinge", "--output=" + Path("b")})
                .exit_code,
            1);
}

}  // namespace
}  // namespace brachium
