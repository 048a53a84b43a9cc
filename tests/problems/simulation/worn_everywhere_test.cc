#include <gtest/gtest.h>

#include <cmath>

#include "problems/rotation.h"
#include "problems/simulation/mirror.h"
#include "problems/simulation/simulate.h"
#include "tests/support/scenarios.h"

namespace brachium {
namespace {

using Eigen::Vector3d;

constexpr Segment kFour[] = {Segment::kGirdle, Segment::kUpperArm, Segment::kForearm,
                             Segment::kHand};

SimulatedTrial Pegs(Side side, const SimulationOptions& options = NoErrors()) {
  return Simulate(MakeUsual("nine_hole_peg_test", side), options);
}

TEST(FourSensors, AreWornFromGirdleToHandInThePegTest) {
  const SimulatedTrial simulated = Pegs(Side::kRight);
  const auto& recordings = simulated.trial.observations.recordings;
  ASSERT_EQ(recordings.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(recordings[i].segment, kFour[i]);
    EXPECT_TRUE(recordings[i].mounting.has_value());
    EXPECT_EQ(simulated.trial.reference->q_VB.count(kFour[i]), 1u);
  }
  EXPECT_EQ(simulated.trial.reference->p_V.count("hand"), 1u);
}

// The chain that is told, on the attitudes of the reference, leads to the reference's joints.
TEST(FourSensors, AreOnAChainThatTheReferenceKeeps) {
  for (const Side side : {Side::kRight, Side::kLeft}) {
    const Trial trial = Pegs(side).trial;
    const Reference& reference = *trial.reference;
    const auto& segments = trial.observations.arm.segments;
    const char* const joints[] = {"shoulder", "elbow", "wrist", "hand"};
    for (std::size_t i = 0; i < reference.time.size(); i += 50)
      for (std::size_t s = 1; s < 4; ++s) {
        const Vector3d link = reference.p_V.at(joints[s])[i] - reference.p_V.at(joints[s - 1])[i];
        const Vector3d told = reference.q_VB.at(kFour[s])[i] * segments.at(kFour[s]).p_distal_B;
        EXPECT_LT((link - told).norm(), 1e-12);
      }
  }
}

TEST(FourSensors, OfALeftArmAreTheMirrorImageOfTheRight) {
  const SimulatedTrial right = Pegs(Side::kRight, HonestErrors(MtxNoise()));
  const SimulatedTrial left = Pegs(Side::kLeft, HonestErrors(MtxNoise()));
  for (std::size_t r = 0; r < 4; ++r) {
    const Recording& a = right.trial.observations.recordings[r];
    const Recording& b = left.trial.observations.recordings[r];
    ASSERT_EQ(a.time, b.time);
    for (std::size_t i = 0; i < a.size(); i += 7) {
      EXPECT_EQ(b.gyr_S[i], MirroredAxial(a.gyr_S[i]));
      EXPECT_EQ(b.acc_S[i], MirroredPolar(a.acc_S[i]));
    }
  }
  const std::vector<double>& hole = right.True("peg_5.position_m");
  EXPECT_EQ(left.True("peg_5.position_m"), (std::vector<double>{hole[0], -hole[1], hole[2]}));
  EXPECT_EQ(left.True("girdle.distal_joint_m")[2], -right.True("girdle.distal_joint_m")[2]);
  EXPECT_EQ(left.True("trunk.heading_deg")[0], -right.True("trunk.heading_deg")[0]);
}

TEST(FourSensors, MayBeWornInAnyScenarioAndTwoInThePegTest) {
  SimulationOptions options = NoErrors();
  options.worn = {std::begin(kFour), std::end(kFour)};
  const Scenario brisk = MakeScenario({.name = "daily_brisk", .duration = 20});
  EXPECT_EQ(Simulate(brisk, options).trial.observations.recordings.size(), 4u);
  options.worn = {Segment::kUpperArm, Segment::kForearm};
  const Trial two = Pegs(Side::kRight, options).trial;
  EXPECT_EQ(two.observations.recordings.size(), 2u);
  EXPECT_EQ(two.reference->p_V.count("hand"), 0u);
}

TEST(OwnRate, GivesEachSensorSamplesAtItsRateAndAClockOfItsOwn) {
  SimulationOptions options = NoErrors();
  options.worn = {std::begin(kFour), std::end(kFour)};
  options.rate = 120.0;
  options.own_rate = {
      {Segment::kUpperArm, 100.0}, {Segment::kForearm, 60.0}, {Segment::kHand, 25.0}};
  options.clock_offset = 0.006;
  options.draw_sizes = true;
  const Scenario scenario = MakeScenario({.name = "daily_brisk", .duration = 20});
  const SimulatedTrial simulated = Simulate(scenario, options);
  const double rates[] = {120, 100, 60, 25};
  std::vector<double> offsets;
  for (std::size_t i = 0; i < 4; ++i) {
    const Recording& recording = simulated.trial.observations.recordings[i];
    const std::string name(Name(kFour[i]));
    EXPECT_EQ(recording.size(), static_cast<std::size_t>(20 * rates[i]));
    EXPECT_NEAR(SamplingPeriod(recording), 1.0 / rates[i], 1e-9);
    EXPECT_EQ(simulated.True(name + ".rate_hz")[0], rates[i]);
    offsets.push_back(simulated.True(name + ".clock_offset_s")[0]);
    EXPECT_NEAR(recording.time.front() + offsets.back(), 0.5 / rates[i], 1e-12);
  }
  EXPECT_EQ(offsets[0], 0.0);
  EXPECT_NE(offsets[1], offsets[2]);
  EXPECT_NE(offsets[2], offsets[3]);
}

TEST(ReferenceNoise, IsThatOfMarkersOnTheJointsAndOnClusters) {
  SimulationOptions options = NoErrors();
  const Scenario scenario = MakeScenario({.name = "daily_brisk", .duration = 30});
  const Reference exact = *Simulate(scenario, options).trial.reference;
  options.reference_noise = 0.001;
  const Trial noisy = Simulate(scenario, options).trial;
  double place = 0.0, turn = 0.0;
  const auto n = static_cast<double>(exact.time.size());
  for (std::size_t i = 0; i < exact.time.size(); ++i) {
    place += (noisy.reference->p_V.at("wrist")[i] - exact.p_V.at("wrist")[i]).squaredNorm();
    turn += Log<double>(exact.q_VB.at(Segment::kForearm)[i].conjugate() *
                        noisy.reference->q_VB.at(Segment::kForearm)[i])
                .squaredNorm();
  }
  EXPECT_NEAR(std::sqrt(place / n / 3), 0.001, 3e-5);
  EXPECT_NEAR(std::sqrt(turn / n / 3) / kDegree, 0.81, 0.03);  // below 1 deg, as Luinge found
  EXPECT_EQ(noisy.observations.recordings[1].gyr_S,
            Simulate(scenario, NoErrors()).trial.observations.recordings[1].gyr_S);
}

TEST(SoftTissue, MayBeSofterAboutTheUpperArm) {
  SimulationOptions options = NoErrors();
  options.soft_tissue = HonestErrors(MtwNoise()).soft_tissue;
  const SimulatedTrial simulated =
      Simulate(MakeScenario({.name = "daily_brisk", .duration = 120}), options);
  EXPECT_NEAR(simulated.True("upper_arm.soft_tissue_rms_deg")[1], 8.0, 1.0);
  EXPECT_NEAR(simulated.True("forearm.soft_tissue_rms_deg")[1], 2.0, 0.3);
  EXPECT_NEAR(simulated.True("upper_arm.soft_tissue_rms_deg")[0], 2.0, 0.5);
}

TEST(Truth, HoldsWhenEachMovementBeginsAndEnds) {
  const SimulatedTrial simulated = Pegs(Side::kRight);
  const auto& start = simulated.True("movements.start_s");
  const auto& end = simulated.True("movements.end_s");
  ASSERT_EQ(start.size(), end.size());
  ASSERT_EQ(start.size(), 2u + 9u * 4u);
  const Scenario scenario = MakeUsual("nine_hole_peg_test");
  for (std::size_t i = 1; i + 1 < start.size(); ++i) {
    EXPECT_LT(start[i], end[i]);
    EXPECT_GT(scenario.At(0.5 * (start[i] + end[i])).fingertip_W.v.norm(), 0.02);
  }
}

}  // namespace
}  // namespace brachium
