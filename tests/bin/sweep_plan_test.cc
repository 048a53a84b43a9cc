#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "tests/support/sweep_program_test.h"

namespace brachium {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class SweepPlan : public SweepProgramTest {
 protected:
  // Exits with 1 for what is wrong with the grid, with 2 where only the trial is missing.
  Outcome Parsed(const std::string& vary) const {
    return Plan(Path("nowhere"), "smoother,luinge", vary);
  }

  std::vector<double> Values(const std::string& grid) const {
    fs::remove_all(Path("sweep"));
    EXPECT_EQ(Plan(Path("one"), "luinge", "luinge_adduction_sigma_deg=" + grid).exit_code, 0);
    std::vector<double> values;
    for (const auto& task : Tasks()) values.push_back(task["varied"]["luinge_adduction_sigma_deg"]);
    return values;
  }
};

TEST_F(SweepPlan, WritesATaskForEachTrialMethodAndPointItHas) {
  const Outcome outcome =
      Plan(Trial("one") + "," + Trial("two", {"--seed=2"}), "gyroscope,luinge",
           "luinge_adduction_sigma_deg=1,5;luinge_acceleration_cutoff_hz=1:4:3:log");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("14 tasks"));
  const auto tasks = Tasks();
  ASSERT_EQ(tasks.size(), 14u);
  EXPECT_EQ(tasks[0]["method"], "gyroscope");
  EXPECT_TRUE(tasks[0]["varied"].empty());
  EXPECT_EQ(tasks[5]["varied"]["luinge_adduction_sigma_deg"], 5.0);
  EXPECT_EQ(tasks[5]["varied"]["luinge_acceleration_cutoff_hz"], 2.0);
  EXPECT_EQ(tasks[5]["options"]["luinge_acceleration_sigma_m_s2"], 3.0);
  EXPECT_EQ(tasks[13]["trial"], "two");
  EXPECT_EQ(tasks[13]["task"], 13);
  EXPECT_NE(tasks[0]["inputs"], tasks[7]["inputs"]);
}

TEST_F(SweepPlan, SpacesGridsAndKeepsTheirEnds) {
  Trial("one");
  EXPECT_EQ(Values("1:30:4:log"), (std::vector<double>{1.0, 3.10723, 9.65489, 30.0}));
  EXPECT_EQ(Values("2:1:3:lin"), (std::vector<double>{2.0, 1.5, 1.0}));
  EXPECT_EQ(Values("7,3,0.123456789"), (std::vector<double>{7.0, 3.0, 0.123456789}));
}

TEST_F(SweepPlan, RefusesUnknownOptionsWithTheNearest) {
  const Outcome outcome = Parsed("elbow_aduction_sigma_deg=1,2");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("did you mean 'elbow_adduction_sigma_deg'?"));
  EXPECT_EQ(Plan(Path("nowhere"), "luinge", "elbow_adduction_sigma_deg=1").exit_code, 1);
  EXPECT_EQ(Parsed("threads=1,2").exit_code, 1);
}

TEST_F(SweepPlan, TakesValuesOfEveryKindThatAnOptionHas) {
  for (const char* vary : {"covariance=true,false", "solver=chain,ceres", "weight_iterations=0,1,2",
                           "weight_iterations=0:4:3:lin", "window_s=5",
                           "elbow_adduction_sigma_deg=1:30:15:log;shoulder_sigma_m=0.01,0.03,0.1",
                           "knot_spacing_s=0.05:0.2:3:log;window_s=4,6"})
    EXPECT_EQ(Parsed(vary).exit_code, 2) << vary;
}

