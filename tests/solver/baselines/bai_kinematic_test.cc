#include "solver/baselines/bai_kinematic.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "problems/evaluation.h"
#include "problems/joint_angles.h"
#include "tests/support/longer_chain.h"
#include "tests/support/simulated_trial.h"

namespace brachium {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;
using testing::Contains, testing::HasSubstr, testing::IsEmpty, testing::Not;

ScenarioOptions StillShoulder(Side side) {
  return {.name = "reach", .seed = 2, .side = side, .duration = 16, .shoulder_rms = 0.0};
}

// As a maker would tell the orientation of each sensor.
void TellOrientations(Trial& trial) {
  for (Recording& recording : trial.observations.recordings)
    for (const Quaterniond& q_VB : trial.reference->q_VB.at(recording.segment))
      recording.q_WS.push_back(q_VB * recording.mounting->q_BS);
}

double WorstError(const std::string& joint, const Estimate& estimate, const Reference& reference) {
  return Evaluate(estimate, reference).positions.at(joint).aligned.distance.max;
}

TEST(BaiKinematic, FindsEveryJointFromTheMakersOrientationsOnBothSides) {
  for (const Side side : {Side::kRight, Side::kLeft}) {
    Trial trial = Simulate(MakeScenario(StillShoulder(side)), NoErrors()).trial;
    TellOrientations(trial);
    const Estimate estimate = BaiKinematic({}).Run(trial.observations);
    EXPECT_LT(RelativeError(estimate, *trial.reference), 1e-9);
    for (const char* joint : {"shoulder", "elbow", "wrist"})
      EXPECT_LT(WorstError(joint, estimate, *trial.reference), 1e-9) << joint;
    EXPECT_THAT(estimate.diagnostics.epochs, Not(IsEmpty()));
  }
}

TEST(BaiKinematic, OrientsRawRecordingsByTheFilterOf2005) {
  const Trial trial = Simulate(MakeScenario(StillShoulder(Side::kRight)), NoErrors()).trial;
  const Estimate estimate = BaiKinematic({}).Run(trial.observations);
  const Estimate filtered = LuingeUnconstrained({}).Run(trial.observations);
  EXPECT_EQ(estimate.q_WB.at(Segment::kForearm)[500].coeffs(),
            filtered.q_WB.at(Segment::kForearm)[500].coeffs());
  EXPECT_THAT(estimate.diagnostics.notes, Contains(HasSubstr("2005")));
  EXPECT_LT(WorstError("wrist", estimate, *trial.reference), 0.05);
}

// A field of 60 deg dip, read without error.
void TellMagnetometers(Trial& trial) {
  const Vector3d field(0.5, 0.0, -0.87);
  for (Recording& recording : trial.observations.recordings)
    for (const auto& q_VB : trial.reference->q_VB.at(recording.segment))
      recording.mag_S.push_back((q_VB * recording.mounting->q_BS).conjugate() * field);
}

TEST(BaiKinematic, KeepsTheHeadingsOfRawRecordingsByTheirMagnetometers) {
  Trial trial = Simulate(MakeScenario(StillShoulder(Side::kRight)), NoErrors()).trial;
  trial.observations.start_pose.reset();
  const double blind = RelativeError(BaiKinematic({}).Run(trial.observations), *trial.reference);
  TellMagnetometers(trial);
  const Estimate estimate = BaiKinematic({}).Run(trial.observations);
  EXPECT_THAT(estimate.diagnostics.notes, Contains(HasSubstr("magnetometers")));
  EXPECT_GT(blind, 10 * kDegree);
  EXPECT_LT(RelativeError(estimate, *trial.reference), 2 * kDegree);
}

TEST(BaiKinematic, DoesWithoutMagnetometersThatNotAllSensorsHave) {
  Trial trial = Simulate(MakeScenario(StillShoulder(Side::kRight)), NoErrors()).trial;
  const Estimate without = BaiKinematic({}).Run(trial.observations);
  TellMagnetometers(trial);
  trial.observations.recordings[1].mag_S.clear();
  EXPECT_EQ(BaiKinematic({}).Run(trial.observations).q_WB.at(Segment::kForearm)[500].coeffs(),
            without.q_WB.at(Segment::kForearm)[500].coeffs());
}

TEST(BaiKinematic, ReadsTheElevationWhereThePaperReadsTheAbduction) {
  const double raised = 60 * kDegree;
  const Eigen::AngleAxisd hanging(90 * kDegree, Vector3d::UnitX());  // y up, x forward, z right
  for (const Vector3d& axis_W : {Vector3d(0, -1, 0), Vector3d(-1, 0, 0)}) {  // flexion, abduction
    const Quaterniond q_WU(Eigen::AngleAxisd(raised, axis_W) * hanging);
    const double pitch = std::asin(-(q_WU * Vector3d::UnitY()).z());
    EXPECT_NEAR(pitch + 90 * kDegree, raised, 1e-12);
    EXPECT_NEAR(ShoulderElevation(q_WU), raised, 1e-12);
  }
}

TEST(BaiKinematic, AddsTheHandToTheEndOfTheChain) {
  const Scenario scenario = MakeScenario(StillShoulder(Side::kRight));
  Trial trial = Simulate(scenario, NoErrors()).trial;
  AddHand(scenario, trial);
  const Estimate estimate = BaiKinematic({}).Run(trial.observations);
  for (std::size_t i = 0; i < estimate.time.size(); i += 100) {
    const Vector3d hand = estimate.p_W.at("wrist")[i] +
                          estimate.q_WB.at(Segment::kHand)[i] * Vector3d(0.0, -0.08, 0.0);
    EXPECT_LT((estimate.p_W.at("hand")[i] - hand).norm(), 1e-9);
  }
}

TEST(BaiKinematic, ReachesFromTheNeckToTheShoulderByLengthAndAngleOfTheGirdle) {
  for (const Side side : {Side::kRight, Side::kLeft}) {
    Trial trial = Simulate(MakeScenario(StillShoulder(side)), NoErrors()).trial;
    const Quaterniond upright(Eigen::AngleAxisd(std::numbers::pi / 2, Vector3d::UnitX()));
    Recording girdle = trial.observations.recordings[0];
    girdle.segment = Segment::kGirdle;
    girdle.mounting = Mounting{};
    for (Vector3d& gyr : girdle.gyr_S) gyr.setZero();
    for (Vector3d& acc : girdle.acc_S) acc = upright.conjugate() * Vector3d(0, 0, kGravity);
    trial.observations.arm.segments[Segment::kGirdle] = {};
    trial.observations.recordings.insert(trial.observations.recordings.begin(), girdle);
    BaiKinematicOptions options;
    options.bai_girdle_length_m = 0.2;
    options.bai_girdle_angle_deg = 30.0;
    const Estimate estimate = BaiKinematic(options).Run(trial.observations);
    const Vector3d shoulder = estimate.p_W.at("shoulder")[100];
    EXPECT_NEAR(shoulder.z(), -0.1, 1e-3);
    const Vector3d right_W = estimate.q_WB.at(Segment::kGirdle)[100] * Vector3d::UnitZ();
    EXPECT_NEAR(shoulder.dot(right_W), Sign(side) * 0.2 * std::cos(30 * kDegree), 1e-3);
    EXPECT_THAT(estimate.diagnostics.notes, Contains(HasSubstr("neck")));
  }
}

TEST(BaiKinematic, TakesMissingMountingsFromAStaticPose) {
  Trial trial = Simulate(MakeScenario(StillShoulder(Side::kRight)), NoErrors()).trial;
  TellOrientations(trial);
  for (Recording& recording : trial.observations.recordings) recording.mounting.reset();
  std::string why;
  EXPECT_FALSE(BaiKinematic({}).Accepts(trial.observations, &why));
  EXPECT_THAT(why, HasSubstr("static_pose"));
  trial.observations.intervals = {{"calibration:static_pose", 0.2, 2.8}};
  ASSERT_TRUE(BaiKinematic({}).Accepts(trial.observations, &why)) << why;
  // The simulated arm hangs 8 deg abducted with a bent elbow, where the pose expects it straight.
  const Estimate estimate = BaiKinematic({}).Run(trial.observations);
  EXPECT_LT(WorstError("wrist", estimate, *trial.reference), 0.15);
}

TEST(BaiKinematic, RefusesASingleSensorAndNamesTheMethodForIt) {
  Observations observations = Brisk(16).observations;
  observations.recordings.pop_back();
  std::string why;
  EXPECT_FALSE(BaiKinematic({}).Accepts(observations, &why));
  EXPECT_THAT(why, HasSubstr("bai_dead_reckoning"));
}

}  // namespace
}  // namespace brachium
