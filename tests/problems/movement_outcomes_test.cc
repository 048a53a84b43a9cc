#include "problems/movement_outcomes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "problems/arm_model.h"
#include "problems/joint_angles.h"

namespace brachium {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;

double MinimumJerk(double t) {
  const double s = std::clamp(t, 0.0, 1.0);
  return s * s * s * (10.0 + s * (-15.0 + 6.0 * s));
}

struct Reaches {
  std::vector<double> time;
  std::map<Segment, std::vector<Quaterniond>> q_WB;
  std::map<std::string, std::vector<Vector3d>> p_W;
};

// Three reaches of 0.3 m, from 1, 3 and 5 s on, one second each; the elbow bends by 90 deg along.
Reaches Example() {
  Reaches reaches;
  for (int i = 0; i < 800; ++i) {
    const double t = 0.01 * i;
    const double way = MinimumJerk(t - 1.0) - MinimumJerk(t - 3.0) + MinimumJerk(t - 5.0);
    reaches.time.push_back(t);
    reaches.p_W["wrist"].push_back(Vector3d(0.3 * way, 0.1, 0.0));
    reaches.p_W["shoulder"].push_back(Vector3d(0.02 * way, 0.0, 0.0));
    reaches.q_WB[Segment::kUpperArm].push_back(Quaterniond::Identity());
    reaches.q_WB[Segment::kForearm].push_back(
        ElbowRotation({.flexion = way * 90 * kDegree}, Side::kRight));
  }
  return reaches;
}

MovementOutcomes OutcomesOf(const Reaches& reaches) {
  return OutcomesOf(Side::kRight, reaches.time, reaches.q_WB, reaches.p_W);
}

TEST(MovementOutcomes, TimeEachMovement) {
  const MovementOutcomes outcomes = OutcomesOf(Example());
  EXPECT_EQ(outcomes.mover, "wrist");
  ASSERT_EQ(outcomes.epochs.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(outcomes.epochs[i].start, 1.0 + 2.0 * static_cast<double>(i), 0.08);
    EXPECT_NEAR(outcomes.epochs[i].end, 2.0 + 2.0 * static_cast<double>(i), 0.08);
  }
}

TEST(MovementOutcomes, MeasureSpeedSmoothnessAndWay) {
  for (const MovementEpoch& epoch : OutcomesOf(Example()).epochs) {
    EXPECT_NEAR(epoch.peak_speed, 1.875 * 0.3, 0.005);
    EXPECT_NEAR(epoch.start + epoch.time_to_peak, std::round(epoch.start) + 0.5, 0.02);
    EXPECT_EQ(epoch.speed_peaks, 1);
    EXPECT_NEAR(epoch.spectral_arc_length, -1.41, 0.05);
    EXPECT_NEAR(epoch.path, 0.3, 0.01);
    EXPECT_NEAR(epoch.path_ratio.value(), 1.0, 0.02);
  }
}

TEST(MovementOutcomes, SeeADetour) {
  Reaches reaches = Example();
  for (Vector3d& p : reaches.p_W["wrist"]) p.y() = 0.1 * std::sin(10.0 * p.x() * 1.0472);
  for (const MovementEpoch& epoch : OutcomesOf(reaches).epochs)
    EXPECT_GT(epoch.path_ratio.value(), 1.1);
}

TEST(MovementOutcomes, TellRangesAndCompensation) {
  const MovementOutcomes outcomes = OutcomesOf(Example());
  const AngleRange& flexion = outcomes.ranges.at("elbow_flexion");
  EXPECT_NEAR(flexion.greatest - flexion.least, 90 * kDegree, 1e-6);
  EXPECT_NEAR(outcomes.shoulder_range.value(), 0.02, 0.0101);
  EXPECT_FALSE(outcomes.trunk_tilt.has_value());
}

TEST(MovementOutcomes, TellHowFarTheTrunkLeans) {
  Reaches reaches = Example();
  for (std::size_t i = 0; i < reaches.time.size(); ++i)
    reaches.q_WB[Segment::kThorax].push_back(
        Quaterniond(Eigen::AngleAxisd(i > 600 ? 0.2 : 0.0, Vector3d::UnitZ())) *
        Quaterniond(Eigen::AngleAxisd(i > 600 ? 0.1 : 0.0, Vector3d::UnitX())));
  EXPECT_NEAR(OutcomesOf(reaches).trunk_tilt.value(), 0.1, 1e-9);
}

TEST(MovementOutcomes, LookAtTurningWhereNoPlaceIsKnown) {
  Reaches reaches = Example();
  reaches.p_W.clear();
  const MovementOutcomes outcomes = OutcomesOf(reaches);
  EXPECT_EQ(outcomes.mover, "forearm");
  EXPECT_FALSE(outcomes.is_point);
  ASSERT_EQ(outcomes.epochs.size(), 3u);
  EXPECT_NEAR(outcomes.epochs[1].peak_speed, 1.875 * 90 * kDegree, 0.03);
  EXPECT_FALSE(outcomes.epochs[1].path_ratio.has_value());
}

TEST(MovementOutcomes, EndAMovementAtAGap) {
  Reaches reaches = Example();
  for (std::size_t i = 150; i < 153; ++i) reaches.p_W["wrist"][i].setConstant(std::nan(""));
  EXPECT_EQ(OutcomesOf(reaches).epochs.size(), 4u);
}

TEST(MovementOutcomes, AreNoneWithoutMovement) {
  Reaches reaches = Example();
  for (Vector3d& p : reaches.p_W["wrist"]) p.setZero();
  EXPECT_TRUE(OutcomesOf(reaches).epochs.empty());
  EXPECT_TRUE(OutcomesOf({}).epochs.empty());
}

}  // namespace
}  // namespace brachium
