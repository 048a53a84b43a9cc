// brachium compare, as a user goes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/support/run_program.h"

namespace brachium {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class Compare : public ProgramTest {
 protected:
  // A short trial of that name; returns its folder.
  std::string Trial(const std::string& name, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words = {"simulate", "--scenario=reach", "--duration_s=16",
                                      "--output=" + Path(name)};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = Run(words);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return Path(name);
  }

  Outcome Compared(const std::string& trials, const std::string& methods,
                   const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words = {"compare", "--trial=" + trials, "--methods=" + methods,
                                      "--output=" + Path("comparison")};
    words.insert(words.end(), more.begin(), more.end());
    return Run(words);
  }

  json Json(const std::string& file) const {
    return json::parse(ReadText(Path("comparison/" + file)));
  }

  std::map<std::string, std::string> Files() const {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(Path("comparison")))
      if (entry.is_regular_file() && entry.path().filename() != "timing.json")
        files[entry.path().lexically_relative(Path("comparison")).string()] =
            ReadText(entry.path());
    return files;
  }

  fs::file_time_type TimeOf(const std::string& estimate) const {
    return fs::last_write_time(Path("comparison/estimates/" + estimate + "/estimate.csv"));
  }

  // A trial on which no elbow is a hinge.
  std::string BallJoint(const std::string& name) const {
    const std::string folder = Trial(name);
    json trial = json::parse(ReadText(folder + "/trial.json"));
    trial["arm"]["elbow"] = {{"constraint", "none"}};
    Write(name + "/trial.json", trial.dump());
    return folder;
  }
};

TEST_F(Compare, PutsMethodsAndTrialsSideBySide) {
  const Outcome outcome =
      Compared(Trial("one") + "," + Trial("two", {"--side=left"}), "gyroscope,luinge*");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("rmse [deg]"), HasSubstr("one"), HasSubstr("two"),
                                 HasSubstr("luinge_rts")));
  for (const char* file : {"comparison.csv", "comparison.json", "comparison.md", "errors.svg",
                           "error_over_time_one.svg", "error_over_time_two.svg", "run.flags"})
    EXPECT_TRUE(Files().contains(file)) << file;
  const std::string csv = ReadText(Path("comparison/comparison.csv"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 2 * 4);
  EXPECT_THAT(csv, HasSubstr("relative.forearm_in_upper_arm.rmse_deg"));
}

TEST_F(Compare, FindsTheFiguresOfReconstructAndEvaluate) {
  const std::string trial = Trial("one");
  ASSERT_EQ(Compared(trial, "luinge").exit_code, 0);
  ASSERT_EQ(Reconstruct(trial, Path("alone"), {"--method=luinge"}).exit_code, 0);
  ASSERT_EQ(Run({"evaluate", "--trial=" + trial, "--estimate=" + Path("alone")}).exit_code, 0);
  for (const char* file : {"estimate.csv", "summary.json", "evaluation.json", "run.flags"})
    EXPECT_EQ(ReadText(Path("alone/") + file),
              ReadText(Path("comparison/estimates/one/luinge/") + file))
        << file;
  EXPECT_EQ(Json("comparison.json")["pairs"][0]["evaluation"],
            json::parse(ReadText(Path("alone/evaluation.json"))));
}

TEST_F(Compare, DoesNotDependOnTheNumberOfThreads) {
  const std::string trials = Trial("one") + "," + Trial("two", {"--seed=2"});
  ASSERT_EQ(Compared(trials, "gyroscope,luinge", {"--threads=1"}).exit_code, 0);
  const auto once = Files();
  fs::remove_all(Path("comparison"));
  ASSERT_EQ(Compared(trials, "gyroscope,luinge", {"--threads=3"}).exit_code, 0);
  EXPECT_EQ(Files(), once);
}

