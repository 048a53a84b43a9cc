// What the program writes and reads, against the schemas in io/schemas.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/run_program.h"

namespace brachium {
namespace {

using nlohmann::json;

class Schemas : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    if (Judge("trial", "") == 77) GTEST_SKIP() << "python3 has no jsonschema here";
  }

  // The exit code of the validator.
  int Judge(const std::string& schema, const std::string& file) const {
    std::string command = "python3 '" BRACHIUM_SOURCE_DIR "/tests/support/validate_json.py' '" +
                          std::string(BRACHIUM_SOURCE_DIR "/io/schemas/") + schema +
                          ".schema.json'";
    if (!file.empty()) command += " '" + Path(file) + "'";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  void ExpectValid(const std::string& schema, const std::string& file) const {
    EXPECT_EQ(Judge(schema, file), 0) << file << " by " << schema << ".schema.json";
  }
};

TEST_F(Schemas, DescribeTrialsEstimatesAndEvaluations) {
  const std::string trial = Simulate({"--tell_rests", "--tell_end_pose"});
  ExpectValid("trial", "trial/trial.json");
  ExpectValid("truth", "trial/truth.json");
  ASSERT_EQ(Reconstruct(trial, Path("estimate")).exit_code, 0);
  RunWell({"evaluate", "--trial=" + trial, "--estimate=" + Path("estimate")});
  ExpectValid("summary", "estimate/summary.json");
  ExpectValid("timing", "estimate/timing.json");
  ExpectValid("evaluation", "estimate/evaluation.json");
}

TEST_F(Schemas, DescribeTrialsWithContacts) {
  RunWell({"simulate", "--scenario=nine_hole_peg_test", "--tell_contacts",
           "--output=" + Path("trial")});
  EXPECT_EQ(json::parse(ReadText(Path("trial/trial.json")))["contacts"].size(), 2u);
  ExpectValid("trial", "trial/trial.json");
}

TEST_F(Schemas, DescribeComparisonsWithMembersThatRefuse) {
  const std::string trial = Simulate();
  json description = json::parse(ReadText(trial + "/trial.json"));
  description["arm"]["elbow"] = {{"constraint", "none"}};
  Write("trial/trial.json", description.dump());
  ExpectValid("trial", "trial/trial.json");
  RunWell({"compare", "--trial=" + trial, "--methods=gyroscope,luinge,bai_kinematic",
           "--output=" + Path("comparison")});
  ExpectValid("comparison", "comparison/comparison.json");
  ExpectValid("timing", "comparison/timing.json");
  for (const std::string method : {"gyroscope", "bai_kinematic"}) {
    ExpectValid("evaluation", "comparison/estimates/trial/" + method + "/evaluation.json");
    ExpectValid("summary", "comparison/estimates/trial/" + method + "/summary.json");
  }
}

TEST_F(Schemas, DescribeComparisonsOfTrialsThatCannotBeRead) {
  const std::string trial = Simulate();
  std::filesystem::remove(trial + "/forearm.csv");
  const Outcome outcome =
      Run({"compare", "--trial=" + trial, "--methods=gyroscope", "--output=" + Path("comparison")});
  ASSERT_EQ(outcome.exit_code, 2) << outcome.err;
  ExpectValid("comparison", "comparison/comparison.json");
  ExpectValid("timing", "comparison/timing.json");
}

TEST_F(Schemas, DescribeSweepsWhole) {
  const std::string manifest = Path("sweep/manifest.jsonl");
  RunWell({"sweep", "plan", "--trials=" + Simulate(), "--method=luinge,smoother",
           "--vary=luinge_adduction_sigma_deg=1,10;solver=chain", "--output=" + Path("sweep")});
  ExpectValid("manifest", "sweep/manifest.jsonl");
  RunWell({"sweep", "run", "--manifest=" + manifest, "--shard=0/3"});
  RunWell({"sweep", "merge", "--manifest=" + manifest, "--partial"});
  ExpectValid("sweep", "sweep/sweep.json");
  RunWell({"sweep", "run", "--manifest=" + manifest});
  RunWell({"sweep", "merge", "--manifest=" + manifest});
  ExpectValid("sweep", "sweep/sweep.json");
  ExpectValid("timing", "sweep/timing.json");
  for (const char* task : {"000000", "000001", "000002"})
    ExpectValid("result", std::string("sweep/results/000/") + task + ".json");
  for (const auto& entry : std::filesystem::directory_iterator(Path("sweep/timing")))
    ExpectValid("timing", "sweep/timing/" + entry.path().filename().string());
}

TEST_F(Schemas, DescribeSweepsOfTrialsThatAMethodRefuses) {
  const std::string trial = Simulate(), manifest = Path("sweep/manifest.jsonl");
  json description = json::parse(ReadText(trial + "/trial.json"));
  description["arm"]["elbow"] = {{"constraint", "none"}};
  Write("trial/trial.json", description.dump());
  RunWell({"sweep", "plan", "--trials=" + trial, "--method=luinge",
           "--vary=luinge_adduction_sigma_deg=1,10", "--output=" + Path("sweep")});
  RunWell({"sweep", "run", "--manifest=" + manifest});
  RunWell({"sweep", "merge", "--manifest=" + manifest});
  ExpectValid("result", "sweep/results/000/000000.json");
  ExpectValid("sweep", "sweep/sweep.json");
}

TEST_F(Schemas, DescribeCalibratedTrials) {
  RunWell({"simulate", "--scenario=calibration", "--notell_mountings", "--output=" + Path("raw")});
  std::filesystem::create_directory(Path("calibrated"));
  RunWell({"calibrate", "--trial=" + Path("raw"), "--output=" + Path("calibrated/trial.json")});
  ExpectValid("trial", "calibrated/trial.json");
}

TEST_F(Schemas, DescribeImportedTrials) {
  Write("MT_1_00B42D4B.txt",
        "// Update Rate: 100.0Hz\nPacketCounter;Acc_X;Acc_Y;Acc_Z;Gyr_X;Gyr_Y;Gyr_Z\n"
        "1;0;0;9.81;0;0;0\n2;0;0;9.81;0;0;0\n3;0;0;9.81;0;0;0\n");
  RunWell({"import", "--format=xsens_mt", "--files=" + Path(""), "--map=00B42D4B:forearm",
           "--side=left", "--output=" + Path("imported")});
  ExpectValid("trial", "imported/trial.json");
}

TEST_F(Schemas, RefuseWhatTheyDoNotDescribe) {
  const json trial = json::parse(ReadText(Simulate() + "/trial.json"));
  const auto refuses = [&](const char* pointer, const json& value) {
    json spoiled = trial;
    spoiled[json::json_pointer(pointer)] = value;
    Write("trial/spoiled.json", spoiled.dump());
    return Judge("trial", "trial/spoiled.json") == 1;
  };
  EXPECT_FALSE(refuses("/name", "another"));
  EXPECT_TRUE(refuses("/arm/side", "middle"));
  EXPECT_TRUE(refuses("/gravity_m_s2", 981));
  EXPECT_TRUE(refuses("/recordings/0/mountings", json::object()));
  EXPECT_TRUE(refuses("/recordings/0/mounting/p_BS_m", {0.0, 1.0}));
}

}  // namespace
}  // namespace brachium
