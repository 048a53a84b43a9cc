// From a trial folder to an evaluation, as a user goes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/support/run_program.h"

namespace brachium {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

using Program = ProgramTest;

json ReadJson(const std::string& file) { return json::parse(ReadText(file)); }

TEST_F(Program, SimulatesInspectsReconstructsAndEvaluates) {
  for (const std::string side : {"right", "left"}) {
    const std::string trial = Simulate({"--side=" + side, "--overwrite"});
    const Outcome inspected = Run({"inspect", "--trial=" + trial});
    EXPECT_EQ(inspected.exit_code, 0) << inspected.err;
    EXPECT_THAT(inspected.out, AllOf(HasSubstr(side + " arm"), HasSubstr("simulated"),
                                     HasSubstr("Ready for brachium reconstruct")));

    const std::string estimate = Path("estimate " + side);
    const Outcome reconstructed = Reconstruct(trial, estimate);
    EXPECT_EQ(reconstructed.exit_code, 0) << reconstructed.err;
    EXPECT_THAT(reconstructed.out, AllOf(HasSubstr("Converged"), HasSubstr(estimate)));
    for (const char* file : {"estimate.csv", "summary.json", "timing.json", "run.flags"})
      EXPECT_TRUE(std::filesystem::exists(estimate + "/" + file)) << file;

    const Outcome evaluated = Run({"evaluate", "--trial=" + trial, "--estimate=" + estimate});
    EXPECT_EQ(evaluated.exit_code, 0) << evaluated.err;
    EXPECT_THAT(evaluated.out, HasSubstr("forearm_in_upper_arm"));
    const json evaluation = ReadJson(estimate + "/evaluation.json");
    EXPECT_LT(evaluation["relative"]["forearm_in_upper_arm"]["rmse_deg"].get<double>(), 5.0);
  }
}

TEST_F(Program, TheSameSeedSimulatesTheSameBytesAndAnotherSeedOthers) {
  const auto once = Bytes(Simulate());
  EXPECT_EQ(Bytes(Simulate({"--overwrite"})), once);
  EXPECT_NE(Bytes(Simulate({"--overwrite", "--seed=2"})), once);
}

TEST_F(Program, ASimulatedTrialSaysSoAndHoldsItsTruth) {
  const std::string trial = Simulate({"--carrying_angle_deg=11"});
  EXPECT_TRUE(ReadJson(trial + "/trial.json")["simulated"].get<bool>());
  const json truth = ReadJson(trial + "/truth.json");
  EXPECT_EQ(truth["scenario"]["carrying_angle_deg"], 11.0);
  EXPECT_FALSE(truth["truth"].empty());
}

TEST_F(Program, FourSensorsOfTheirOwnRatesAreSimulatedWithTheSigmasOfTheirErrors) {
  const std::string trial = Path("pegs");
  const Outcome outcome =
      Run({"simulate", "--scenario=nine_hole_peg_test", "--side=left", "--rate_hz=100,60,120,25",
           "--draw_errors", "--lever_arm_error_m=0.012", "--mounting_error_deg=3",
           "--length_error_m=0.007", "--gyro_bias_deg_s=0.4", "--output=" + trial});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json description = ReadJson(trial + "/trial.json");
  ASSERT_EQ(description["recordings"].size(), 4u);
  for (const json& recording : description["recordings"]) {
    EXPECT_NEAR(recording["mounting"]["q_sigma_deg"].get<double>(), 3.0, 1e-9);
    EXPECT_EQ(recording["mounting"]["p_sigma_m"], 0.012);
    EXPECT_NEAR(recording["noise"]["gyro_bias_sigma_deg_s"].get<double>(), 0.4, 1e-9);
  }
  EXPECT_EQ(description["arm"]["segments"]["hand"]["length_sigma_m"], 0.007);
  const json truth = ReadJson(trial + "/truth.json")["truth"];
  EXPECT_EQ(truth["hand.rate_hz"], 25.0);
  EXPECT_EQ(truth["peg_9.position_m"].size(), 3u);
  const Outcome inspected = Run({"inspect", "--trial=" + trial});
  EXPECT_EQ(inspected.exit_code, 0) << inspected.err;
  EXPECT_THAT(inspected.out, AllOf(HasSubstr("girdle"), HasSubstr("hand")));
}

TEST_F(Program, RunFlagsRepeatTheRunByteForByteButForItsTiming) {
  const std::string trial = Simulate();
  const std::string first = Path("first"), second = Path("second");
  ASSERT_EQ(Reconstruct(trial, first, {"--knot_spacing_s=0.1"}).exit_code, 0);
  const Outcome again =
      Run({"reconstruct", "--flagfile=" + first + "/run.flags", "--output=" + second});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_THAT(ReadText(first + "/run.flags"),
              AllOf(HasSubstr("--knot_spacing_s=0.1\n"), Not(HasSubstr("--output"))));
  EXPECT_EQ(Bytes(first, "timing.json"), Bytes(second, "timing.json"));
}

TEST_F(Program, AResultIsNotOverwrittenUnlessToldSo) {
  const std::string trial = Simulate();
  ASSERT_EQ(Reconstruct(trial, Path("estimate")).exit_code, 0);
  const auto before = Bytes(Path("estimate"));
  const std::vector<std::string> other = {"--knot_spacing_s=0.1"};
  const Outcome refused = Reconstruct(trial, Path("estimate"), other);
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.err, HasSubstr("--overwrite"));
  EXPECT_EQ(Bytes(Path("estimate")), before);

