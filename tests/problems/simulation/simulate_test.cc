#include "problems/simulation/simulate.h"

#include <gtest/gtest.h>

#include <cmath>

#include "problems/simulation/mirror.h"
#include "problems/simulation/worn_sensor.h"

namespace brachium {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;

constexpr Side kSides[] = {Side::kRight, Side::kLeft};

Scenario Brisk(Side side = Side::kRight, double duration = 20.0) {
  return MakeScenario({.name = "daily_brisk", .seed = 3, .side = side, .duration = duration});
}

SimulationOptions EveryError() {
  SimulationOptions options;
  options.scale_error = 0.003;
  options.misalignment = 0.2 * kDegree;
  options.mounting_error = 5 * kDegree;
  options.start_pose_error = 5 * kDegree;
  options.clock_offset = 0.005;
  options.sampling_jitter = 0.0003;
  options.stamp_error = 0.0002;
  options.lost_share = 0.01;
  options.soft_tissue = TypicalSoftTissue();
  return options;
}

const Recording& Forearm(const SimulatedTrial& simulated) {
  return simulated.trial.observations.recordings.at(1);
}

Vector3d TrueVector(const SimulatedTrial& simulated, const std::string& name) {
  return Vector3d(simulated.True(name).data());
}

double AngleBetween(const Quaterniond& a, const Quaterniond& b) { return a.angularDistance(b); }

void ExpectSameRecording(const Recording& a, const Recording& b) {
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.gyr_S, b.gyr_S);
  EXPECT_EQ(a.acc_S, b.acc_S);
}

TEST(Simulate, GivesOneRecordingPerSegmentOnCellCentres) {
  const SimulatedTrial simulated = Simulate(Brisk(), NoErrors());
  const auto& recordings = simulated.trial.observations.recordings;
  ASSERT_EQ(recordings.size(), 2u);
  EXPECT_EQ(recordings[0].segment, Segment::kUpperArm);
  EXPECT_EQ(recordings[1].segment, Segment::kForearm);
  for (const Recording& recording : recordings) {
    ASSERT_EQ(recording.size(), 2000u);
    EXPECT_NEAR(recording.time.front(), 0.005, 1e-12);
    EXPECT_NEAR(recording.time.back(), 19.995, 1e-9);
    EXPECT_TRUE(recording.mounting.has_value());
    EXPECT_TRUE(recording.mag_S.empty());
  }
}

// A thousand midpoints per cell against the four Gauss points; for the left arm this also proves
// that the mirrored trial is what sensors on a left arm measure.
TEST(Simulate, GivesTheMeanOfTheExactSignalsOverEachCell) {
  for (const Side side : kSides) {
    const Scenario scenario = Brisk(side);
    const SimulatedTrial simulated = Simulate(scenario, NoErrors());
    for (const Recording& recording : simulated.trial.observations.recordings)
      for (std::size_t i = 3; i < recording.size(); i += 97) {
        WornSensor sensor;
        sensor.segment = recording.segment;
        sensor.mounting = *recording.mounting;
        Vector3d gyr = Vector3d::Zero(), acc = Vector3d::Zero();
        for (int j = 0; j < 1000; ++j) {
          const SensorInstant instant =
              At(sensor, scenario, recording.time[i] + 0.01 * ((j + 0.5) / 1000 - 0.5));
          gyr += instant.gyr_S / 1000;
          acc += instant.acc_S / 1000;
        }
        EXPECT_LT((recording.gyr_S[i] - gyr).norm(), 1e-8) << "sample " << i;
        EXPECT_LT((recording.acc_S[i] - acc).norm(), 1e-7) << "sample " << i;
      }
  }
}

