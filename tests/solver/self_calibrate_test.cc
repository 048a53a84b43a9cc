#include "solver/self_calibrate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "io/trial_folder.h"
#include "problems/rotation.h"
#include "solver/ball_joint.h"
#include "tests/support/simulated_trial.h"

namespace brachium {
namespace {

namespace fs = std::filesystem;

using Eigen::Quaterniond, Eigen::Vector3d;
using testing::Contains, testing::ElementsAre, testing::HasSubstr, testing::IsEmpty;
using testing::Not, testing::SizeIs;

SimulationOptions Untold() {
  SimulationOptions errors;
  errors.tell_mountings = false;
  return errors;
}

ScenarioOptions Worn(Side side, double duration = 35.0) {
  ScenarioOptions options = BriskScenario(duration);
  options.side = side;
  return options;
}

Calibration Calibrated(const Observations& observations) { return SelfCalibrate(observations, {}); }

Vector3d ErrorOf(const SegmentCalibration& segment, const SimulatedTrial& simulated) {
  const auto& q = simulated.True(std::string(Name(segment.segment)) + ".q_BS_wxyz");
  return Log<double>(segment.mounting.q_BS * Quaterniond(q[0], q[1], q[2], q[3]).conjugate());
}

double FigureOf(const SegmentCalibration& segment, const std::string& name) {
  for (const Figure& figure : segment.figures)
    if (figure.name == name) return figure.value;
  ADD_FAILURE() << "no figure " << name;
  return 0.0;
}

Vector3d SdsOf(const SegmentCalibration& segment) {
  return kDegree * Vector3d(FigureOf(segment, "rx_sd_deg"), FigureOf(segment, "ry_sd_deg"),
                            FigureOf(segment, "rz_sd_deg"));
}

TEST(SelfCalibrate, AsksForMoreWhereTheSensorsShareNextToNothing) {
  Observations observations = Brisk(35).observations;
  observations.recordings[0] = Cut(observations.recordings[0], 20.0, 20.2);
  observations.recordings[1] = Cut(observations.recordings[1], 20.02, 20.09);
  EXPECT_THAT(Calibrated(observations).faults, Contains(HasSubstr("10 s")));
}

TEST(SelfCalibrate, FindsBothMountingsOfEitherArmFromMovementThatNobodyLabelled) {
  for (const Side side : {Side::kRight, Side::kLeft}) {
    const SimulatedTrial simulated = Simulate(MakeScenario(Worn(side)), Untold());
    const Calibration calibration = Calibrated(simulated.trial.observations);
    EXPECT_THAT(calibration.faults, IsEmpty());
    ASSERT_THAT(calibration.segments, SizeIs(2));
    for (const SegmentCalibration& segment : calibration.segments) {
      SCOPED_TRACE(std::string(Name(side)) + " " + std::string(Name(segment.segment)));
      const Vector3d error = ErrorOf(segment, simulated), sds = SdsOf(segment);
      EXPECT_LT(error.norm(), 7 * kDegree);
      EXPECT_LT((error.array() / sds.array()).abs().maxCoeff(), 2.0);
      EXPECT_NEAR(segment.mounting.q_sigma, sds.maxCoeff(), 1e-12);
      const auto& p = simulated.True(std::string(Name(segment.segment)) + ".p_BS_m");
      EXPECT_LT((segment.mounting.p_BS_B - Vector3d(p.data())).norm(), 0.03);
    }
  }
}

TEST(SelfCalibrate, LeavesBothZerosToTheirPriorAndSaysSo) {
  SimulatedTrial simulated = Simulate(MakeScenario(Worn(Side::kRight)), Untold());
  Observations& observations = simulated.trial.observations;
  observations.start_pose->sigma = 12 * kDegree;
  const Calibration as_told = Calibrated(observations);
  observations.start_pose->forearm_pronation = 110 * kDegree;
  const Calibration otherwise = Calibrated(observations);
  ASSERT_THAT(as_told.segments, SizeIs(2));
  const Quaterniond turned =
      otherwise.segments[1].mounting.q_BS * as_told.segments[1].mounting.q_BS.conjugate();
  EXPECT_NEAR(Log<double>(turned).cwiseAbs().y(), 20 * kDegree, 1e-6);
  EXPECT_NEAR(turned.angularDistance(Quaterniond::Identity()), 20 * kDegree, 1e-6);
  EXPECT_NEAR(as_told.segments[1].mounting.q_sigma, 12 * kDegree, 1e-9);
  EXPECT_THAT(as_told.notes, Contains(HasSubstr("zero of pronation")));
  EXPECT_THAT(as_told.notes, Contains(HasSubstr("zero of flexion")));
}

TEST(SelfCalibrate, KeepsToldPositions) {
  Observations observations =
      Simulate(MakeScenario(Worn(Side::kRight)), Untold()).trial.observations;
  observations.recordings[0].mounting = Mounting{.p_BS_B = {1, 2, 3}, .p_sigma = 0.5};
  const Calibration calibration = Calibrated(observations);
  ASSERT_THAT(calibration.segments, SizeIs(2));
  EXPECT_EQ(calibration.segments[0].mounting.p_BS_B, Vector3d(1, 2, 3));
  EXPECT_EQ(calibration.segments[0].mounting.p_sigma, 0.5);
}

TEST(SelfCalibrate, SaysWhereSkinTurnsUnderTheSensors) {
  SimulationOptions errors = Untold();
  const auto departs = HasSubstr("departs from any two axes");
  EXPECT_THAT(
      Calibrated(Simulate(MakeScenario(Worn(Side::kLeft)), errors).trial.observations).notes,
      Not(Contains(departs)));
  errors.soft_tissue = TypicalSoftTissue();
  errors.soft_tissue.upper_arm_along_rms = 12 * kDegree;
  EXPECT_THAT(
      Calibrated(Simulate(MakeScenario(Worn(Side::kLeft)), errors).trial.observations).notes,
      Contains(departs));
}

TEST(SelfCalibrate, RefusesWhereSkinMovesTheSensorsMoreThanTheArmDoes) {
  ScenarioOptions slow = Worn(Side::kRight, 60.0);
  slow.name = "daily_slow";
  SimulationOptions errors = Untold();
  errors.soft_tissue = TypicalSoftTissue();
  errors.soft_tissue.upper_arm_along_rms = 8 * kDegree;
  const Calibration calibration =
      Calibrated(Simulate(MakeScenario(slow), errors).trial.observations);
  EXPECT_THAT(calibration.faults, ElementsAre(HasSubstr("the elbow is seen")));
  EXPECT_THAT(calibration.segments, IsEmpty());
}

TEST(SelfCalibrate, RefusesWhatIsTooShortOrStartsInNoKnownPose) {
  const SimulatedTrial simulated = Simulate(MakeScenario(Worn(Side::kRight)), Untold());
  const auto cut = [&](double start, double end) {
    Observations observations = simulated.trial.observations;
    for (Recording& recording : observations.recordings) recording = Cut(recording, start, end);
    observations.start_pose.reset();
    return observations;
  };
  EXPECT_THAT(Calibrated(cut(0.0, 9.0)).faults, ElementsAre(HasSubstr("10 s or more")));
  EXPECT_THAT(Calibrated(cut(10.0, 33.0)).faults, ElementsAre(HasSubstr("zero of pronation")));
  EXPECT_THAT(Calibrated(cut(0.0, 33.0)).faults, IsEmpty());
}

TEST(SelfCalibrate, GivesBothArmsOfAPersonAPlausibleAndConsistentElbow) {
  const fs::path trials = fs::path(BRACHIUM_SOURCE_DIR) / "../shared/data/trials";
  if (!fs::exists(trials)) GTEST_SKIP() << trials << " is absent";
  std::vector<double> carrying;
  for (const std::string side : {"right", "left"}) {
    SCOPED_TRACE(side);
    const auto folder = ReadTrial((trials / ("qmt_human_" + side + "_arm")).string());
    const Calibration calibration = Calibrated(folder.trial.observations);
    ASSERT_THAT(calibration.segments, SizeIs(2));
    const auto figure = [&](const char* name) { return FigureOf(calibration.segments[1], name); };
    EXPECT_GE(figure("flexion_least_deg"), -5.01);
    EXPECT_LE(figure("flexion_most_deg"), 160.0);
    EXPECT_LT(figure("pronation_most_deg") - figure("pronation_least_deg"), 190.0);
    carrying.push_back(figure("carrying_median_deg"));
  }
  EXPECT_NEAR(carrying[0], carrying[1], 6.0);
}

TEST(BallJoint, SeesTheElbowThoughTheShoulderGoesWhereItWill) {
  ScenarioOptions options = Worn(Side::kRight);
  options.shoulder_rms = 0.2;
  const SimulatedTrial simulated = Simulate(MakeScenario(options), Untold());
  std::string why;
  const auto joint = FollowBallJoint(simulated.trial.observations, &why);
  ASSERT_TRUE(joint) << why;
  const auto& q = simulated.True("forearm.q_BS_wxyz");
  const auto& p = simulated.True("forearm.p_BS_m");
  const Vector3d found_B = Quaterniond(q[0], q[1], q[2], q[3]) * joint->elbow_to_sensor_B;
  EXPECT_LT((found_B - Vector3d(p.data())).norm(), 0.005);
  EXPECT_LT(joint->heading_sd, 2 * kDegree);
}

}  // namespace
}  // namespace brachium
