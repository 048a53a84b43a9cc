// brachium compare --experiment, as a user goes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

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
  for (const char* figure : {"figure_4.svg", "figure_5.svg", "figure_6.svg"})
    EXPECT_THAT(File(figure), HasSubstr("</svg>")) << figure;
  EXPECT_THAT(File("comparison.csv"), HasSubstr("morning,luinge_10,done"));
  const json comparison = json::parse(File("comparison.json"));
  EXPECT_EQ(comparison["options"]["luinge_2"]["luinge_adduction_sigma_deg"], 2.0);
  EXPECT_EQ(comparison["options"]["luinge_switched_on_2"]["luinge_bias_from_rests"], false);
  const json truth = json::parse(File("trials/morning/truth.json"));
  EXPECT_TRUE(truth["truth"].contains("forearm.gyro_bias")) << truth["truth"].dump();
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
