#include "io/estimate_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "io/csv.h"
#include "io/input_error.h"
#include "problems/arm_model.h"
#include "problems/joint_angles.h"
#include "tests/support/temporary_folder.h"

namespace brachium {
namespace {

using nlohmann::json;
using testing::ElementsAre, testing::HasSubstr, testing::Not;

const double kNaN = std::nan("");
const Eigen::Quaterniond kGap(kNaN, kNaN, kNaN, kNaN);

Estimate MakeEstimate() {
  Estimate estimate;
  estimate.method = "smoother";
  estimate.side = Side::kLeft;
  for (int i = 0; i < 5; ++i) {
    estimate.time.push_back(0.1 * i);
    const Eigen::Quaterniond q_WU = Eigen::Quaterniond(1, 0.1 * i, 0.3, 0.2).normalized();
    const ElbowAngles angles{.flexion = 0.2 * i, .carrying = 0.1, .pronation = 0.7};
    estimate.q_WB[Segment::kUpperArm].push_back(q_WU);
    estimate.q_WB[Segment::kForearm].push_back(q_WU * ElbowRotation(angles, Side::kLeft));
    estimate.sd_B[Segment::kForearm].emplace_back(0.01 * i, 0.02, 0.03);
    estimate.sd_W["elbow"].emplace_back(0.001 * i, 0.002, 0.003);
    estimate.sd_angle["elbow_flexion"].push_back(0.004 * i);
    estimate.p_W["elbow"].emplace_back(0.1 * i, 1.0 / 3, -0.2);
  }
  estimate.q_WB[Segment::kForearm][4] = kGap;
  estimate.p_W["elbow"][4] = {kNaN, kNaN, kNaN};
  Diagnostics& diagnostics = estimate.diagnostics;
  diagnostics.iterations = 12;
  diagnostics.gradient_norm = kNaN;
  diagnostics.residuals = {{"gyroscope/forearm", 300, 0.98}};
  diagnostics.constants = {{"elbow.carrying_angle_deg", {7.9}, {0.6}},
                           {"forearm.p_BS_m", {0.01, -0.2, 0.03}, {}}};
  diagnostics.rests = {{Segment::kForearm, 0.1, 0.3, 0.9}};
  diagnostics.figures = {{"knots", 42}};
  diagnostics.held_by_prior = {"the forearm's length"};
  diagnostics.notes = {"all is well"};
  estimate.timing = {{"solve", 0.25}};
  return estimate;
}

RunInfo MakeRun() {
  RunInfo run;
  run.trial = "drinking";
  run.options = {{"knot_spacing_s", 0.05}, {"whole_trial", true}};
  run.flags = {{"trial", "/data/my trial"}, {"knot_spacing_s", "0.05"}};
  run.findings.defaults = {"recordings[0].noise = mtw"};
  run.findings.repairs = {"forearm.csv: 1 gap bridged"};
  run.recordings = {{.segment = Segment::kForearm, .file = "forearm.csv", .lost_samples = 7}};
  run.inputs = {{"trial.json", "abc"}};
  run.versions = {{"brachium", "0.1.0"}};
  run.stages = {{"read", 0.5}};
  run.host = "bench";
  run.command_line = "brachium reconstruct";
  return run;
}

TEST(EstimateFolder, GivesTheSameMotionBack) {
  const TemporaryFolder here;
  const Estimate written = MakeEstimate();
  WriteEstimate(here.File("e"), written, MakeRun(), false);
  const Estimate read = ReadEstimate(here.File("e"));
  EXPECT_EQ(read.method, "smoother");
  EXPECT_EQ(read.side, Side::kLeft);
  EXPECT_EQ(read.time, written.time);
  ASSERT_EQ(read.q_WB.size(), 2u);
  for (const auto& [segment, q_WB] : written.q_WB)
    for (std::size_t i = 0; i < q_WB.size(); ++i) {
      const Eigen::Quaterniond& q = read.q_WB.at(segment).at(i);
      if (q_WB[i].coeffs().hasNaN())
        EXPECT_TRUE(q.coeffs().array().isNaN().all());
      else
        EXPECT_EQ(q.coeffs(), q_WB[i].coeffs());
    }
  ASSERT_EQ(read.sd_B.size(), 1u);
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_TRUE(read.sd_B.at(Segment::kForearm)[i].isApprox(written.sd_B.at(Segment::kForearm)[i]));
  ASSERT_EQ(read.sd_W.size(), 1u);
  ASSERT_EQ(read.sd_angle.size(), 1u);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(read.sd_W.at("elbow")[i], written.sd_W.at("elbow")[i]);
    EXPECT_NEAR(read.sd_angle.at("elbow_flexion")[i], 0.004 * static_cast<double>(i), 1e-12);
  }
  ASSERT_EQ(read.p_W.size(), 1u);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_EQ(read.p_W.at("elbow")[i], written.p_W.at("elbow")[i]);
  EXPECT_TRUE(read.p_W.at("elbow")[4].array().isNaN().all());
}

TEST(EstimateFolder, GivesTheFindingAndTheRunBack) {
  const TemporaryFolder here;
  Estimate written = MakeEstimate();
  written.diagnostics.headings = {{.segment = Segment::kForearm,
                                   .against = Segment::kUpperArm,
                                   .time = {2.5, 7.5},
                                   .sd = {0.1, INFINITY},
                                   .sd_by = {{"accelerometer", {0.2, 0.3}}}}};
  written.diagnostics.constants.push_back({"unknown", {kNaN}, {kNaN, 1.0}});
  WriteEstimate(here.File("e"), written, MakeRun(), false);
  const Diagnostics read = ReadEstimate(here.File("e")).diagnostics;
  EXPECT_EQ(read.iterations, 12);
  EXPECT_TRUE(std::isnan(read.gradient_norm));
  ASSERT_EQ(read.residuals.size(), 1u);
  EXPECT_EQ(read.residuals[0].count, 300u);
  ASSERT_EQ(read.constants.size(), 3u);
  EXPECT_THAT(read.constants[1].value, ElementsAre(0.01, -0.2, 0.03));
  EXPECT_TRUE(std::isnan(read.constants[2].value.at(0)));
  ASSERT_EQ(read.rests.size(), 1u);
  EXPECT_EQ(read.rests[0].end, 0.3);
  ASSERT_EQ(read.headings.size(), 1u);
  EXPECT_NEAR(read.headings[0].sd[0], 0.1, 1e-12);
  EXPECT_TRUE(std::isinf(read.headings[0].sd[1]));
  EXPECT_NEAR(read.headings[0].sd_by.at("accelerometer")[1], 0.3, 1e-12);
  EXPECT_THAT(read.held_by_prior, ElementsAre("the forearm's length"));
  EXPECT_THAT(read.notes, ElementsAre("all is well"));

  const RunInfo run = ReadRun(here.File("e"));
  EXPECT_EQ(run.trial, "drinking");
  EXPECT_EQ(run.flags, MakeRun().flags);
  EXPECT_EQ(run.findings.repairs, MakeRun().findings.repairs);
  EXPECT_EQ(run.inputs.at(0).sha256, "abc");
}

TEST(EstimateFolder, WritesJointAnglesInDegreesAndGapsAsEmptyCells) {
  const TemporaryFolder here;
  WriteEstimate(here.File("e"), MakeEstimate(), MakeRun(), false);
  const CsvTable table = ReadCsv(here.File("e/estimate.csv"));
  EXPECT_THAT(table.names,
              ElementsAre("time_s", "upper_arm_qw", "upper_arm_qx", "upper_arm_qy", "upper_arm_qz",
                          "forearm_qw", "forearm_qx", "forearm_qy", "forearm_qz",
                          "forearm_rx_sd_deg", "forearm_ry_sd_deg", "forearm_rz_sd_deg", "elbow_px",
                          "elbow_py", "elbow_pz", "elbow_px_sd", "elbow_py_sd", "elbow_pz_sd",
                          "elbow_flexion_deg", "elbow_flexion_sd_deg", "elbow_carrying_deg",
                          "forearm_pronation_deg", "shoulder_elevation_deg"));
  EXPECT_NEAR(table.Column("forearm_rx_sd_deg")[3], 0.03 / kDegree, 1e-9);
  EXPECT_NEAR(table.Column("elbow_flexion_deg")[3], 0.6 / kDegree, 1e-9);
  EXPECT_NEAR(table.Column("elbow_carrying_deg")[3], 0.1 / kDegree, 1e-9);
  EXPECT_NEAR(table.Column("forearm_pronation_deg")[3], 0.7 / kDegree, 1e-9);
  EXPECT_TRUE(std::isnan(table.Column("elbow_flexion_deg")[4]));
  EXPECT_FALSE(std::isnan(table.Column("shoulder_elevation_deg")[4]));
  EXPECT_THAT(here.Read("e/estimate.csv"), Not(HasSubstr("nan")));
}

TEST(EstimateFolder, WritesShoulderAnglesAgainstAThoraxAndWristAnglesWithAHand) {
  const TemporaryFolder here;
  Estimate estimate = MakeEstimate();
  const Eigen::Quaterniond q_TU(Eigen::AngleAxisd(-0.5, Eigen::Vector3d::UnitX()));
  estimate.side = Side::kRight;
  for (std::size_t i = 0; i < 5; ++i) {
    const Eigen::Quaterniond q_WU = estimate.q_WB[Segment::kUpperArm][i];
    estimate.q_WB[Segment::kThorax].push_back(q_WU * q_TU.conjugate());
    estimate.q_WB[Segment::kHand].push_back(
        estimate.q_WB[Segment::kForearm][i] *
        Eigen::Quaterniond(Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitZ())));
  }
  WriteEstimate(here.File("e"), estimate, MakeRun(), false);
  const CsvTable table = ReadCsv(here.File("e/estimate.csv"));
  EXPECT_NEAR(table.Column("shoulder_elevation_deg")[1], 0.5 / kDegree, 1e-9);
  EXPECT_NEAR(table.Column("shoulder_plane_deg")[1], 0.0, 1e-9);
  EXPECT_TRUE(table.Has("shoulder_rotation_deg"));
  EXPECT_NEAR(table.Column("wrist_flexion_deg")[1], 0.4 / kDegree, 1e-9);
  EXPECT_NEAR(table.Column("wrist_deviation_deg")[1], 0.0, 1e-9);
}