  EXPECT_EQ(Reconstruct(trial, Path("estimate"), {"--knot_spacing_s=0.1", "--overwrite"}).exit_code,
            0);
  EXPECT_NE(Bytes(Path("estimate")), before);
}

TEST_F(Program, OverwritingSparesAFolderThatIsNoEstimate) {
  const std::string trial = Simulate();
  const auto before = Bytes(trial);
  EXPECT_EQ(Reconstruct(trial, trial, {"--overwrite"}).exit_code, 1);
  EXPECT_EQ(Bytes(trial), before);
}

TEST_F(Program, AMissingTrialIsAnInputErrorThatNamesTheFile) {
  for (const std::string command : {"inspect", "reconstruct"}) {
    std::vector<std::string> words = {command, "--trial=" + Path("nowhere")};
    if (command == "reconstruct") words.push_back("--output=" + Path("estimate"));
    const Outcome outcome = Run(words);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err, HasSubstr(Path("nowhere")));
  }
  EXPECT_FALSE(std::filesystem::exists(Path("estimate")));
}

TEST_F(Program, TwoSensorsWithoutMountingsAreInspectedButNotReconstructed) {
  const std::string trial = Simulate();
  json description = ReadJson(trial + "/trial.json");
  for (json& recording : description["recordings"]) recording.erase("mounting");
  Write("trial/trial.json", description.dump());

  const Outcome inspected = Run({"inspect", "--trial=" + trial});
  EXPECT_EQ(inspected.exit_code, 0) << inspected.err;
  EXPECT_THAT(inspected.out, HasSubstr("Not ready"));
  const Outcome outcome = Reconstruct(trial, Path("estimate"));
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err,
              AllOf(HasSubstr("trial.json"), HasSubstr("mounting"), HasSubstr("calibrat")));
}

TEST_F(Program, ATrialWithoutReferenceCannotBeEvaluated) {
  const std::string trial = Simulate();
  ASSERT_EQ(Reconstruct(trial, Path("estimate")).exit_code, 0);
  json description = ReadJson(trial + "/trial.json");
  description.erase("reference");
  Write("trial/trial.json", description.dump());
  const Outcome outcome = Run({"evaluate", "--trial=" + trial, "--estimate=" + Path("estimate")});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("\"reference\""));
  EXPECT_FALSE(std::filesystem::exists(Path("estimate/evaluation.json")));
}

TEST_F(Program, AnEstimateOfOtherRecordingsCannotBeEvaluated) {
  ASSERT_EQ(Reconstruct(Simulate(), Path("estimate"), {"--method=gyroscope"}).exit_code, 0);
  const std::string other = Simulate({"--seed=2", "--overwrite"});
  const Outcome outcome = Run({"evaluate", "--trial=" + other, "--estimate=" + Path("estimate")});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("was not made from upper_arm.csv"));
  EXPECT_FALSE(std::filesystem::exists(Path("estimate/evaluation.json")));
}