TEST_F(Compare, GoesOnWhereItWasInterrupted) {
  const std::string trials = Trial("one") + "," + Trial("two", {"--seed=2"});
  ASSERT_EQ(Compared(trials, "gyroscope,luinge").exit_code, 0);
  const auto whole = Files();
  fs::remove(Path("comparison/comparison.json"));
  fs::remove_all(Path("comparison/estimates/two/luinge"));
  const auto before = TimeOf("one/luinge");
  ASSERT_EQ(Compared(trials, "gyroscope,luinge").exit_code, 0);
  EXPECT_EQ(Files(), whole);
  EXPECT_EQ(TimeOf("one/luinge"), before);
  EXPECT_EQ(Json("timing.json")["pairs"][1]["reused"], true);
  EXPECT_EQ(Json("timing.json")["pairs"][3]["reused"], false);
}

TEST_F(Compare, RunsAgainWhatHasOtherOptionsOrInputs) {
  const std::string trial = Trial("one");
  ASSERT_EQ(Compared(trial, "gyroscope,luinge").exit_code, 0);
  const std::vector<std::string> other = {"--luinge_adduction_sigma_deg=3"};
  const Outcome refused = Compared(trial, "gyroscope,luinge", other);
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.err, HasSubstr("--overwrite"));

  const auto reused = [&] {
    std::vector<bool> flags;
    const json timing = Json("timing.json");
    for (const json& pair : timing["pairs"]) flags.push_back(pair["reused"]);
    return flags;
  };
  ASSERT_EQ(Compared(trial, "gyroscope,luinge", {"--luinge_adduction_sigma_deg=3", "--overwrite"})
                .exit_code,
            0);
  EXPECT_EQ(reused(), (std::vector<bool>{true, false}));
  EXPECT_EQ(Json("comparison.json")["options"]["luinge"]["luinge_adduction_sigma_deg"], 3.0);

  Trial("one", {"--seed=5", "--overwrite"});
  ASSERT_EQ(Compared(trial, "gyroscope,luinge", {"--luinge_adduction_sigma_deg=3", "--overwrite"})
                .exit_code,
            0);
  EXPECT_EQ(reused(), (std::vector<bool>{false, false}));
}

TEST_F(Compare, GivesAFlagToAllMethodsThatHaveIt) {
  ASSERT_EQ(
      Compared(Trial("one"), "luinge,luinge_rts,gyroscope", {"--luinge_adduction_sigma_deg=4"})
          .exit_code,
      0);
  const json options = Json("comparison.json")["options"];
  EXPECT_EQ(options["luinge"]["luinge_adduction_sigma_deg"], 4.0);
  EXPECT_EQ(options["luinge_rts"]["luinge_adduction_sigma_deg"], 4.0);
  EXPECT_FALSE(options["gyroscope"].contains("luinge_adduction_sigma_deg"));
}

TEST_F(Compare, ShowsAMethodThatRefusesAsADashWithItsReason) {
  const Outcome outcome = Compared(BallJoint("ball"), "gyroscope,luinge");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("  -\n"), HasSubstr("elbow.constraint is none")));
  const json pair = Json("comparison.json")["pairs"][1];
  EXPECT_EQ(pair["outcome"], "refused");
  EXPECT_FALSE(pair.contains("evaluation"));
  EXPECT_THAT(ReadText(Path("comparison/comparison.md")), HasSubstr("| - |"));
}

TEST_F(Compare, DoesNotLetABrokenTrialStopTheOthers) {
  const std::string good = Trial("good"), broken = Trial("broken"), bare = Trial("bare");
  Write("broken/upper_arm.csv", "not a recording\n");
  json trial = json::parse(ReadText(bare + "/trial.json"));
  trial.erase("reference");
  Write("bare/trial.json", trial.dump());
  const Outcome outcome =
      Compared(broken + "," + bare + "," + good + "," + Path("nowhere"), "gyroscope");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("upper_arm.csv:1"), HasSubstr("has no \"reference\""),
                                 HasSubstr("nowhere")));
  const json pairs = Json("comparison.json")["pairs"];
  EXPECT_EQ(pairs[0]["outcome"], "unreadable");
  EXPECT_EQ(pairs[1]["outcome"], "unreadable");
  EXPECT_EQ(pairs[2]["outcome"], "done");
  EXPECT_EQ(pairs[3]["outcome"], "unreadable");
}

