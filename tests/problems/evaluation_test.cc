#include "problems/evaluation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "problems/arm_model.h"
#include "problems/joint_angles.h"
#include "problems/rotation.h"
#include "tests/support/smooth_motion.h"

namespace brachium {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;
using Frames = Reference::Frames;

constexpr double kNaN = Statistics::kUnknown;

Quaterniond UpperArm(double t) { return SmoothRotation(0.5 * t); }

Quaterniond Elbow(double t) {
  return ElbowRotation({.flexion = 1.0 + 0.6 * std::sin(1.9 * t),
                        .carrying = 0.15,
                        .pronation = 1.5 + 0.5 * std::sin(1.1 * t)},
                       Side::kRight);
}

struct Pair {
  Estimate estimate;
  Reference reference;
};

// An arm and a reference that agree at every instant.
Pair Agreeing(std::size_t n = 3000) {
  Pair pair;
  pair.estimate.time = pair.reference.time = EvenTimes(0.0, 0.01, n);
  const std::vector<double>& time = pair.estimate.time;
  auto& q_WB = pair.estimate.q_WB;
  q_WB[Segment::kUpperArm] = Sampled(time, UpperArm);
  q_WB[Segment::kForearm] = Sampled(time, [](double t) { return UpperArm(t) * Elbow(t); });
  pair.estimate.p_W["elbow"] =
      Sampled(time, [](double t) { return Vector3d(UpperArm(t) * Vector3d(0, -0.3, 0)); });
  pair.estimate.p_W["wrist"] = Sampled(time, SmoothPoint);
  pair.reference.q_VB = q_WB;
  pair.reference.p_V = pair.estimate.p_W;
  pair.reference.clock_offset = 0.0;
  return pair;
}

void Turn(const Quaterniond& left, std::vector<Quaterniond>* rotations, const Quaterniond& right) {
  for (Quaterniond& q : *rotations) q = left * q * right;
}

const Quaterniond kNone = Quaterniond::Identity();

const OrientationEvaluation& ForearmInUpperArm(const Evaluation& evaluation) {
  EXPECT_EQ(evaluation.relative.at(0).name, "forearm_in_upper_arm");
  return evaluation.relative.at(0).orientation;
}

TEST(Evaluate, FindsNoErrorWhereThereIsNone) {
  for (const Frames frames : {Frames::kSegment, Frames::kCluster}) {
    Pair pair = Agreeing();
    pair.reference.frames = frames;
    const Evaluation evaluation = Evaluate(pair.estimate, pair.reference);
    EXPECT_EQ(evaluation.used, 3000u);
    for (const auto& [segment, orientation] : evaluation.orientation)
      EXPECT_LT(orientation.aligned.rotation.max, 1e-9);
    EXPECT_LT(ForearmInUpperArm(evaluation).aligned.rotation.max, 1e-9);
    for (const auto& [name, angle] : evaluation.joint_angles) EXPECT_LT(angle.max, 1e-9) << name;
    for (const auto& [name, position] : evaluation.positions)
      EXPECT_LT(position.aligned.distance.max, 1e-12) << name;
  }
}

TEST(Evaluate, GivesBackAConstantTurnOfTheForearmInFullWhereFramesAreTheSegments) {
  Pair pair = Agreeing();
  Turn(kNone, &pair.estimate.q_WB[Segment::kForearm], Exp(Vector3d(0, 3 * kDegree, 0)));
  const Evaluation evaluation = Evaluate(pair.estimate, pair.reference);
  const OrientationEvaluation& relative = ForearmInUpperArm(evaluation);
  EXPECT_NEAR(relative.raw.rotation.rmse, 3 * kDegree, 1e-9);
  EXPECT_NEAR(relative.raw.rotation.bias, 3 * kDegree, 1e-9);
  EXPECT_NEAR(relative.aligned.rotation.rmse, 0.0, 1e-9);
  EXPECT_NEAR(evaluation.joint_angles.at("forearm_pronation").bias, 3 * kDegree, 1e-9);
  EXPECT_NEAR(evaluation.joint_angles.at("forearm_pronation").sd, 0.0, 1e-9);
  EXPECT_NEAR(evaluation.joint_angles.at("elbow_flexion").max, 0.0, 1e-9);
  EXPECT_NEAR(evaluation.joint_angles.at("elbow_carrying").max, 0.0, 1e-9);
}

TEST(Evaluate, RemovesAConstantOnEachSideWhereFramesAreClusters) {
  Pair pair = Agreeing();
  pair.reference.frames = Frames::kCluster;
  const Quaterniond heading = Exp(Vector3d(0, 0, 1.2));
  Turn(heading, &pair.reference.q_VB[Segment::kUpperArm], Exp(Vector3d(1, -1, 0.4)));
  Turn(heading, &pair.reference.q_VB[Segment::kForearm], Exp(Vector3d(0.3, 2, -1)));
  const Evaluation evaluation = Evaluate(pair.estimate, pair.reference);
  EXPECT_GT(ForearmInUpperArm(evaluation).raw.rotation.rmse, 1.0);
  EXPECT_LT(ForearmInUpperArm(evaluation).aligned.rotation.max, 1e-9);
  EXPECT_NEAR(evaluation.heading, 1.2, 1e-9);
  for (const auto& [segment, orientation] : evaluation.orientation)
    EXPECT_LT(orientation.aligned.rotation.max, 1e-9);
  EXPECT_TRUE(evaluation.joint_angles.empty());
}

TEST(Evaluate, PutsADriftOfTheForearmsHeadingIntoRelativeHeadingAlone) {
  Pair pair = Agreeing();
  std::vector<Quaterniond>& q_WF = pair.estimate.q_WB[Segment::kForearm];
  for (std::size_t i = 0; i < q_WF.size(); ++i)
    q_WF[i] = Exp(Vector3d(0, 0, 0.01 * pair.estimate.time[i])) * q_WF[i];
  const OrientationErrors errors = ForearmInUpperArm(Evaluate(pair.estimate, pair.reference)).raw;
  EXPECT_NEAR(errors.heading.max, 0.01 * pair.estimate.time.back(), 1e-9);
  EXPECT_NEAR(errors.heading.rmse, errors.rotation.rmse, 1e-9);
  EXPECT_LT(errors.inclination.max, 1e-7);
}

TEST(Evaluate, LetsTheCommonHeadingEnterNoRelativeError) {
  Pair pair = Agreeing();
  for (auto& [segment, q_WB] : pair.estimate.q_WB)
    for (std::size_t i = 0; i < q_WB.size(); ++i)
      q_WB[i] = Exp(Vector3d(0, 0, 0.5 + 0.02 * pair.estimate.time[i])) * q_WB[i];
  const Evaluation evaluation = Evaluate(pair.estimate, pair.reference);
  EXPECT_LT(ForearmInUpperArm(evaluation).raw.rotation.max, 1e-9);
  const OrientationErrors& upper_arm = evaluation.orientation.at(Segment::kUpperArm).aligned;
  EXPECT_GT(upper_arm.heading.rmse, 0.1);
  EXPECT_LT(upper_arm.heading.bias, 1e-3);
  EXPECT_LT(upper_arm.inclination.max, 1e-7);
}

TEST(Evaluate, GivesBackTheInclinationOfASegmentInASegmentsFrame) {
  Pair pair = Agreeing();
  Turn(Exp(Vector3d(0.02, 0, 0)), &pair.estimate.q_WB[Segment::kUpperArm], kNone);
  const Evaluation evaluation = Evaluate(pair.estimate, pair.reference);
  EXPECT_NEAR(evaluation.orientation.at(Segment::kUpperArm).aligned.inclination.rmse, 0.02, 1e-9);
  EXPECT_NEAR(evaluation.orientation.at(Segment::kForearm).aligned.inclination.rmse, 0.0, 1e-7);
}

TEST(Evaluate, GivesBackTheSpreadOfNoiseInAnAngle) {
  Pair pair = Agreeing();
  std::mt19937 random(1);
  std::normal_distribution<double> normal(0.0, 2 * kDegree);
  std::vector<Quaterniond>& q_WF = pair.estimate.q_WB[Segment::kForearm];
  for (Quaterniond& q : q_WF) q = q * Exp(Vector3d(0, normal(random), 0));
  const Statistics pronation =
      Evaluate(pair.estimate, pair.reference).joint_angles.at("forearm_pronation");
  EXPECT_NEAR(pronation.sd, 2 * kDegree, 0.1 * kDegree);
  EXPECT_NEAR(pronation.bias, 0.0, 0.15 * kDegree);
  EXPECT_GT(pronation.correlation.value(), 0.99);
}

TEST(Evaluate, TakesTheShortWayRoundTheCircleForAnAngle) {
  Pair pair = Agreeing();
  auto& q_VF = pair.reference.q_VB[Segment::kForearm];
  Turn(kNone, &q_VF, Exp(Vector3d(0, 100 * kDegree, 0)));  // pronation passes 180 deg
  pair.estimate.q_WB[Segment::kForearm] = q_VF;
  Turn(kNone, &pair.estimate.q_WB[Segment::kForearm], Exp(Vector3d(0, 2 * kDegree, 0)));
  const Statistics pronation =
      Evaluate(pair.estimate, pair.reference).joint_angles.at("forearm_pronation");
  EXPECT_NEAR(pronation.bias, 2 * kDegree, 1e-9);
  EXPECT_NEAR(pronation.max, 2 * kDegree, 1e-9);
}

TEST(Evaluate, ForgivesAReferenceItsRounding) {
  Pair pair = Agreeing();
  for (Quaterniond& q : pair.reference.q_VB[Segment::kUpperArm]) q.coeffs() *= 1.0009;
  for (const auto& [name, angle] : Evaluate(pair.estimate, pair.reference).joint_angles)
    EXPECT_LT(angle.max, 1e-9) << name;
}

TEST(Evaluate, ReadsBothSidesAlike) {
  Pair pair = Agreeing();
  Turn(kNone, &pair.estimate.q_WB[Segment::kForearm], Exp(Vector3d(0.01, 0.03, -0.02)));
  const Evaluation right = Evaluate(pair.estimate, pair.reference);
  pair.estimate.side = Side::kLeft;
  for (auto* rotations : {&pair.estimate.q_WB, &pair.reference.q_VB})
    for (auto& [segment, q_AB] : *rotations)
      for (Quaterniond& q : q_AB) q = Mirrored(q);
  const Evaluation left = Evaluate(pair.estimate, pair.reference);
  for (const auto& [name, angle] : right.joint_angles) {
    EXPECT_NEAR(left.joint_angles.at(name).bias, angle.bias, 1e-12) << name;
    EXPECT_NEAR(left.joint_angles.at(name).rmse, angle.rmse, 1e-12) << name;
  }
}

TEST(Evaluate, ComparesAtTheReferencesInstantsOnItsOwnClock) {
  Pair pair = Agreeing();
  pair.reference.time = EvenTimes(2.0031, 1.0 / 120.0, 600);
  pair.reference.clock_offset = 1.5;
  pair.reference.p_V.clear();
  pair.reference.q_VB[Segment::kUpperArm] =
      Sampled(pair.reference.time, [](double t) { return UpperArm(t - 1.5); });
  pair.reference.q_VB.erase(Segment::kForearm);
  const Evaluation evaluation = Evaluate(pair.estimate, pair.reference);
  EXPECT_EQ(evaluation.used, 600u);
  EXPECT_EQ(evaluation.clock_offset.seconds, 1.5);
  EXPECT_LT(evaluation.orientation.at(Segment::kUpperArm).raw.rotation.max, 1e-4);
}

TEST(Evaluate, EstimatesTheClockOffsetAndSaysSo) {
  Pair pair = Agreeing();
  for (double& t : pair.reference.time) t += 0.0373;
  pair.reference.clock_offset.reset();
  const Evaluation evaluation = Evaluate(pair.estimate, pair.reference);
  EXPECT_NEAR(evaluation.clock_offset.seconds, 0.0373, 5e-4);
  EXPECT_EQ(evaluation.clock_offset.source, ClockOffset::Source::kEstimated);
  EXPECT_LT(ForearmInUpperArm(evaluation).raw.rotation.max, 5e-3);
}

TEST(Evaluate, BridgesNoGapOfEitherAndCountsWhatItLeavesOut) {
  Pair pair = Agreeing(1000);
  auto& q_VF = pair.reference.q_VB[Segment::kForearm];
  for (std::size_t i = 100; i < 150; ++i) q_VF[i].z() = kNaN;
  auto& q_WF = pair.estimate.q_WB[Segment::kForearm];
  for (std::size_t i = 300; i < 320; ++i) q_WF[i].w() = kNaN;
  auto& time = pair.estimate.time;  // 500 to 599 are lost
  time.erase(time.begin() + 500, time.begin() + 600);
  for (auto& [segment, q_WB] : pair.estimate.q_WB)
    q_WB.erase(q_WB.begin() + 500, q_WB.begin() + 600);
  pair.estimate.p_W.clear();
  const Evaluation evaluation = Evaluate(pair.estimate, pair.reference);
  const Statistics& forearm = evaluation.orientation.at(Segment::kForearm).raw.rotation;
  EXPECT_EQ(forearm.left_out, 50u + 20u + 100u);
  EXPECT_EQ(forearm.used, 830u);
  EXPECT_LT(forearm.max, 1e-9);
  EXPECT_EQ(evaluation.orientation.at(Segment::kUpperArm).raw.rotation.left_out, 100u);
  EXPECT_EQ(ForearmInUpperArm(evaluation).raw.rotation.used, 830u);
  EXPECT_EQ(evaluation.used, 900u);
  EXPECT_EQ(evaluation.reference_samples, 1000u);
}

TEST(Evaluate, LeavesOutWhatTheEstimateDoesNotReach) {
  Pair pair = Agreeing(1000);
  for (double& t : pair.reference.time) t += 5.0;
  pair.reference.clock_offset = 0.0;
  EXPECT_EQ(Evaluate(pair.estimate, pair.reference).used, 500u);
}

TEST(Evaluate, MeasuresPositionsAfterOneHeadingAndOneShiftOfAll) {
  Pair pair = Agreeing();
  for (auto& [name, p_V] : pair.reference.p_V)
    for (Vector3d& p : p_V) p = Exp(Vector3d(0, 0, -2)) * p + Vector3d(4, 5, 6);
  for (Vector3d& p : pair.reference.p_V["wrist"]) p -= Vector3d(0, 0, 0.005);
  const Evaluation evaluation = Evaluate(pair.estimate, pair.reference);
  EXPECT_NEAR(evaluation.point_alignment.heading, -2.0, 1e-9);
  const PositionEvaluation& wrist = evaluation.positions.at("wrist");
  const PositionEvaluation& elbow = evaluation.positions.at("elbow");
  EXPECT_NEAR(wrist.aligned.vertical.value().bias - elbow.aligned.vertical.value().bias, 0.005,
              1e-9);
  EXPECT_LT(wrist.aligned.horizontal.max, 1e-9);
  EXPECT_GT(wrist.raw.distance.rmse, 1.0);
}

TEST(Evaluate, MeasuresADeadReckonedWalkAgainstItsPath) {
  Pair pair = Agreeing();
  pair.estimate.q_WB.clear();
  pair.reference.q_VB.clear();
  pair.estimate.p_W = {{"hand", Sampled(pair.estimate.time, SmoothPoint)}};
  pair.reference.p_V = {{"hand", Sampled(pair.reference.time, [](double t) {
                           const Vector3d p = SmoothPoint(t);
                           return Vector3d(1 - p.y(), p.x(), kNaN);
                         })}};
  pair.estimate.p_W["hand"].back() += Vector3d(0.3, 0.4, 7.0);
  const PositionEvaluation hand = Evaluate(pair.estimate, pair.reference).positions.at("hand");
  EXPECT_NEAR(hand.final_horizontal, 0.5, 0.005);
  EXPECT_NEAR(hand.closing_horizontal, 0.5, 0.005);
  EXPECT_NEAR(hand.aligned.horizontal.rmse, 0.5 / std::sqrt(3000.0), 1e-4);
  EXPECT_FALSE(hand.aligned.vertical.has_value());
  double way = 0.0;
  for (double t = 0.0; t < 29.985; t += 0.01)
    way += (SmoothPoint(t + 0.01) - SmoothPoint(t)).head<2>().norm();
  EXPECT_NEAR(hand.path_length, way, 0.01 * way);
}

TEST(Evaluate, KeepsTheErrorsOverTimeOnTheRecordingsClock) {
  Pair pair = Agreeing(1000);
  for (double& t : pair.reference.time) t += 0.5;
  pair.reference.clock_offset = 0.5;
  for (const Frames frames : {Frames::kSegment, Frames::kCluster}) {
    pair.reference.frames = frames;
    Quaterniond& turned = pair.estimate.q_WB[Segment::kForearm][700];
    turned = turned * Exp(Vector3d(0.0, 0.2, 0.0));
    pair.estimate.p_W["wrist"][700].z() += 0.04;
    const Evaluation evaluation = Evaluate(pair.estimate, pair.reference);
    const std::vector<double>& angle = evaluation.relative.at(0).angle;
    const auto worst = std::max_element(angle.begin(), angle.end()) - angle.begin();
    EXPECT_EQ(worst, 700);
    EXPECT_NEAR(evaluation.time[700], 7.0, 1e-9);
    const auto& relative = evaluation.relative.at(0).orientation;
    EXPECT_EQ(angle[700],
              (frames == Frames::kSegment ? relative.raw : relative.aligned).rotation.max);
    const PositionEvaluation& wrist = evaluation.positions.at("wrist");
    EXPECT_NEAR(wrist.distance[700], wrist.aligned.distance.max, 1e-15);
  }
}

TEST(Evaluate, SplitsErrorsByAxis) {
  Pair pair = Agreeing(1000);
  Turn(kNone, &pair.estimate.q_WB[Segment::kForearm], Exp(Vector3d(0.0, 0.03, 0.0)));
  for (Vector3d& p : pair.estimate.p_W["wrist"]) p.y() += 0.01;
  const Evaluation evaluation = Evaluate(pair.estimate, pair.reference);
  const auto& axis = ForearmInUpperArm(evaluation).raw.axis;
  EXPECT_NEAR(axis[0].rmse, 0.0, 1e-12);
  EXPECT_NEAR(axis[1].bias, 0.03, 1e-12);
  EXPECT_NEAR(axis[2].rmse, 0.0, 1e-12);
  EXPECT_NEAR(evaluation.positions.at("wrist").raw.axis[0].rmse, 0.0, 1e-12);
  EXPECT_NEAR(evaluation.positions.at("wrist").raw.axis[1].bias, 0.01, 1e-12);
}

TEST(Evaluate, LooksAtMovementsOfBothAlike) {
  Pair pair = Agreeing();
  for (Vector3d& p : pair.reference.p_V["wrist"]) p.z() = kNaN;  // in the plane
  const Evaluation evaluation = Evaluate(pair.estimate, pair.reference);
  ASSERT_FALSE(evaluation.outcomes.epochs.empty());
  EXPECT_EQ(evaluation.outcomes.epochs.size(), evaluation.reference_outcomes.epochs.size());
  EXPECT_EQ(evaluation.outcomes.epochs[0].peak_speed,
            evaluation.reference_outcomes.epochs[0].peak_speed);
  EXPECT_EQ(evaluation.outcomes.ranges.size(), evaluation.reference_outcomes.ranges.size());
}

TEST(Evaluate, IsEmptyButWholeWhereNothingIsKnown) {
  Pair absent = Agreeing(50);
  for (auto& [segment, q_VB] : absent.reference.q_VB)
    for (Quaterniond& q : q_VB) q = Quaterniond(kNaN, kNaN, kNaN, kNaN);
  for (auto& [name, p_V] : absent.reference.p_V)
    for (Vector3d& p : p_V) p.setConstant(kNaN);
  for (const Frames frames : {Frames::kSegment, Frames::kCluster})
    for (const bool given : {true, false}) {
      absent.reference.frames = frames;
      if (!given) absent.reference.clock_offset.reset();
      const Evaluation evaluation = Evaluate(absent.estimate, absent.reference);
      EXPECT_EQ(evaluation.used, 0u);
      EXPECT_TRUE(std::isnan(ForearmInUpperArm(evaluation).raw.rotation.rmse));
      EXPECT_TRUE(std::isnan(evaluation.positions.at("wrist").final_horizontal));
      EXPECT_EQ(evaluation.heading, 0.0);
    }
  EXPECT_EQ(Evaluate(Estimate{}, Reference{}).used, 0u);
  EXPECT_EQ(Evaluate(Agreeing(10).estimate, Reference{}).used, 0u);
  EXPECT_EQ(Evaluate(Estimate{}, Agreeing(10).reference).used, 0u);
}

}  // namespace
}  // namespace brachium