TEST_F(Program, EvaluateWarnsOfTheReferenceAndOfAResultNotToBeTrusted) {
  const std::string trial = Simulate();
  ASSERT_EQ(Reconstruct(trial, Path("estimate"), {"--method=gyroscope"}).exit_code, 0);
  json description = ReadJson(trial + "/trial.json");
  description["reference"]["typo"] = 1;
  Write("trial/trial.json", description.dump());
  json summary = ReadJson(Path("estimate/summary.json"));
  summary["convergence"]["singular"] = true;
  Write("estimate/summary.json", summary.dump());
  const Outcome evaluated = Run({"evaluate", "--trial=" + trial, "--estimate=" + Path("estimate")});
  EXPECT_EQ(evaluated.exit_code, 0) << evaluated.err;
  EXPECT_THAT(evaluated.out, AllOf(HasSubstr("Warnings:"), HasSubstr("typo")));
  EXPECT_THAT(evaluated.err, HasSubstr("not to be trusted"));
  EXPECT_THAT(Run({"export", "--estimate=" + Path("estimate"), "--output=" + Path("e")}).err,
              HasSubstr("not to be trusted"));
}

TEST_F(Program, HelpSaysHowEvaluateAndCompareExit) {
  EXPECT_THAT(Run({"evaluate", "--help"}).out, HasSubstr("Exits with 2"));
  EXPECT_THAT(Run({"compare", "--help"}).out,
              AllOf(HasSubstr("Exits with 2"), HasSubstr("with 3 when a method failed")));
}

TEST_F(Program, TerminationLeavesNothingBehindAndExitsWith143) {
  const std::string command = "'" BRACHIUM_PROGRAM
                              "' simulate --scenario=daily_brisk --duration_s=7200 --rate_hz=1000 "
                              "--output='" +
                              Path("trial") + "' & child=$!; sleep 0.3; kill -TERM $child; " +
                              "wait $child";
  const int status = std::system(command.c_str());
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 143);
  EXPECT_TRUE(std::filesystem::is_empty(Path("")));
}

TEST_F(Program, RealArmsWithoutMountingsAreToldHowToGetThem) {
  const std::filesystem::path trial =
      BRACHIUM_SOURCE_DIR "/../shared/data/trials/qmt_human_right_arm";
  if (!std::filesystem::exists(trial)) GTEST_SKIP() << trial << " is not here";
  EXPECT_EQ(Run({"inspect", "--trial=" + trial.string()}).exit_code, 0);
  const Outcome outcome = Reconstruct(trial.string(), Path("estimate"));
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("calibrat"));
}