// A place that is told beyond what a double can weigh makes the information matrix singular.
TEST_F(Compare, ExitsWithThreeWhenAMemberIsNotToBeTrustedAndShowsTheOthers) {
  const std::string sound = Trial("sound"), absurd = Trial("absurd");
  json trial = json::parse(ReadText(absurd + "/trial.json"));
  for (json& recording : trial["recordings"]) recording["mounting"]["p_sigma_m"] = 1e-200;
  Write("absurd/trial.json", trial.dump());
  const Outcome outcome = Compared(sound + "," + absurd, "gyroscope,smoother");
  EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
  const json pairs = Json("comparison.json")["pairs"];
  EXPECT_TRUE(pairs[0]["trusted"] && pairs[1]["trusted"] && pairs[2]["trusted"]);
  EXPECT_EQ(pairs[3]["outcome"], "done");
  EXPECT_FALSE(pairs[3]["trusted"]);
  EXPECT_THAT(pairs[3]["reason"], HasSubstr("singular"));
  EXPECT_THAT(outcome.out, HasSubstr("singular"));
}

// The smoother with a knot at every sample takes twice the memory that it may have here, the
// others a quarter.
TEST_F(Compare, ExitsWithThreeWhenAMethodThrowsAndLeavesTheOthers) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer reserves more memory than may be had here";
#endif
  const Outcome outcome =
      Run({"compare", "--trial=" + Trial("one", {"--duration_s=120"}), "--threads=1",
           "--methods=smoother,gyroscope,luinge", "--knot_spacing_s=0", "--window_s=1000",
           "--window_advance_s=1000", "--output=" + Path("comparison")},
          "export OPENBLAS_NUM_THREADS=1; ulimit -v 250000");
  EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("smoother on one: there is not enough memory"));
  const json pairs = Json("comparison.json")["pairs"];
  EXPECT_EQ(pairs[0]["outcome"], "failed");
  EXPECT_EQ(pairs[0]["reason"], "there is not enough memory; try fewer --threads");
  EXPECT_FALSE(pairs[0].contains("evaluation"));
  EXPECT_FALSE(fs::exists(Path("comparison/estimates/one/smoother")));
  for (const std::size_t i : {1u, 2u}) {
    const std::string method = pairs[i]["method"];
    EXPECT_EQ(pairs[i]["outcome"], "done") << method;
    EXPECT_EQ(
        pairs[i]["evaluation"],
        json::parse(ReadText(Path("comparison/estimates/one/" + method + "/evaluation.json"))));
  }
}

TEST_F(Compare, TakesPatternsAndNamesFoldersApart) {
  fs::create_directories(Path("b"));
  Trial("one");
  Trial("b/one", {"--seed=2"});
  Write("no_trial", "");
  const Outcome outcome =
      Compared(Path("on*") + "," + Path("b/one") + "," + Path("one"), "gyroscope");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(Json("comparison.json")["trials"], (json{"a folder-one", "b-one"}));
}

TEST_F(Compare, SaysWhatIsWrongWithItsFlags) {
  const Outcome method = Compared(Path("one"), "luinga");
  EXPECT_EQ(method.exit_code, 1);
  EXPECT_THAT(method.err, HasSubstr("did you mean 'luinge'"));
  const Outcome pattern = Compared(Path("nothing*"), "luinge");
  EXPECT_EQ(pattern.exit_code, 2);
  EXPECT_THAT(pattern.err, HasSubstr("matches no folder"));
  EXPECT_FALSE(fs::exists(Path("comparison")));
}

TEST_F(Compare, RunFlagsRepeatTheComparison) {
  ASSERT_EQ(Compared(Trial("one"), "luinge", {"--luinge_adduction_sigma_deg=4"}).exit_code, 0);
  const auto first = Files();
  const Outcome again =
      Run({"compare", "--flagfile=" + Path("comparison/run.flags"), "--output=" + Path("again")});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(ReadText(Path("again/comparison.json")), first.at("comparison.json"));
}

}  // namespace
}  // namespace brachium