TEST_F(SweepPlan, RefusesWhatIsNoGridAndSaysWhatWasExpected) {
  for (const char* values : {"",
                             ",",
                             "1,",
                             "1,,2",
                             "1,1",
                             "a",
                             "nan",
                             "inf",
                             "1:2",
                             "1:2:3",
                             "1:2:1:lin",
                             "1:2:0:log",
                             "1:2:-3:lin",
                             "0:2:3:log",
                             "-1:2:3:log",
                             "1:2:3:cubic",
                             "1:2:3:lin:4",
                             "1:2:1e3:lin",
                             "1:2:99999999999:lin",
                             "1e999:2:3:lin",
                             "2:2:3:lin",
                             "-1e308:1e308:3:lin",
                             " 1",
                             "1;"}) {
    const Outcome outcome = Parsed("elbow_adduction_sigma_deg=" + std::string(values));
    EXPECT_EQ(outcome.exit_code, 1) << values;
    EXPECT_THAT(outcome.err, HasSubstr("--vary")) << values;
  }
  for (const char* vary : {"weight_iterations=1.5", "weight_iterations=0:3:3:lin", "covariance=yes",
                           "covariance=0:1:2:lin", "solver=", "window_s", "window_s=1;window_s=2",
                           "solver=none", "knot_spacing_s=-1", "shoulder_sigma_m=-1", "=1", ";"})
    EXPECT_EQ(Parsed(vary).exit_code, 1) << vary;
}

TEST_F(SweepPlan, SurvivesAnyText) {
  std::mt19937 random(7);
  const std::string letters = "0123456789.:,;=-+einflog elbow_";
  for (int i = 0; i < 150; ++i) {
    std::string text = "window_s=";
    for (int n = static_cast<int>(random() % 12); n >= 0; --n)
      text += letters[random() % letters.size()];
    EXPECT_THAT(Parsed(text).exit_code, testing::AnyOf(1, 2)) << text;
  }
}

TEST_F(SweepPlan, IsNeverChanged) {
  Trial("one");
  ASSERT_EQ(Plan(Path("one"), "luinge", "luinge_adduction_sigma_deg=1,2").exit_code, 0);
  const std::string first = ReadText(Manifest());
  EXPECT_EQ(Plan(Path("one"), "luinge", "luinge_adduction_sigma_deg=1,2").exit_code, 0);
  const Outcome other = Plan(Path("one"), "luinge", "luinge_adduction_sigma_deg=1,3");
  EXPECT_EQ(other.exit_code, 1);
  EXPECT_THAT(other.err, HasSubstr("never changed"));
  EXPECT_EQ(ReadText(Manifest()), first);
  EXPECT_EQ(std::distance(fs::directory_iterator(Path("sweep")), {}), 1);
}

TEST_F(SweepPlan, KeysFollowFromInputsMethodAndOptionsAlone) {
  Trial("one");
  fs::create_directory(Path("b"));
  fs::copy(Path("one"), Path("b/same"));
  Trial("other", {"--seed=3"});
  ASSERT_EQ(Plan(Path("one") + "," + Path("b/same") + "," + Path("other"), "luinge,luinge_rts",
                 "luinge_adduction_sigma_deg=1,2")
                .exit_code,
            0);
  const auto tasks = Tasks();
  ASSERT_EQ(tasks.size(), 12u);
  EXPECT_EQ(tasks[0]["key"], tasks[4]["key"]);
  for (const int i : {1, 2, 8})
    EXPECT_NE(tasks[0]["key"], tasks[static_cast<std::size_t>(i)]["key"]);
}

TEST_F(SweepPlan, RefusesATrialWithoutReference) {
  Trial("one");
  auto trial = nlohmann::json::parse(ReadText(Path("one/trial.json")));
  trial.erase("reference");
  Write("one/trial.json", trial.dump());
  const Outcome outcome = Plan(Path("one"), "luinge", "");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("reference"));
}

TEST_F(SweepPlan, AllItsCommandsDescribeThemselves) {
  for (const char* command : {"plan", "run", "status", "merge", "submit"}) {
    const Outcome outcome = Run({"sweep", command, "--help"});
    EXPECT_EQ(outcome.exit_code, 0) << command;
    EXPECT_THAT(outcome.out, HasSubstr("usage: brachium sweep " + std::string(command)));
    EXPECT_EQ(Run({"help", "sweep", command}).out, outcome.out);
  }
  EXPECT_EQ(Run({"sweep", "--help"}).exit_code, 0);
  EXPECT_EQ(Run({"sweep"}).exit_code, 1);
  EXPECT_THAT(Run({"sweep", "stat"}).err, HasSubstr("did you mean 'sweep status'?"));
}

}  // namespace
}  // namespace brachium
