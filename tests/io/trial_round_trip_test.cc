#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/output_folder.h"
#include "io/trial_folder.h"
#include "tests/support/temporary_folder.h"

namespace brachium {
namespace {

using testing::IsEmpty;

constexpr double kTolerance = 1e-14;  // degrees and unit quaternions are rounded once more
const double kNaN = std::nan("");

Recording MakeRecording(Segment segment, double start) {
  Recording recording;
  recording.segment = segment;
  for (int i = 0; i < 30; ++i) {
    const double t = start + 0.01 * i;
    recording.time.push_back(t);
    recording.gyr_S.emplace_back(std::sin(t), 0.1 / 3, -1e-17);
    recording.acc_S.emplace_back(0.3, 9.7 + std::cos(t), 1.0 / 7);
    recording.q_WS.push_back(Eigen::Quaterniond(1, t, 0.2, -0.3).normalized());
  }
  recording.noise = MtxNoise();
  recording.noise.accel_density = 0.001;
  recording.mounting = Mounting{.q_BS = Eigen::Quaterniond(0.5, 0.5, -0.5, 0.5),
                                .q_sigma = 0.07,
                                .p_BS_B = {0.01, -0.2, 1.0 / 3},
                                .p_sigma = 0.02};
  return recording;
}

Reference MakeReference() {
  Reference reference;
  reference.frames = Reference::Frames::kCluster;
  reference.clock_offset = -0.0123;
  for (int i = 0; i < 10; ++i) {
    reference.time.push_back(0.03 * i);
    reference.q_VB[Segment::kForearm].push_back(
        Eigen::Quaterniond(1, 0.1 * i, 0.2, 0.3).normalized());
    reference.p_V["wrist"].emplace_back(0.1 * i, 0.2, kNaN);
    reference.p_V["forearm"].emplace_back(1, 2, 3);
  }
  reference.q_VB[Segment::kForearm][4] = Eigen::Quaterniond(kNaN, kNaN, kNaN, kNaN);
  return reference;
}

Trial MakeTrial() {
  Trial trial;
  trial.name = "round \"trip\"";
  Observations& observations = trial.observations;
  observations.arm.side = Side::kLeft;
  observations.arm.segments[Segment::kUpperArm] = {{0, -0.301, 0}, 0.004};
  observations.arm.segments[Segment::kForearm] = {{0.01, -0.26, 0.02}, 0.006};
  observations.arm.elbow = {.adduction_constraint = true,
                            .carrying_angle = 0.11,
                            .carrying_angle_sigma = 0.12,
                            .carrying_slope_sigma = 0.05};
  observations.arm.shoulder = {.sigma = 0.02, .correlation_time = 7};
  observations.recordings = {MakeRecording(Segment::kUpperArm, 0.0),
                             MakeRecording(Segment::kForearm, 0.003)};
  observations.recordings[0].mounting.reset();
  observations.recordings[1].mag_S.assign(30, Eigen::Vector3d(0.1, 0.2, 0.3));
  observations.intervals = {{"rest", 0.05, 0.1}, {"task:drinking", 0.1, 0.2}};
  observations.start_pose.emplace();
  observations.start_pose->time = 0.1;
  observations.start_pose->forearm_pronation = 0.4;
  observations.start_pose->sigma = 0.2;
  observations.end_pose = HeldPose{
      .time = 0.2, .elbow_flexion = 0.3, .forearm_pronation = {}, .shoulder_elevation = {}};
  observations.contacts = {
      {.place = "cup", .segment = Segment::kForearm, .times = {0.05, 0.2}, .sigma = 0.02},
      {.place = "desk", .segment = Segment::kUpperArm, .times = {0.1, 0.15}, .height_only = true}};
  trial.reference = MakeReference();
  return trial;
}

template <typename Vector>
void ExpectNear(const std::vector<Vector>& a, const std::vector<Vector>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i], b[i]) << i;
}

void ExpectNear(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
  if (a.coeffs().hasNaN())
    EXPECT_TRUE(b.coeffs().array().isNaN().all());
  else
    EXPECT_LT((a.coeffs() - b.coeffs()).norm(), kTolerance);
}

void ExpectSame(const Recording& a, const Recording& b) {
  EXPECT_EQ(a.segment, b.segment);
  ExpectNear(a.time, b.time);
  ExpectNear(a.gyr_S, b.gyr_S);
  ExpectNear(a.acc_S, b.acc_S);
  ExpectNear(a.mag_S, b.mag_S);
  ASSERT_EQ(a.q_WS.size(), b.q_WS.size());
  for (std::size_t i = 0; i < a.q_WS.size(); ++i) ExpectNear(a.q_WS[i], b.q_WS[i]);
  EXPECT_NEAR(a.noise.gyro_density, b.noise.gyro_density, kTolerance);
  EXPECT_NEAR(a.noise.gyro_bias_sigma, b.noise.gyro_bias_sigma, kTolerance);
  EXPECT_NEAR(a.noise.gyro_bias_walk, b.noise.gyro_bias_walk, kTolerance);
  EXPECT_EQ(a.noise.accel_density, b.noise.accel_density);
  EXPECT_EQ(a.noise.accel_bias_sigma, b.noise.accel_bias_sigma);
  ASSERT_EQ(a.mounting.has_value(), b.mounting.has_value());
  if (!a.mounting) return;
  ExpectNear(a.mounting->q_BS, b.mounting->q_BS);
  EXPECT_NEAR(a.mounting->q_sigma, b.mounting->q_sigma, kTolerance);
  EXPECT_EQ(a.mounting->p_BS_B, b.mounting->p_BS_B);
  EXPECT_EQ(a.mounting->p_sigma, b.mounting->p_sigma);
}

