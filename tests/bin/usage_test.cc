#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/run_program.h"

namespace brachium {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

using Usage = ProgramTest;

TEST_F(Usage, HelpNamesEveryCommandAndExitsGood) {
  for (const std::string word : {"help", "--help", "-h"}) {
    const Outcome outcome = Run({word});
    EXPECT_EQ(outcome.exit_code, 0) << word;
    EXPECT_THAT(outcome.out, AllOf(HasSubstr("reconstruct"), HasSubstr("evaluate"),
                                   HasSubstr("inspect"), HasSubstr("simulate")));
  }
}

TEST_F(Usage, EveryCommandDescribesItselfAndExitsGood) {
  for (const std::string command : {"reconstruct", "evaluate", "inspect", "report", "simulate"}) {
    const Outcome outcome = Run({command, "--help"});
    EXPECT_EQ(outcome.exit_code, 0) << command;
    EXPECT_THAT(outcome.out, HasSubstr("usage: brachium " + command));
    EXPECT_THAT(outcome.err, IsEmpty());
    EXPECT_EQ(Run({"help", command}).out, outcome.out);
  }
}

TEST_F(Usage, HelpShowsTheFlagsOfTheCommandAndItsMethodAndNoOthers) {
  const std::string help = Run({"reconstruct", "--help"}).out;
  EXPECT_THAT(help, AllOf(HasSubstr("--overwrite  (true or false, default false)"),
                          HasSubstr("--knot_spacing_s  (number, default 0.1)")));
  EXPECT_THAT(help, AllOf(Not(HasSubstr("--scenario")), Not(HasSubstr("--logtostderr")),
                          Not(HasSubstr("--fromenv"))));
}

TEST_F(Usage, VersionIsANumber) {
  const Outcome outcome = Run({"version"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.out, testing::MatchesRegex("brachium [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

TEST_F(Usage, NothingOrAnUnknownCommandIsRefused) {
  EXPECT_EQ(Run({}).exit_code, 1);
  const Outcome outcome = Run({"reconstrukt"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("did you mean 'reconstruct'?"));
  EXPECT_THAT(Run({"sweep"}).err, HasSubstr("plan, run, status, merge or submit"));
}

TEST_F(Usage, AnUnknownFlagIsRefusedWithItsNearestNeighbour) {
  const Outcome outcome = Run({"reconstruct", "--knot_spaceing_s=0.1"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("unknown flag --knot_spaceing_s"),
                                 HasSubstr("did you mean 'knot_spacing_s'?")));
  EXPECT_THAT(Run({"reconstruct", "--method=zhou", "--soft_tissue_deg=3"}).err,
              HasSubstr("see brachium reconstruct --method=zhou --help"));
}

TEST_F(Usage, FlagsOfOtherCommandsAndOfTheLibrariesAreRefused) {
  EXPECT_EQ(Run({"inspect", "--scenario=reach"}).exit_code, 1);
  for (const std::string flag : {"--logtostderr", "--v=1", "--fromenv=trial", "--notrial"})
    EXPECT_EQ(Run({"inspect", flag}).exit_code, 1) << flag;
}

TEST_F(Usage, AValueThatDoesNotParseIsRefusedWithWhatWasExpected) {
  const auto error = [&](const std::string& flag) {
    const Outcome outcome = Run({"reconstruct", flag});
    EXPECT_EQ(outcome.exit_code, 1) << flag;
    return outcome.err;
  };
  EXPECT_THAT(error("--knot_spacing_s=fast"), HasSubstr("a number was expected"));
  EXPECT_THAT(error("--knot_spacing_s="), HasSubstr("a number was expected"));
  EXPECT_THAT(error("--knot_spacing_s=nan"), HasSubstr("a number was expected"));
  EXPECT_THAT(error("--whole_trial=maybe"), HasSubstr("true or false was expected"));
  EXPECT_THAT(error("--threads=1.5"), HasSubstr("a whole number was expected"));
  EXPECT_THAT(error("--trial"), HasSubstr("--trial needs text"));
}

TEST_F(Usage, OptionsThatMakeNoSenseAreRefusedByName) {
  const Outcome outcome = Reconstruct(Path("trial"), Path("estimate"), {"--knot_spacing_s=-1"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("knot_spacing_s"));
}

TEST_F(Usage, AnUnknownMethodIsRefusedWithTheKnownOnes) {
  const Outcome outcome = Run({"reconstruct", "--method=smother", "--help"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("did you mean 'smoother'?"));
}

TEST_F(Usage, EachMethodBringsFlagsOfItsOwn) {
  const Outcome luinge = Run({"reconstruct", "--method=luinge", "--help"});
  EXPECT_EQ(luinge.exit_code, 0);
  EXPECT_THAT(luinge.out, HasSubstr("--luinge_adduction_sigma_deg"));
  EXPECT_THAT(luinge.out, Not(HasSubstr("--window_s")));
  EXPECT_EQ(Run({"reconstruct", "--method=gyroscope", "--window_s=5"}).exit_code, 1);
}

TEST_F(Usage, AMissingFlagAndAWordThatIsNoneAreRefused) {
  EXPECT_THAT(Run({"inspect"}).err, HasSubstr("--trial is missing"));
  const Outcome outcome = Run({"inspect", Path("trial")});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("is no flag"));
}

TEST_F(Usage, ValuesMayStandAloneAndTruthsNeedNone) {
  const Outcome outcome = Run({"simulate", "--scenario", "reach", "--duration_s", "16",
                               "--notell_start_pose", "-tell_rests", "--output", Path("trial")});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string trial = ReadText(Path("trial/trial.json"));
  EXPECT_THAT(trial, AllOf(HasSubstr("\"rest\""), Not(HasSubstr("start_pose"))));
}

TEST_F(Usage, SimulateListsItsScenariosAndRefusesWhatTheyAreNot) {
  const std::string help = Run({"simulate", "--help"}).out;
  for (const char* name : {"daily_brisk", "eating", "circle", "nine_hole_peg_test"})
    EXPECT_THAT(help, HasSubstr("\n  " + std::string(name) + "\n")) << name;
  const auto refusal = [&](const std::vector<std::string>& flags) {
    std::vector<std::string> words = {"simulate", "--output=" + Path("trial")};
    words.insert(words.end(), flags.begin(), flags.end());
    const Outcome outcome = Run(words);
    EXPECT_EQ(outcome.exit_code, 1);
    return outcome.err;
  };
  EXPECT_THAT(refusal({"--scenario=circles"}), HasSubstr("did you mean 'circle'?"));
  EXPECT_THAT(refusal({"--scenario=eating", "--duration_s=60"}), HasSubstr("takes 97 s or more"));
  EXPECT_THAT(refusal({"--scenario=eating", "--patient_week=3"}), HasSubstr("by a patient"));
  EXPECT_THAT(refusal({"--scenario=range_of_motion", "--patient_week=11"}), HasSubstr("1 to 10"));
  EXPECT_THAT(refusal({"--scenario=circle", "--sensors=3"}), HasSubstr("2 or 4 was expected"));
  EXPECT_THAT(refusal({"--scenario=circle", "--rate_hz=100,60,25"}),
              HasSubstr("one for each of 2"));
  for (const char* rate : {"--rate_hz=fast", "--rate_hz=0", "--rate_hz=-5"})
    EXPECT_THAT(refusal({"--scenario=circle", rate}), HasSubstr("numbers above 0 were expected"));
  EXPECT_THAT(refusal({"--scenario=circle", "--seed=-1"}), HasSubstr("0 or more was expected"));
  EXPECT_THAT(refusal({"--scenario=circle", "--shoulder_rms_m=2"}), HasSubstr("out of the arm's"));
}

TEST_F(Usage, MistakesInAFlagFileNameItsLine) {
  Write("run.flags", "# a comment\n\n  --trial=here\n--trail=there\n");
  const Outcome outcome = Run({"inspect", "--flagfile=" + Path("run.flags")});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, HasSubstr(Path("run.flags") + ":4: unknown flag --trail"));
  EXPECT_EQ(Run({"inspect", "--flagfile=" + Path("none.flags")}).exit_code, 1);
}

TEST_F(Usage, AFlagFileThatNamesItselfIsRefused) {
  Write("a.flags", "--flagfile=" + Path("a.flags") + "\n");
  const Outcome outcome = Run({"inspect", "--flagfile=" + Path("a.flags")});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("circle"));
}

TEST_F(Usage, TheLastOfARepeatedFlagCounts) {
  Write("run.flags", "--trial=" + Path("first") + "\n");
  const Outcome outcome =
      Run({"inspect", "--flagfile=" + Path("run.flags"), "--trial=" + Path("second")});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr(Path("second")));
}

}  // namespace
}  // namespace brachium
