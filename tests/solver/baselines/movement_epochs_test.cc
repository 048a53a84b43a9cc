#include "solver/baselines/movement_epochs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/simulated_trial.h"

namespace brachium {
namespace {

using Eigen::Vector3d;
using testing::ElementsAre, testing::IsEmpty, testing::Pair;

constexpr EpochThresholds kThresholds{.sure = 10.0, .may = 1.0, .crossings = 3.0};

std::vector<Frame> Frames(const std::vector<double>& energies, int crossings = 0) {
  std::vector<Frame> frames;
  for (const double energy : energies) {
    const double t = 0.04 * static_cast<double>(frames.size());
    frames.push_back({t, t + 0.04, energy, crossings});
  }
  return frames;
}

Recording Rates(const std::vector<Vector3d>& rates) {
  Recording recording;
  for (const Vector3d& rate : rates) {
    recording.time.push_back(0.01 * static_cast<double>(recording.time.size()));
    recording.gyr_S.push_back(rate);
    recording.acc_S.push_back(Vector3d::Zero());
  }
  return recording;
}

TEST(Frames, HoldTheEnergyAndTheCrossingsOfFourSamplesPerAxisLessTheBias) {
  const Vector3d bias(1.0, 2.0, 3.0);
  std::vector<Vector3d> rates;
  for (int i = 0; i < 10; ++i)
    rates.push_back(bias + Vector3d(i % 2 == 0 ? 0.1 : -0.1, 0.2, i < 6 ? 0.3 : -0.3));
  const auto frames = FramesOf(Rates(rates), bias);
  ASSERT_EQ(frames.size(), 2u);
  for (const Frame& frame : frames) EXPECT_NEAR(frame.energy, 4 * (0.01 + 0.04 + 0.09), 1e-12);
  EXPECT_EQ(frames[0].crossings, 3);      // x, and none before the first sample
  EXPECT_EQ(frames[1].crossings, 4 + 1);  // x at every sample, z once
  EXPECT_NEAR(frames[0].start, -0.005, 1e-12);
  EXPECT_NEAR(frames[0].end, 0.035, 1e-12);
}

TEST(Frames, OfANormThatNeverCrossesZeroWouldHaveNoCrossings) {
  std::vector<Vector3d> norms;
  for (int i = 0; i < 8; ++i) norms.push_back(Vector3d(0.1 + 0.05 * (i % 2), 0.0, 0.0));
  for (const Frame& frame : FramesOf(Rates(norms), Vector3d::Zero())) EXPECT_EQ(frame.crossings, 0);
  for (const Frame& frame : FramesOf(Rates(norms), Vector3d(0.125, 0.0, 0.0)))
    EXPECT_GE(frame.crossings, 3);
}

TEST(Epochs, ReachFromTheHighThresholdDownToTheLowOne) {
  const auto frames = Frames({0, 0, 2, 5, 20, 30, 4, 2, 0, 0});
  EXPECT_THAT(FindEpochs(frames, kThresholds), ElementsAre(Pair(2u, 7u)));
}

TEST(Epochs, DoNotAriseFromTheLowThresholdAlone) {
  EXPECT_THAT(FindEpochs(Frames({0, 2, 5, 9, 5, 2, 0}), kThresholds), IsEmpty());
}

TEST(Epochs, BridgeOneQuietFrameAndEndAtTwo) {
  EXPECT_THAT(FindEpochs(Frames({0, 20, 0, 20, 20, 0, 0, 20, 0}), kThresholds),
              ElementsAre(Pair(1u, 4u), Pair(7u, 7u)));
}

TEST(Epochs, DoNotBeginOrEndAtALoneFrameOfTheLowThreshold) {
  EXPECT_THAT(FindEpochs(Frames({2, 0, 20, 20, 0, 2, 0}), kThresholds), ElementsAre(Pair(2u, 3u)));
  EXPECT_THAT(FindEpochs(Frames({2, 2, 0, 20, 20, 0, 2, 2}), kThresholds),
              ElementsAre(Pair(0u, 7u)));
}

TEST(Epochs, LeaveOutFramesOfLowEnergyThatCrossZeroOften) {
  auto frames = Frames({0, 0, 20, 20, 5, 5, 0, 0});
  frames[4].crossings = frames[5].crossings = 6;
  EXPECT_THAT(FindEpochs(frames, kThresholds), ElementsAre(Pair(2u, 3u)));
  frames[3].crossings = 12;  // energy is high: sure nevertheless
  EXPECT_THAT(FindEpochs(frames, kThresholds), ElementsAre(Pair(2u, 3u)));
}

TEST(Epochs, MayCoverTheWholeRecordingOrNothingOfIt) {
  EXPECT_THAT(FindEpochs(Frames({20, 20, 20}), kThresholds), ElementsAre(Pair(0u, 2u)));
  EXPECT_THAT(FindEpochs(Frames({0, 0, 0}), kThresholds), IsEmpty());
  EXPECT_THAT(FindEpochs({}, kThresholds), IsEmpty());
}

TEST(Epochs, OfASimulatedArmLieBetweenItsRests) {
  const Trial trial =
      Simulate(MakeScenario({.name = "reach", .seed = 1, .duration = 20}), {}).trial;
  const Tracks tracks = StartTracks(trial.observations);
  const auto epochs = DetectEpochs(tracks, tracks.segments[1], {});
  ASSERT_FALSE(epochs.empty());
  EXPECT_NEAR(epochs.front().start, kRestAtStart, 0.3);
  EXPECT_LT(epochs.back().end, 20 - kRestAtEnd + 0.1);
  for (const Epoch& epoch : epochs) EXPECT_EQ(epoch.segment, Segment::kForearm);
}

TEST(Epochs, TakeTheThresholdsThatAreTold) {
  const auto frames = Frames({0.1, 0.1, 0.1});
  const std::vector<Interval> rests{{"rest", 0.0, 0.4}, {"rest", 0.5, 1.0}};
  const auto told = ThresholdsFor(frames, {}, 0.01, rests, {7.0, 3.0, 5.0});
  EXPECT_EQ(told.sure, 7.0);
  EXPECT_EQ(told.may, 3.0);
  EXPECT_EQ(told.crossings, 5.0);
  const auto found = ThresholdsFor(frames, {}, 0.01, rests, {});
  EXPECT_NEAR(found.sure, 10.0, 1e-9);
  EXPECT_NEAR(found.may, 1.0, 1e-9);
}

TEST(Epochs, RefuseALowThresholdAboveTheHighOne) {
  std::string why;
  EXPECT_FALSE((EpochOptions{.bai_energy_high = 1.0, .bai_energy_low = 2.0}.IsValid(&why)));
  EXPECT_TRUE(EpochOptions{}.IsValid(&why));
}

}  // namespace
}  // namespace brachium