void ExpectSame(const ArmModel& a, const ArmModel& b) {
  EXPECT_EQ(a.side, b.side);
  ASSERT_EQ(a.segments.size(), b.segments.size());
  for (const auto& [segment, geometry] : a.segments) {
    EXPECT_EQ(geometry.p_distal_B, b.segments.at(segment).p_distal_B);
    EXPECT_EQ(geometry.sigma, b.segments.at(segment).sigma);
  }
  EXPECT_EQ(a.elbow.adduction_constraint, b.elbow.adduction_constraint);
  EXPECT_NEAR(a.elbow.carrying_angle, b.elbow.carrying_angle, kTolerance);
  EXPECT_NEAR(a.elbow.carrying_angle_sigma, b.elbow.carrying_angle_sigma, kTolerance);
  EXPECT_NEAR(a.elbow.carrying_slope_sigma, b.elbow.carrying_slope_sigma, kTolerance);
  EXPECT_EQ(a.shoulder.sigma, b.shoulder.sigma);
  EXPECT_EQ(a.shoulder.correlation_time, b.shoulder.correlation_time);
}

void ExpectSame(const Reference& a, const Reference& b) {
  ExpectNear(a.time, b.time);
  EXPECT_EQ(a.frames, b.frames);
  EXPECT_EQ(a.clock_offset, b.clock_offset);
  ASSERT_EQ(a.q_VB.size(), b.q_VB.size());
  for (const auto& [segment, q_VB] : a.q_VB)
    for (std::size_t i = 0; i < q_VB.size(); ++i) ExpectNear(q_VB[i], b.q_VB.at(segment).at(i));
  ASSERT_EQ(a.p_V.size(), b.p_V.size());
  for (const auto& [name, p_V] : a.p_V)
    for (std::size_t i = 0; i < p_V.size(); ++i) {
      EXPECT_EQ(p_V[i].head<2>(), b.p_V.at(name).at(i).head<2>());
      EXPECT_EQ(std::isnan(p_V[i].z()), std::isnan(b.p_V.at(name).at(i).z()));
    }
}

TEST(TrialRoundTrip, GivesTheSameTrial) {
  const TemporaryFolder here;
  const Trial written = MakeTrial();
  WriteTrial(here.File("trial"), written, {}, false);
  const TrialFolder folder = ReadTrial(here.File("trial"));
  const Trial& read = folder.trial;
  EXPECT_EQ(read.name, written.name);
  ExpectSame(written.observations.arm, read.observations.arm);
  ASSERT_EQ(read.observations.recordings.size(), 2u);
  ExpectSame(written.observations.recordings[0], read.observations.recordings[0]);
  ExpectSame(written.observations.recordings[1], read.observations.recordings[1]);
  ASSERT_EQ(read.observations.intervals.size(), 2u);
  EXPECT_EQ(read.observations.intervals[1].label, "task:drinking");
  EXPECT_EQ(read.observations.intervals[1].end, 0.2);
  const HeldPose pose = read.observations.start_pose.value();
  EXPECT_NEAR(*pose.forearm_pronation, 0.4, kTolerance);
  EXPECT_NEAR(pose.sigma, 0.2, kTolerance);
  EXPECT_FALSE(pose.elbow_flexion.has_value());
  EXPECT_NEAR(*read.observations.end_pose.value().elbow_flexion, 0.3, kTolerance);
  EXPECT_EQ(read.observations.end_pose->time, 0.2);
  ASSERT_EQ(read.observations.contacts.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const Contact &a = written.observations.contacts[i], &b = read.observations.contacts[i];
    EXPECT_EQ(a.place, b.place);
    EXPECT_EQ(a.segment, b.segment);
    EXPECT_EQ(a.times, b.times);
    EXPECT_EQ(a.sigma, b.sigma);
    EXPECT_EQ(a.height_only, b.height_only);
  }
  ExpectSame(*written.reference, read.reference.value());
  EXPECT_THAT(folder.defaults, IsEmpty());
  EXPECT_THAT(folder.repairs, IsEmpty());
  EXPECT_THAT(folder.warnings, IsEmpty());
}

TEST(TrialRoundTrip, WritesTheSameBytesAgain) {
  const TemporaryFolder here;
  WriteTrial(here.File("a"), MakeTrial(), {}, false);
  WriteTrial(here.File("b"), MakeTrial(), {}, false);
  for (const char* name : {"trial.json", "upper_arm.csv", "forearm.csv", "reference.csv"})
    EXPECT_EQ(here.Read(std::string("a/") + name), here.Read(std::string("b/") + name)) << name;
}

TEST(TrialRoundTrip, SaysThatATrialIsSimulatedAndKeepsItsTruth) {
  const TemporaryFolder here;
  WriteTrial(here.File("trial"), MakeTrial(), {.simulated = true, .truth_json = "{\"a\": 1}\n"},
             false);
  EXPECT_TRUE(ReadTrial(here.File("trial")).simulated);
  EXPECT_EQ(here.Read("trial/truth.json"), "{\"a\": 1}\n");
}

TEST(TrialRoundTrip, RefusesToOverwriteAnotherTrial) {
  const TemporaryFolder here;
  Trial trial = MakeTrial();
  WriteTrial(here.File("trial"), trial, {}, false);
  trial.name = "another";
  EXPECT_THROW(WriteTrial(here.File("trial"), trial, {}, false), OutputExists);
  EXPECT_EQ(ReadTrial(here.File("trial")).trial.name, "round \"trip\"");
  WriteTrial(here.File("trial"), trial, {}, true);
  EXPECT_EQ(ReadTrial(here.File("trial")).trial.name, "another");
}

}  // namespace
}  // namespace brachium
