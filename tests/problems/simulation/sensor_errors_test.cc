#include "problems/simulation/sensor_errors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "problems/simulation/simulate.h"
#include "tests/support/scenarios.h"

namespace brachium {
namespace {

using Eigen::Vector3d;

Scenario Brisk(double duration = 20.0) {
  return MakeScenario({.name = "daily_brisk", .seed = 3, .duration = duration});
}

const Recording& Forearm(const SimulatedTrial& simulated) {
  return simulated.trial.observations.recordings.at(1);
}

Vector3d TrueVector(const SimulatedTrial& simulated, const std::string& name) {
  return Vector3d(simulated.True(name).data());
}

double Rms(const Vector3d& v) { return std::sqrt(v.squaredNorm() / 3.0); }

// Mean square per axis of a difference of samples.
double MeanSquare(const std::vector<Vector3d>& a, const std::vector<Vector3d>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]).squaredNorm();
  return sum / (3.0 * static_cast<double>(a.size()));
}

TEST(Noise, HasTheVarianceOfItsOneSidedDensityAtEveryRate) {
  for (const double rate : {50.0, 200.0}) {
    SimulationOptions options = NoErrors();
    options.rate = rate;
    const SimulatedTrial exact = Simulate(Brisk(100.0), options);
    options.noise = MtxNoise();
    options.noise->gyro_bias_walk = 0.0;
    const SimulatedTrial noisy = Simulate(Brisk(100.0), options);
    const double gyro = MeanSquare(Forearm(noisy).gyr_S, Forearm(exact).gyr_S);
    const double accel = MeanSquare(Forearm(noisy).acc_S, Forearm(exact).acc_S);
    EXPECT_NEAR(gyro, std::pow(0.075 * kDegree, 2) * rate / 2, 0.03 * gyro);
    EXPECT_NEAR(accel, std::pow(0.0025, 2) * rate / 2, 0.03 * accel);
  }
}

TEST(GyroBias, WalksAsFastAsItsDensitySays) {
  SimulationOptions options = NoErrors();
  options.noise = ImuNoise{.gyro_density = 0.0, .gyro_bias_walk = 1e-3, .accel_density = 0.0};
  double squares = 0.0;
  constexpr int kSeeds = 60;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    options.seed = static_cast<std::uint64_t>(seed);
    options.rate = 20.0;
    const SimulatedTrial simulated = Simulate(Brisk(), options);
    for (const std::string& name : {std::string("upper_arm"), std::string("forearm")})
      squares += TrueVector(simulated, name + ".gyro_bias_end").squaredNorm();
  }
  EXPECT_NEAR(std::sqrt(squares / (6 * kSeeds)), 1e-3 * std::sqrt(20.0), 0.4e-3);
}

TEST(Bias, IsAddedToEverySampleAndHasTheSizeAskedFor) {
  SimulationOptions options = NoErrors();
  const SimulatedTrial exact = Simulate(Brisk(), options);
  options.gyro_bias = 0.3 * kDegree;
  options.accel_bias = 0.04;
  const SimulatedTrial biased = Simulate(Brisk(), options);
  const Vector3d gyro = TrueVector(biased, "forearm.gyro_bias");
  const Vector3d accel = TrueVector(biased, "forearm.accelerometer_bias");
  EXPECT_NEAR(Rms(gyro), 0.3 * kDegree, 1e-12);
  EXPECT_NEAR(Rms(accel), 0.04, 1e-12);
  EXPECT_EQ(TrueVector(biased, "forearm.gyro_bias_end"), gyro);
  for (std::size_t i = 0; i < Forearm(exact).size(); ++i) {
    EXPECT_LT((Forearm(biased).gyr_S[i] - Forearm(exact).gyr_S[i] - gyro).norm(), 1e-14);
    EXPECT_LT((Forearm(biased).acc_S[i] - Forearm(exact).acc_S[i] - accel).norm(), 1e-13);
  }
}

TEST(Gain, ScalesAndMixesTheAxes) {
  SimulationOptions options = NoErrors();
  const SimulatedTrial exact = Simulate(Brisk(), options);
  options.scale_error = 0.003;
  options.misalignment = 0.2 * kDegree;
  const SimulatedTrial bent = Simulate(Brisk(), options);
  using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  const RowMajor gain(bent.True("forearm.gyro_gain").data());
  EXPECT_FALSE(gain.isIdentity(1e-4));
  EXPECT_TRUE(gain.isIdentity(0.02));
  for (std::size_t i = 0; i < Forearm(exact).size(); i += 10)
    EXPECT_LT((Forearm(bent).gyr_S[i] - gain * Forearm(exact).gyr_S[i]).norm(), 1e-13);
}

