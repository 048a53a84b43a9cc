#include "io/evaluation_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "io/output_folder.h"
#include "problems/arm_model.h"
#include "problems/rotation.h"
#include "tests/support/smooth_motion.h"

namespace brachium {
namespace {

namespace fs = std::filesystem;
using Eigen::Quaterniond, Eigen::Vector3d;
using nlohmann::json;

// A forearm that is 3 deg off about its own axis, a wrist that is 5 mm too high at its end.
Evaluation Example(Reference::Frames frames = Reference::Frames::kSegment) {
  Estimate estimate;
  estimate.method = "smoother";
  estimate.time = EvenTimes(0.0, 0.01, 1000);
  estimate.q_WB[Segment::kUpperArm] =
      Sampled(estimate.time, [](double t) { return SmoothRotation(t); });
  estimate.q_WB[Segment::kForearm] =
      Sampled(estimate.time, [](double t) { return SmoothRotation(t, 1.0); });
  estimate.p_W["wrist"] = Sampled(estimate.time, SmoothPoint);
  Reference reference;
  reference.time = estimate.time;
  reference.q_VB = estimate.q_WB;
  reference.p_V = estimate.p_W;
  reference.frames = frames;
  reference.clock_offset = 0.0;
  reference.q_VB[Segment::kUpperArm][7].x() = std::nan("");
  for (Quaterniond& q : estimate.q_WB[Segment::kForearm]) q = q * Exp(Vector3d(0, 3 * kDegree, 0));
  estimate.p_W["wrist"].back().x() += 0.005;
  return Evaluate(estimate, reference);
}

json Parsed(const Evaluation& evaluation) { return json::parse(EvaluationJson(evaluation)); }

class EvaluationFile : public testing::Test {
 protected:
  void SetUp() override { fs::remove_all(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  std::string Text() const {
    std::ifstream file(folder_ / "evaluation.json");
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
  }

  const fs::path folder_ =
      fs::path(testing::TempDir()) /
      ("evaluation_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
};

TEST(EvaluationJson, HasTheRelativeErrorInDegreesWhereItIsLookedFor) {
  const json forearm = Parsed(Example())["relative"]["forearm_in_upper_arm"];
  EXPECT_NEAR(forearm["rmse_deg"].get<double>(), 3.0, 1e-9);
  EXPECT_EQ(forearm["alignment"], "none");
  EXPECT_EQ(forearm["rmse_deg"], forearm["raw"]["rmse_deg"]);
  EXPECT_NEAR(forearm["aligned"]["rmse_deg"].get<double>(), 0.0, 1e-6);
}

TEST(EvaluationJson, TakesTheAlignedErrorWhereFramesAreClusters) {
  const json evaluation = Parsed(Example(Reference::Frames::kCluster));
  const json forearm = evaluation["relative"]["forearm_in_upper_arm"];
  EXPECT_EQ(evaluation["frames"], "cluster");
  EXPECT_NEAR(forearm["rmse_deg"].get<double>(), 0.0, 1e-6);
  EXPECT_EQ(forearm["alignment"], "one constant rotation on each side");
  EXPECT_NEAR(forearm["raw"]["rmse_deg"].get<double>(), 3.0, 1e-9);
  EXPECT_TRUE(evaluation["joint_angles"].empty());
}

TEST(EvaluationJson, HasInclinationAndHeadingOfEachSegment) {
  const json evaluation = Parsed(Example());
  for (const char* segment : {"upper_arm", "forearm"}) {
    const json orientation = evaluation["orientation"][segment];
    EXPECT_TRUE(orientation["inclination"]["rmse_deg"].is_number());
    EXPECT_TRUE(orientation["heading"]["rmse_deg"].is_number());
    EXPECT_TRUE(orientation["raw"]["inclination"]["p95_deg"].is_number());
  }
  EXPECT_EQ(evaluation["orientation"]["upper_arm"]["samples_left_out"], 1);
}

TEST(EvaluationJson, HasEveryStatisticOfAJointAngle) {
  const json pronation = Parsed(Example())["joint_angles"]["forearm_pronation"];
  EXPECT_NEAR(pronation["bias_deg"].get<double>(), 3.0, 1e-9);
  for (const char* name : {"sd_deg", "rmse_deg", "median_deg", "p95_deg", "max_deg", "correlation"})
    EXPECT_TRUE(pronation[name].is_number()) << name;
  EXPECT_EQ(pronation["samples_used"], 999);
}

TEST(EvaluationJson, HasPositionsInMetresAndInPercentOfThePath) {
  const json wrist = Parsed(Example())["positions"]["wrist"];
  const double final = wrist["final_horizontal_m"], path = wrist["path_length_m"];
  EXPECT_NEAR(final, 0.005, 1e-4);
  EXPECT_NEAR(wrist["final_horizontal_percent_of_path"].get<double>(), 100 * final / path, 1e-9);
  EXPECT_NEAR(wrist["rms_horizontal_m"].get<double>(), 0.005 / std::sqrt(1000.0), 1e-5);
  EXPECT_TRUE(wrist["vertical"]["rmse_m"].is_number());
}

TEST(EvaluationJson, SaysWhereTheClockOffsetComesFrom) {
  Evaluation evaluation = Example();
  EXPECT_EQ(Parsed(evaluation)["clock_offset"]["source"], "given");
  evaluation.clock_offset = {
      .seconds = 0.0161, .source = ClockOffset::Source::kEstimated, .correlation = 0.99};
  const json offset = Parsed(evaluation)["clock_offset"];
  EXPECT_EQ(offset["seconds"], 0.0161);
  EXPECT_EQ(offset["estimated"], true);
  EXPECT_EQ(offset["correlation"], 0.99);
}

TEST(EvaluationJson, IsWholeWhereNothingWasCompared) {
  const json empty = Parsed(Evaluate(Estimate{}, Reference{}));
  EXPECT_EQ(empty["samples"]["used"], 0);
  EXPECT_EQ(empty["clock_offset"]["source"], "unknown");
  EXPECT_TRUE(empty["relative"].empty());
  Evaluation unknown;
  unknown.joint_angles["elbow_flexion"] = JointAngleError{};
  EXPECT_TRUE(Parsed(unknown)["joint_angles"]["elbow_flexion"]["rmse_deg"].is_null());
}

TEST_F(EvaluationFile, IsWrittenWholeIntoAFolderThatIsMade) {
  WriteEvaluation(folder_.string(), Example(), false);
  EXPECT_EQ(Text(), EvaluationJson(Example()));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

TEST_F(EvaluationFile, IsNotOverwrittenUnlessAskedFor) {
  WriteEvaluation(folder_.string(), Example(), false);
  const std::string before = Text();
  const Evaluation other = Example(Reference::Frames::kCluster);
  EXPECT_THROW(WriteEvaluation(folder_.string(), other, false), OutputExists);
  EXPECT_EQ(Text(), before);
  EXPECT_NO_THROW(WriteEvaluation(folder_.string(), Example(), false));
  WriteEvaluation(folder_.string(), other, true);
  EXPECT_EQ(Text(), EvaluationJson(other));
}

TEST_F(EvaluationFile, LeavesNothingBehindWhereItCannotBeWritten) {
  fs::create_directories(folder_ / "evaluation.json" / "full");
  EXPECT_THROW(WriteEvaluation(folder_.string(), Example(), true), OutputError);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

}  // namespace
}  // namespace brachium
