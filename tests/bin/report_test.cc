// The page of brachium report, as files and in a browser.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/run_program.h"

namespace brachium {
namespace {

using testing::AllOf, testing::HasSubstr, testing::Not;

class ReportProgram : public ProgramTest {
 protected:
  Outcome RunReport(const std::string& estimates, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words = {"report", "--estimates=" + estimates,
                                      "--output=" + Path("report.html")};
    words.insert(words.end(), more.begin(), more.end());
    return Run(words);
  }

  void Estimate(const std::string& name, const std::string& method = "smoother") const {
    const Outcome outcome = Reconstruct(Path("trial"), Path(name), {"--method=" + method});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  }
};

TEST_F(ReportProgram, WritesAPageAndItsFigures) {
  Simulate({"--tell_rests"});
  Estimate("estimate");
  const Outcome outcome = RunReport(Path("estimate"));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string html = ReadText(Path("report.html"));
  EXPECT_THAT(html, AllOf(HasSubstr("<!doctype html>"), HasSubstr("elbow flexion: rmse"),
                          HasSubstr("instants of the trial's reference compared")));
  EXPECT_THAT(Bytes(Path("report_figures")), testing::SizeIs(6));
  EXPECT_EQ(RunReport(Path("estimate")).exit_code, 0);  // the same bytes
  Estimate("another", "gyroscope");
  EXPECT_EQ(RunReport(Path("another")).exit_code, 1);
  EXPECT_EQ(RunReport(Path("another"), {"--overwrite"}).exit_code, 0);
}

TEST_F(ReportProgram, FindsTheReferenceOfATrialThatMoved) {
  Simulate();
  Estimate("estimate", "gyroscope");
  std::filesystem::rename(Path("trial"), Path("elsewhere"));
  ASSERT_EQ(RunReport(Path("estimate")).exit_code, 0);
  EXPECT_THAT(ReadText(Path("report.html")), HasSubstr("is not there; --trial says where it is"));
  const Outcome told = RunReport(Path("estimate"), {"--trial=" + Path("elsewhere"), "--overwrite"});
  ASSERT_EQ(told.exit_code, 0) << told.err;
  EXPECT_THAT(ReadText(Path("report.html")), HasSubstr("Errors against the reference"));

  Write("elsewhere/reference.csv", ReadText(Path("elsewhere/reference.csv")) + "\n");
  const Outcome changed =
      RunReport(Path("estimate"), {"--trial=" + Path("elsewhere"), "--overwrite"});
  EXPECT_EQ(changed.exit_code, 2);
  EXPECT_THAT(changed.err, HasSubstr("none of the trials told"));
}

TEST_F(ReportProgram, ShowsComparisonsAndEstimatesTogether) {
  const std::string trial = Simulate();
  const Outcome compared = Run({"compare", "--trial=" + trial, "--methods=gyroscope,luinge",
                                "--output=" + Path("comparison")});
  ASSERT_EQ(compared.exit_code, 0) << compared.err;
  const std::string estimates = Path("comparison/estimates/trial/");
  const Outcome outcome =
      RunReport(Path("comparison") + "," + estimates + "gyroscope," + estimates + "luinge");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(ReadText(Path("report.html")),
              AllOf(HasSubstr("Comparison comparison"), HasSubstr("Side by side"),
                    HasSubstr("data:image/svg+xml;base64,")));
}

TEST_F(ReportProgram, RefusesWhatItCannotShow) {
  const auto expect = [](const Outcome& outcome, int exit_code, const std::string& says) {
    EXPECT_EQ(outcome.exit_code, exit_code);
    EXPECT_THAT(outcome.err, HasSubstr(says));
    EXPECT_THAT(outcome.err, Not(HasSubstr("terminate")));
  };
  expect(Run({"report"}), 1, "estimates");
  expect(Run({"report", "--estimates=,", "--output=" + Path("r.html")}), 1, "names no folder");
  expect(Run({"report", "--estimates=" + Path(""), "--output=" + Path("r.pdf")}), 1, "NAME.html");
  expect(RunReport(Path("absent")), 2, "is no result");
  Write("comparison.json", "{\"brachium_comparison\": \"1\"}");
  expect(RunReport(Path("")), 2, "expected version 1");
  Write("summary.json", "{}");
  expect(RunReport(Path("")), 2, "brachium_summary");
  EXPECT_FALSE(std::filesystem::exists(Path("report.html")));
}

// The three commands of the README.
TEST_F(ReportProgram, LeadsFromRecordedExportsToAPage) {
  const std::string exports = BRACHIUM_SOURCE_DIR "/../shared/data/formats/xsens_mt_ascii";
  if (!std::filesystem::exists(exports)) GTEST_SKIP() << exports << " is not there";
  const Outcome imported = Run({"import", "--format=xsens_mt", "--files=" + exports,
                                "--map=MT_012005D6_031-000_00B4227B:forearm", "--side=right",
                                "--output=" + Path("trial")});
  ASSERT_EQ(imported.exit_code, 0) << imported.err;
  Estimate("estimate");
  const Outcome outcome = RunReport(Path("estimate"));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(ReadText(Path("report.html")), HasSubstr("forearm inclination"));
}

// In a browser: no complaint, no request, numbers as in estimate.csv, an arm that moves.
class ReportInABrowser : public ReportProgram {
 protected:
  void SetUp() override {
    ReportProgram::SetUp();
    if (std::system("command -v chromium >/dev/null && command -v node >/dev/null") != 0)
      GTEST_SKIP() << "chromium or node is not installed: the page is not looked at";
  }

  void Look(const std::string& estimate) const {
    const std::string command = "timeout 240 node '" BRACHIUM_SOURCE_DIR
                                "/tests/support/look_at_report.mjs' '" +
                                Path("report.html") + "' '" + Path(estimate) + "/estimate.csv' >'" +
                                Path("said") + "' 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0) << ReadText(Path("said"));
  }
};

TEST_F(ReportInABrowser, ShowsWhatTheEstimateSaysAndMoves) {
  Simulate({"--tell_rests"});
  Estimate("estimate");
  Estimate("other", "gyroscope");
  const Outcome outcome = RunReport(Path("estimate") + "," + Path("other"));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  Look("estimate");
}

TEST_F(ReportInABrowser, ShowsALoneSensorWithoutReference) {
  const std::string trial = Simulate();
  auto description = nlohmann::json::parse(ReadText(trial + "/trial.json"));
  description.erase("reference");
  for (const auto& recording : description["recordings"])
    if (recording["segment"] == "forearm") description["recordings"] = {recording};
  description["recordings"][0].erase("mounting");
  Write("trial/trial.json", description.dump());
  Estimate("estimate");
  const Outcome outcome = RunReport(Path("estimate"));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  Look("estimate");
}

}  // namespace
}  // namespace brachium