TEST(Simulate, TellsTheExactTruthWhenEveryErrorIsOff) {
  const SimulatedTrial simulated = Simulate(Brisk(), NoErrors());
  const Observations& observations = simulated.trial.observations;
  EXPECT_EQ(observations.arm.segments.at(Segment::kUpperArm).p_distal_B.y(), -0.31);
  EXPECT_EQ(observations.arm.segments.at(Segment::kForearm).p_distal_B.y(), -0.26);
  for (const Recording& recording : observations.recordings) {
    const std::string name(Name(recording.segment));
    EXPECT_EQ(recording.mounting->p_BS_B, TrueVector(simulated, name + ".p_BS_m"));
    EXPECT_EQ(recording.mounting->q_BS.w(), simulated.True(name + ".q_BS_wxyz")[0]);
    EXPECT_EQ(TrueVector(simulated, name + ".gyro_bias"), Vector3d::Zero());
    EXPECT_EQ(TrueVector(simulated, name + ".accelerometer_bias"), Vector3d::Zero());
    EXPECT_EQ(simulated.True(name + ".gyro_gain"),
              (std::vector<double>{1, 0, 0, 0, 1, 0, 0, 0, 1}));
  }
  EXPECT_NEAR(*observations.start_pose->elbow_flexion, 10 * kDegree, 1e-15);
  EXPECT_NEAR(*observations.start_pose->forearm_pronation, 90 * kDegree, 1e-15);
  EXPECT_NEAR(*observations.start_pose->shoulder_elevation, 8 * kDegree, 1e-15);
}

TEST(Simulate, MeasuresGravityUpwardAtRest) {
  for (const Side side : kSides) {
    const SimulatedTrial simulated = Simulate(Brisk(side), NoErrors());
    const Recording& forearm = Forearm(simulated);
    const Quaterniond& q_WF = simulated.trial.reference->q_VB.at(Segment::kForearm)[100];
    EXPECT_EQ(forearm.gyr_S[100].norm(), 0.0);
    EXPECT_TRUE((q_WF * (forearm.mounting->q_BS * forearm.acc_S[100]))
                    .isApprox(kGravity * Vector3d::UnitZ(), 1e-12));
  }
}

TEST(Simulate, RefersToTheBonesAtTheFirstRecordingsRate) {
  for (const Side side : kSides) {
    const Scenario scenario = Brisk(side);
    const SimulatedTrial simulated = Simulate(scenario, EveryError());
    const Reference& reference = *simulated.trial.reference;
    EXPECT_EQ(reference.clock_offset, 0.0);
    EXPECT_EQ(reference.frames, Reference::Frames::kSegment);
    for (std::size_t i = 0; i < reference.time.size(); i += 50) {
      const ArmMotion arm = scenario.At(reference.time[i]);
      EXPECT_LT(AngleBetween(reference.q_VB.at(Segment::kUpperArm)[i], arm.upper_arm.turning.q_AB),
                1e-12);
      EXPECT_LT(AngleBetween(reference.q_VB.at(Segment::kForearm)[i], arm.forearm.turning.q_AB),
                1e-12);
      EXPECT_TRUE(reference.p_V.at("shoulder")[i].isApprox(arm.upper_arm.joint_W.p, 1e-12));
      EXPECT_TRUE(reference.p_V.at("elbow")[i].isApprox(arm.forearm.joint_W.p, 1e-12));
      EXPECT_TRUE(reference.p_V.at("wrist")[i].isApprox(arm.wrist_W.p, 1e-12));
    }
  }
}

TEST(Simulate, RefersToRegularTimesThoughSamplesAreLate) {
  const SimulatedTrial simulated = Simulate(Brisk(), EveryError());
  const std::vector<double>& time = simulated.trial.reference->time;
  ASSERT_EQ(time.size(), 2000u);
  EXPECT_LT(simulated.trial.observations.recordings.front().size(), 2000u);
  for (std::size_t i = 0; i < time.size(); ++i)
    EXPECT_NEAR(time[i], (static_cast<double>(i) + 0.5) / 100.0, 1e-9);
}

TEST(Simulate, SaysWhatExactlyKnownSensorsWouldSayOfTheirSegmentsOnBothSides) {
  for (const Side side : kSides)
    for (const double off : {0.0, 5 * kDegree}) {
      SimulationOptions options = NoErrors();
      options.mounting_error = off;
      const SimulatedTrial simulated = Simulate(Brisk(side), options);
      for (const auto& [segment, q_VB] : simulated.trial.reference->q_VB) {
        const auto& by_sensor = simulated.sensors_q_VB.at(segment);
        ASSERT_EQ(by_sensor.size(), q_VB.size());
        for (std::size_t i = 0; i < q_VB.size(); i += 50)
          EXPECT_NEAR(AngleBetween(by_sensor[i], q_VB[i]), off, 1e-7);
      }
    }
}