TEST(ToldGeometry, IsWrongByExactlyTheSizesAskedFor) {
  SimulationOptions options = NoErrors();
  options.lever_arm_error = 0.005;
  options.mounting_error = 4 * kDegree;
  options.length_error = 0.003;
  const SimulatedTrial simulated = Simulate(Brisk(), options);
  const Observations& observations = simulated.trial.observations;
  for (const Recording& recording : observations.recordings) {
    const std::string name(Name(recording.segment));
    EXPECT_NEAR((recording.mounting->p_BS_B - TrueVector(simulated, name + ".p_BS_m")).norm(),
                0.005, 1e-12);
    const std::vector<double>& q = simulated.True(name + ".q_BS_wxyz");
    EXPECT_NEAR(
        recording.mounting->q_BS.angularDistance(Eigen::Quaterniond(q[0], q[1], q[2], q[3])),
        4 * kDegree, 1e-9);
    const double told = -observations.arm.segments.at(recording.segment).p_distal_B.y();
    EXPECT_NEAR(std::abs(told - simulated.True(name + ".length_m")[0]), 0.003, 1e-12);
  }
}

TEST(ToldGeometry, LeavesTheSignalsAlone) {
  SimulationOptions options = NoErrors();
  const SimulatedTrial exact = Simulate(Brisk(), options);
  options.lever_arm_error = 0.02;
  options.mounting_error = 10 * kDegree;
  options.length_error = 0.01;
  EXPECT_EQ(Forearm(Simulate(Brisk(), options)).acc_S, Forearm(exact).acc_S);
}

TEST(ClockOffset, ShiftsTheToldTimesOfAllSensorsButTheFirst) {
  SimulationOptions options = NoErrors();
  const SimulatedTrial exact = Simulate(Brisk(), options);
  options.clock_offset = 0.007;
  const SimulatedTrial shifted = Simulate(Brisk(), options);
  const double offset = shifted.True("forearm.clock_offset_s")[0];
  EXPECT_EQ(std::abs(offset), 0.007);
  EXPECT_EQ(shifted.True("upper_arm.clock_offset_s")[0], 0.0);
  EXPECT_EQ(Forearm(shifted).gyr_S, Forearm(exact).gyr_S);
  for (std::size_t i = 0; i < Forearm(exact).size(); ++i)
    EXPECT_NEAR(Forearm(shifted).time[i] + offset, Forearm(exact).time[i], 1e-12);
}

TEST(SamplingJitter, MovesTheSamplesAndTellsSo) {
  SimulationOptions options = NoErrors();
  const SimulatedTrial exact = Simulate(Brisk(), options);
  options.sampling_jitter = 0.001;
  const Recording jittered = Forearm(Simulate(Brisk(), options));
  double squares = 0.0;
  for (std::size_t i = 0; i < jittered.size(); ++i)
    squares += std::pow(jittered.time[i] - Forearm(exact).time[i], 2);
  const double rms = std::sqrt(squares / static_cast<double>(jittered.size()));
  EXPECT_NEAR(rms, 0.001 / std::sqrt(2.0), 5e-5);  // a centre is the mean of two edges
  EXPECT_NE(jittered.gyr_S, Forearm(exact).gyr_S);
  EXPECT_TRUE(std::is_sorted(jittered.time.begin(), jittered.time.end()));
}

TEST(StampError, ChangesOnlyTheToldTimes) {
  SimulationOptions options = NoErrors();
  const SimulatedTrial exact = Simulate(Brisk(), options);
  options.stamp_error = 0.001;
  const Recording stamped = Forearm(Simulate(Brisk(), options));
  EXPECT_EQ(stamped.gyr_S, Forearm(exact).gyr_S);
  EXPECT_NE(stamped.time, Forearm(exact).time);
  EXPECT_TRUE(std::is_sorted(stamped.time.begin(), stamped.time.end()));
}

TEST(LostSamples, AreAbsentAndCounted) {
  SimulationOptions options = NoErrors();
  options.lost_share = 0.05;
  const SimulatedTrial simulated = Simulate(Brisk(100.0), options);
  const double lost = simulated.True("forearm.lost_samples")[0];
  EXPECT_NEAR(lost, 500.0, 70.0);
  EXPECT_EQ(Forearm(simulated).size(), 10000u - static_cast<std::size_t>(lost));
  EXPECT_NEAR(Forearm(simulated).time.front(), 0.005, 1e-12);
  EXPECT_NEAR(Forearm(simulated).time.back(), 99.995, 1e-9);
}