TEST(EstimateFolder, HasNoColumnForWhatIsNotEstimated) {
  const TemporaryFolder here;
  Estimate estimate = MakeEstimate();
  estimate.q_WB.erase(Segment::kUpperArm);
  estimate.p_W.clear();
  estimate.sd_B.clear();
  estimate.sd_W.clear();
  estimate.sd_angle.clear();
  WriteEstimate(here.File("e"), estimate, MakeRun(), false);
  EXPECT_EQ(ReadCsv(here.File("e/estimate.csv")).names.size(), 5u);
}

TEST(EstimateFolder, SumsTheRunUp) {
  const TemporaryFolder here;
  WriteEstimate(here.File("e"), MakeEstimate(), MakeRun(), false);
  const json summary = json::parse(here.Read("e/summary.json"));
  EXPECT_EQ(summary["brachium_summary"], 1);
  EXPECT_EQ(summary["method"], "smoother");
  EXPECT_EQ(summary["side"], "left");
  EXPECT_EQ(summary["options"]["knot_spacing_s"], 0.05);
  EXPECT_EQ(summary["convergence"]["iterations"], 12);
  EXPECT_TRUE(summary["convergence"]["gradient_norm"].is_null());
  EXPECT_EQ(summary["residuals"]["gyroscope/forearm"]["rms"], 0.98);
  EXPECT_EQ(summary["constants"]["elbow.carrying_angle_deg"], json({{"value", 7.9}, {"sd", 0.6}}));
  EXPECT_EQ(summary["constants"]["forearm.p_BS_m"], json({{"value", {0.01, -0.2, 0.03}}}));
  EXPECT_EQ(summary["rests"][0]["end_s"], 0.3);
  EXPECT_EQ(summary["figures"]["knots"], 42);
  EXPECT_EQ(summary["held_by_prior"][0], "the forearm's length");
  EXPECT_EQ(summary["notes"][0], "all is well");
  EXPECT_EQ(summary["defaults"][0], "recordings[0].noise = mtw");
  EXPECT_EQ(summary["repairs"][0], "forearm.csv: 1 gap bridged");
  EXPECT_EQ(summary["recordings"][0]["lost_samples"], 7);
  EXPECT_EQ(summary["inputs"][0]["sha256"], "abc");
  EXPECT_EQ(summary["versions"]["brachium"], "0.1.0");
  EXPECT_THAT(summary["conventions"]["world"].get<std::string>(), HasSubstr("z up"));
  EXPECT_EQ(here.Read("e/run.flags"), "--trial=/data/my trial\n--knot_spacing_s=0.05\n");
}