TEST(Simulate, SaysNothingBySensorsWhoseMountingsAreNotTold) {
  SimulationOptions options = NoErrors();
  options.tell_mountings = false;
  for (const auto& [segment, q_VB] : Simulate(Brisk(), options).sensors_q_VB)
    EXPECT_TRUE(q_VB.empty());
}

TEST(Simulate, GivesTheSameBitsForTheSameSeeds) {
  const SimulatedTrial a = Simulate(Brisk(), EveryError()), b = Simulate(Brisk(), EveryError());
  for (std::size_t i = 0; i < 2; ++i)
    ExpectSameRecording(a.trial.observations.recordings[i], b.trial.observations.recordings[i]);
  ASSERT_EQ(a.truth.size(), b.truth.size());
  for (std::size_t i = 0; i < a.truth.size(); ++i) EXPECT_EQ(a.truth[i].value, b.truth[i].value);
}

TEST(Simulate, GivesOtherErrorsForAnotherSeedOnTheSameMovement) {
  SimulationOptions options, other;
  other.seed = 2;
  const SimulatedTrial a = Simulate(Brisk(), options), b = Simulate(Brisk(), other);
  EXPECT_NE(a.True("forearm.gyro_bias"), b.True("forearm.gyro_bias"));
  EXPECT_NE(Forearm(a).gyr_S, Forearm(b).gyr_S);
  EXPECT_EQ(a.trial.reference->p_V.at("wrist"), b.trial.reference->p_V.at("wrist"));
}

TEST(Simulate, OfALeftArmIsTheMirrorImageOfTheRight) {
  const SimulatedTrial right = Simulate(Brisk(), EveryError());
  const SimulatedTrial left = Simulate(Brisk(Side::kLeft), EveryError());
  EXPECT_EQ(left.trial.observations.arm.side, Side::kLeft);
  for (std::size_t r = 0; r < 2; ++r) {
    const Recording& a = right.trial.observations.recordings[r];
    const Recording& b = left.trial.observations.recordings[r];
    ASSERT_EQ(a.time, b.time);
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_EQ(b.gyr_S[i], Vector3d(-a.gyr_S[i].x(), -a.gyr_S[i].y(), a.gyr_S[i].z()));
      EXPECT_EQ(b.acc_S[i], Vector3d(a.acc_S[i].x(), a.acc_S[i].y(), -a.acc_S[i].z()));
    }
    const Quaterniond &q = a.mounting->q_BS, &p = b.mounting->q_BS;
    EXPECT_EQ(p.coeffs(), Quaterniond(q.w(), -q.x(), -q.y(), q.z()).coeffs());
    EXPECT_EQ(b.mounting->p_BS_B.z(), -a.mounting->p_BS_B.z());
  }
  const Vector3d bias = TrueVector(right, "forearm.gyro_bias");
  EXPECT_EQ(TrueVector(left, "forearm.gyro_bias"), Vector3d(-bias.x(), -bias.y(), bias.z()));
}

TEST(Simulate, MirroredTwiceIsUnchanged) {
  const Trial trial = Simulate(Brisk(), EveryError()).trial;
  const Trial twice = Mirrored(Mirrored(trial));
  EXPECT_EQ(twice.observations.arm.side, Side::kRight);
  for (std::size_t i = 0; i < 2; ++i)
    ExpectSameRecording(trial.observations.recordings[i], twice.observations.recordings[i]);
  const auto& before = trial.reference->q_VB.at(Segment::kForearm);
  const auto& after = twice.reference->q_VB.at(Segment::kForearm);
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(before[i].coeffs(), after[i].coeffs());
}

TEST(Simulate, DrawsEachErrorFromItsOwnStream) {
  SimulationOptions with, without;
  without.accel_bias = without.lever_arm_error = 0.0;
  without.soft_tissue = TypicalSoftTissue();
  const SimulatedTrial a = Simulate(Brisk(), with), b = Simulate(Brisk(), without);
  EXPECT_EQ(a.True("forearm.gyro_bias"), b.True("forearm.gyro_bias"));
  EXPECT_EQ(a.True("forearm.p_BS_m"), b.True("forearm.p_BS_m"));
  EXPECT_EQ(Forearm(a).gyr_S[100], Forearm(b).gyr_S[100]);  // at rest: the same noise and bias
  EXPECT_NE(Forearm(a).gyr_S[1000], Forearm(b).gyr_S[1000]);
}

}  // namespace
}  // namespace brachium
