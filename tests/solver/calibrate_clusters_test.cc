#include "solver/calibrate_clusters.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "problems/rotation.h"
#include "tests/support/residual_values.h"
#include "tests/support/simulated_trial.h"

namespace brachium {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;
using testing::Contains, testing::HasSubstr, testing::IsEmpty, testing::SizeIs;

const std::map<Segment, Quaterniond> kTurn_BC = {
    {Segment::kUpperArm, Exp<double>(Vector3d(0.4, -0.9, 0.2))},
    {Segment::kForearm, Exp<double>(Vector3d(-0.3, 1.7, 0.5))}};

// A calibration whose reference knows clusters only, each turned on its segment.
Trial WithClusters(Side side, double noise = 0.0) {
  Trial trial = Simulate(MakeScenario({.name = "calibration", .side = side}), {}).trial;
  Reference& reference = *trial.reference;
  reference.frames = Reference::Frames::kCluster;
  std::mt19937 random(1);
  for (auto& [segment, q_VB] : reference.q_VB)
    for (Quaterniond& q : q_VB)
      q = q * kTurn_BC.at(segment) * Exp<double>(RandomVector(3, random, noise));
  return trial;
}

Calibration Calibrated(const Trial& trial) {
  return CalibrateClusters(*trial.reference, trial.observations, {});
}

void ExpectTurns(const Calibration& calibration, double tolerance) {
  EXPECT_THAT(calibration.faults, IsEmpty());
  ASSERT_THAT(calibration.segments, SizeIs(2));
  for (const SegmentCalibration& segment : calibration.segments)
    EXPECT_LT(segment.mounting.q_BS.angularDistance(kTurn_BC.at(segment.segment)), tolerance)
        << Name(segment.segment);
}

TEST(CalibrateClusters, FindsHowTheySitOnEitherArmWithinADegree) {
  for (const Side side : {Side::kRight, Side::kLeft})
    ExpectTurns(Calibrated(WithClusters(side)), 1 * kDegree);
}

TEST(CalibrateClusters, BearsTheNoiseOfMarkers) {
  ExpectTurns(Calibrated(WithClusters(Side::kLeft, 0.2 * kDegree)), 1.5 * kDegree);
}

TEST(CalibrateClusters, ReadsTheReferencesClock) {
  Trial trial = WithClusters(Side::kRight);
  trial.reference->clock_offset = 40.0;
  for (double& t : trial.reference->time) t += 40.0;
  ExpectTurns(Calibrated(trial), 1 * kDegree);
}

TEST(CalibrateClusters, LeavesGapsOut) {
  Trial trial = WithClusters(Side::kRight);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (auto& [segment, q_VC] : trial.reference->q_VB)
    for (std::size_t i = 0; i < q_VC.size(); i += 97) q_VC[i] = Quaterniond(nan, nan, nan, nan);
  const auto recording = ClusterRecording(*trial.reference, Segment::kForearm);
  ASSERT_TRUE(recording);
  for (const Vector3d& gyr : recording->gyr_S) ASSERT_TRUE(gyr.allFinite());
  ExpectTurns(Calibrated(trial), 1 * kDegree);
}

TEST(CalibrateClusters, NeedsMoreThanASampleOrTwo) {
  Trial trial = WithClusters(Side::kRight);
  trial.reference->time.resize(2);
  EXPECT_FALSE(ClusterRecording(*trial.reference, Segment::kForearm));
}

TEST(CalibrateClusters, NotesASegmentThatNoMovementIsLabelledFor) {
  Trial trial = WithClusters(Side::kRight);
  std::erase_if(trial.observations.intervals, [](const Interval& interval) {
    return interval.label.find("forearm") != std::string::npos;
  });
  const Calibration calibration = Calibrated(trial);
  EXPECT_THAT(calibration.segments, SizeIs(1));
  EXPECT_THAT(calibration.notes, Contains(HasSubstr("forearm: no movement is labelled")));
}

TEST(CalibrateClusters, RefusesWhatItRefusesOfSensors) {
  Trial trial = WithClusters(Side::kRight);
  trial.observations.arm.side = Side::kLeft;
  EXPECT_THAT(Calibrated(trial).faults, Contains(HasSubstr("the side is wrong")));
}

}  // namespace
}  // namespace brachium