TEST(SoftTissueError, IsFeltByBothSensorsAndReportedButLeavesTheReferenceAlone) {
  SimulationOptions options = NoErrors();
  const SimulatedTrial firm = Simulate(Brisk(60.0), options);
  options.soft_tissue = TypicalSoftTissue();
  const SimulatedTrial soft = Simulate(Brisk(60.0), options);
  EXPECT_GT(std::sqrt(MeanSquare(Forearm(soft).gyr_S, Forearm(firm).gyr_S)), 5 * kDegree);
  EXPECT_GT(std::sqrt(MeanSquare(Forearm(soft).acc_S, Forearm(firm).acc_S)), 0.1);
  EXPECT_EQ(soft.trial.reference->p_V.at("wrist"), firm.trial.reference->p_V.at("wrist"));
  const Vector3d rms = TrueVector(soft, "upper_arm.soft_tissue_rms_deg");
  EXPECT_NEAR(rms.y(), 3.0, 0.5);
  EXPECT_NEAR(rms.x(), 1.2, 0.25);
  EXPECT_EQ(TrueVector(firm, "upper_arm.soft_tissue_rms_deg"), Vector3d::Zero());
}

TEST(Telling, KeepsTheCarryingAngleToItselfUnlessAsked) {
  SimulationOptions options;
  EXPECT_EQ(Simulate(Brisk(), options).trial.observations.arm.elbow.carrying_angle,
            ElbowModel().carrying_angle);
  options.tell_carrying_angle = true;
  EXPECT_EQ(Simulate(Brisk(), options).trial.observations.arm.elbow.carrying_angle, 8 * kDegree);
}

TEST(Telling, TellsRestsAndStartPoseAsAsked) {
  SimulationOptions options;
  options.tell_start_pose = false;
  options.tell_rests = true;
  const Observations observations = Simulate(Brisk(), options).trial.observations;
  EXPECT_FALSE(observations.start_pose.has_value());
  ASSERT_EQ(observations.intervals.size(), 2u);
  EXPECT_EQ(observations.intervals[0].label, "rest");
  EXPECT_LT(observations.intervals[0].end, kRestAtStart);
  EXPECT_GT(observations.intervals[1].start, 20.0 - kRestAtEnd);
  EXPECT_TRUE(Simulate(Brisk(), {}).trial.observations.intervals.empty());
}

TEST(Telling, TellsTheEndPoseWithErrorsOfItsOwn) {
  SimulationOptions options;
  options.start_pose_error = 5 * kDegree;
  EXPECT_FALSE(Simulate(Brisk(), options).trial.observations.end_pose.has_value());
  options.tell_end_pose = options.draw_sizes = true;
  const Observations observations = Simulate(Brisk(), options).trial.observations;
  EXPECT_GT(observations.end_pose->time, 20.0 - kRestAtEnd);
  EXPECT_EQ(observations.end_pose->sigma, 5 * kDegree);
  EXPECT_NE(observations.end_pose->elbow_flexion, observations.start_pose->elbow_flexion);
}

TEST(Telling, TellsTheAnglesThatTheArmHasAtBothEnds) {
  for (const Side side : {Side::kRight, Side::kLeft}) {
    SimulationOptions options;
    options.tell_end_pose = true;
    const Scenario scenario =
        MakeScenario({.name = "daily_brisk", .seed = 3, .side = side, .duration = 20.0});
    const Observations observations = Simulate(scenario, options).trial.observations;
    for (const HeldPose& pose : {*observations.start_pose, *observations.end_pose}) {
      EXPECT_NEAR(Elbow(scenario, pose.time).flexion, *pose.elbow_flexion, 1e-9);
      EXPECT_NEAR(Elbow(scenario, pose.time).pronation, *pose.forearm_pronation, 1e-9);
    }
  }
}

TEST(Telling, TellsContactsOfWornSegmentsWhereAsked) {
  const Scenario scenario = MakeUsual("nine_hole_peg_test");
  SimulationOptions options;
  EXPECT_TRUE(Simulate(scenario, options).trial.observations.contacts.empty());
  options.tell_contacts = true;
  const Observations observations = Simulate(scenario, options).trial.observations;
  ASSERT_EQ(observations.contacts.size(), 2u);
  EXPECT_EQ(observations.contacts[0].times.size(), 9u);
  EXPECT_EQ(observations.contacts[1].times.size(), 18u);
  options.worn = {Segment::kUpperArm, Segment::kForearm};
  EXPECT_TRUE(Simulate(scenario, options).trial.observations.contacts.empty());
}

TEST(SimulationOptions, SayWhatIsWrong) {
  std::string why;
  EXPECT_TRUE(SimulationOptions().IsValid(&why)) << why;
  EXPECT_TRUE(NoErrors().IsValid(&why)) << why;
  SimulationOptions options;
  options.accel_bias = -0.1;
  EXPECT_FALSE(options.IsValid(&why));
  EXPECT_EQ(why, "simulation.accel_bias must be >= 0");
  options = {};
  options.rate = 0.0;
  EXPECT_FALSE(options.IsValid(&why));
  EXPECT_EQ(why, "simulation.rate must be > 0 Hz");
  options = {};
  options.lost_share = 0.7;
  EXPECT_FALSE(options.IsValid(&why));
  options = {};
  options.sampling_jitter = 0.002;
  EXPECT_FALSE(options.IsValid(&why));
}

}  // namespace
}  // namespace brachium