TEST_F(Program, CalibratesATrialThatCanThenBeReconstructed) {
  const std::string trial = Path("uncalibrated");
  ASSERT_EQ(Run({"simulate", "--scenario=calibration", "--notell_mountings", "--output=" + trial})
                .exit_code,
            0);
  EXPECT_EQ(Reconstruct(trial, Path("refused")).exit_code, 2);

  const std::string calibrated = Path("calibrated");
  const Outcome outcome =
      Run({"calibrate", "--trial=" + trial, "--output=" + calibrated + "/trial.json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("y_spread_deg"), HasSubstr("forearm")));
  const json entered = ReadJson(calibrated + "/trial.json")["recordings"][0];
  EXPECT_EQ(entered["mounting"]["q_BS_wxyz"].size(), 4u);
  EXPECT_GT(entered["mounting"]["q_sigma_deg"].get<double>(), 1.0);
  EXPECT_TRUE(entered.contains("noise"));

  const Outcome reconstructed =
      Reconstruct(calibrated, Path("estimate"), {"--method=luinge_unconstrained"});
  EXPECT_EQ(reconstructed.exit_code, 0) << reconstructed.err;
  EXPECT_THAT(reconstructed.out, Not(HasSubstr("is not known and was ignored")));
  const Outcome again =
      Run({"calibrate", "--trial=" + calibrated, "--output=" + calibrated + "/trial.json"});
  EXPECT_EQ(again.exit_code, 0) << again.err;
}

TEST_F(Program, CalibratesFromMovementThatNobodyLabelled) {
  for (const std::string side : {"right", "left"}) {
    const std::string trial = Path("worn " + side), calibrated = Path("calibrated " + side);
    ASSERT_EQ(Run({"simulate", "--scenario=daily_brisk", "--notell_mountings", "--duration_s=30",
                   "--side=" + side, "--output=" + trial})
                  .exit_code,
              0);
    const Outcome outcome = Run({"calibrate", "--from=motion", "--trial=" + trial,
                                 "--output=" + calibrated + "/trial.json"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("zero of pronation"));
    const std::string estimate = Path("estimate " + side);
    ASSERT_EQ(Reconstruct(calibrated, estimate).exit_code, 0);
    ASSERT_EQ(Run({"evaluate", "--trial=" + calibrated, "--estimate=" + estimate}).exit_code, 0);
    const json evaluation = ReadJson(estimate + "/evaluation.json");
    EXPECT_LT(evaluation["joint_angles"]["elbow_flexion"]["sd_deg"].get<double>(), 2.7);
    EXPECT_LT(evaluation["joint_angles"]["forearm_pronation"]["sd_deg"].get<double>(), 3.8);
  }
}

TEST_F(Program, RefusesToCalibrateFromAnArmThatHangsStill) {
  const std::string trial = Path("still");
  ASSERT_EQ(Run({"simulate", "--scenario=shrug", "--notell_mountings", "--duration_s=30",
                 "--output=" + trial})
                .exit_code,
            0);
  const Outcome outcome =
      Run({"calibrate", "--from=motion", "--trial=" + trial, "--output=" + Path("out.json")});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err,
              AllOf(HasSubstr("bend and stretch it"), HasSubstr("the palm up and down")));
  EXPECT_FALSE(std::filesystem::exists(Path("out.json")));
  EXPECT_EQ(Run({"calibrate", "--from=thin_air", "--trial=" + trial, "--output=x"}).exit_code, 1);
}

TEST_F(Program, CalibratesTheClustersOfAReferenceSoThatJointAnglesCanBeCompared) {
  const std::string trial = Path("clusters"), calibrated = Path("calibrated");
  ASSERT_EQ(Run({"simulate", "--scenario=calibration", "--output=" + trial}).exit_code, 0);
  json description = ReadJson(trial + "/trial.json");
  description["reference"]["frames"] = "cluster";
  Write("clusters/trial.json", description.dump());
  const Outcome outcome =
      Run({"calibrate", "--trial=" + trial, "--output=" + calibrated + "/trial.json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("q_BC_wxyz"));
  const json clusters = ReadJson(calibrated + "/trial.json")["reference"]["clusters"];
  // Here they sit on their segments unturned.
  EXPECT_GT(std::abs(clusters["forearm"]["q_BC_wxyz"][0].get<double>()), std::cos(0.01));
  EXPECT_GT(std::abs(clusters["upper_arm"]["q_BC_wxyz"][0].get<double>()), std::cos(0.01));

  ASSERT_EQ(Reconstruct(calibrated, Path("estimate"), {"--method=luinge"}).exit_code, 0);
  const auto evaluated = [&](const std::string& folder) {
    const Outcome evaluation =
        Run({"evaluate", "--trial=" + folder, "--estimate=" + Path("estimate"), "--overwrite"});
    EXPECT_EQ(evaluation.exit_code, 0) << evaluation.err;
    return evaluation.out;
  };
  EXPECT_THAT(evaluated(calibrated), HasSubstr("elbow_flexion"));
  EXPECT_THAT(evaluated(trial), Not(HasSubstr("elbow_flexion")));
}

TEST_F(Program, EveryPresetNamesAMethodAndItsSettings) {
  const std::string trial = Simulate();
  int count = 0;
  for (const auto& preset :
       std::filesystem::directory_iterator(BRACHIUM_SOURCE_DIR "/bin/presets")) {
    const std::string estimate = Path(preset.path().stem().string());
    const Outcome outcome = Reconstruct(trial, estimate, {"--flagfile=" + preset.path().string()});
    EXPECT_EQ(outcome.exit_code, 0) << preset.path() << outcome.err;
    EXPECT_THAT(
        ReadText(preset.path()),
        HasSubstr("--method=" + ReadJson(estimate + "/summary.json")["method"].get<std::string>() +
                  "\n"));
    ++count;
  }
  EXPECT_GE(count, 6);
}

TEST_F(Program, SaysWhatIsMissingWhereNothingCanBeCalibrated) {
  const std::string trial = Simulate({"--notell_mountings"});
  const Outcome outcome = Run({"calibrate", "--trial=" + trial, "--output=" + Path("out.json")});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("trial.json"), HasSubstr("forearm: no mounting"),
                                 HasSubstr("calibration:upper_arm_abduction")));
  EXPECT_FALSE(std::filesystem::exists(Path("out.json")));
}

}  // namespace
}  // namespace brachium