TEST(EstimateFolder, KeepsWhatMayDifferBetweenTwoRunsInTimingAlone) {
  const TemporaryFolder here;
  Estimate estimate = MakeEstimate();
  RunInfo run = MakeRun();
  WriteEstimate(here.File("a"), estimate, run, false);
  estimate.timing[0].seconds = 99;
  run.host = "elsewhere";
  run.command_line = "another";
  WriteEstimate(here.File("b"), estimate, run, false);
  for (const char* name : {"estimate.csv", "summary.json", "run.flags"})
    EXPECT_EQ(here.Read(std::string("a/") + name), here.Read(std::string("b/") + name)) << name;
  const json timing = json::parse(here.Read("b/timing.json"));
  EXPECT_EQ(timing["stages"][1]["seconds"], 99);
  EXPECT_EQ(timing["host"], "elsewhere");
  EXPECT_EQ(timing["command_line"], "another");
}

TEST(EstimateFolder, IsOverwrittenOnlyWhenTold) {
  const TemporaryFolder here;
  Estimate estimate = MakeEstimate();
  WriteEstimate(here.File("e"), estimate, MakeRun(), false);
  here.Write("e/evaluation.json", "{}");
  estimate.method = "gyroscope";
  EXPECT_THROW(WriteEstimate(here.File("e"), estimate, MakeRun(), false), OutputExists);
  EXPECT_EQ(ReadEstimate(here.File("e")).method, "smoother");
  WriteEstimate(here.File("e"), estimate, MakeRun(), true);
  EXPECT_EQ(ReadEstimate(here.File("e")).method, "gyroscope");
  EXPECT_FALSE(here.Has("e/evaluation.json"));
}

TEST(EstimateFolder, IsRefusedWhenItsMotionIsCutOff) {
  const TemporaryFolder here;
  WriteEstimate(here.File("e"), MakeEstimate(), MakeRun(), false);
  std::string motion = here.Read("e/estimate.csv");
  motion.pop_back();
  here.Write("e/estimate.csv", motion.substr(0, motion.rfind('\n') + 1));
  EXPECT_THROW(ReadEstimate(here.File("e")), InputError);
}

TEST(EstimateFolder, IsRefusedWhenItIsNone) {
  const TemporaryFolder here;
  EXPECT_THROW(ReadEstimate(here.File("absent")), InputError);
  EXPECT_THROW(ReadEstimate(here.path()), InputError);
  WriteEstimate(here.File("e"), MakeEstimate(), MakeRun(), false);
  here.Write("e/summary.json", "{\"brachium_summary\": 7}");
  EXPECT_THROW(ReadEstimate(here.File("e")), InputError);
}

}  // namespace
}  // namespace brachium
