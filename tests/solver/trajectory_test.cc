#include "solver/trajectory.h"

#include <gtest/gtest.h>

#include "solver/initial_guess.h"
#include "tests/support/simulated_trial.h"

namespace brachium {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;
using Attitude = Eigen::Map<Quaterniond>;

struct Filled {
  ArmProblem problem;
  State state;
  Estimate estimate;

  // Dead reckoned, so that the gyroscope leads from each knot to the next without a gap to close.
  explicit Filled(const Observations& observations, double knot_spacing = 0.1)
      : problem(observations, {}, knot_spacing), state(problem.PriorState()) {
    SetFirstKnot(problem, state);
    DeadReckon(problem, state, 0, problem.timeline().Intervals());
    Fill();
  }
  void Fill() {
    estimate = {};
    estimate.time = problem.observations().recordings.front().time;
    FillTrajectory(problem, state, estimate);
  }
};

TEST(Trajectory, FollowsTheGyroscopeBetweenKnots) {
  const Filled filled(Brisk(16).observations);
  const auto& knots = filled.problem.timeline().knots;
  for (int sensor = 0; sensor < 2; ++sensor) {
    const Recording& recording =
        filled.problem.observations().recordings[static_cast<std::size_t>(sensor)];
    const Quaterniond& q_BS = recording.mounting->q_BS;
    const Vector3d bias = Eigen::Map<const Vector3d>(filled.state.GyroBias(0, sensor));
    Quaterniond q_WS = Eigen::Map<const Quaterniond>(filled.state.Attitude(0, sensor)) * q_BS;
    double from = knots.front();
    for (std::size_t i = 0; i < 600; ++i) {
      const double time = filled.estimate.time[i];
      q_WS = q_WS * filled.problem.Samples(sensor).Sum(from, time, bias).dq;
      from = time;
      const Quaterniond q_WB = q_WS * q_BS.conjugate();
      ASSERT_LT(
          Log<double>(q_WB.conjugate() * filled.estimate.q_WB.at(recording.segment)[i]).norm(),
          1e-5)
          << time;
    }
  }
}

TEST(Trajectory, ClosesOntoTheNextKnotInProportionToTime) {
  Filled filled(Brisk(16).observations);
  const AttitudesBySegment before = filled.estimate.q_WB;
  const double turn = 0.01;
  TurnFirstKnot(filled.state, 0, 0.0);
  Attitude q(filled.state.Attitude(1, 0));
  q = Quaterniond(Eigen::AngleAxisd(turn, Vector3d::UnitZ())) * q;
  filled.Fill();
  const auto& knots = filled.problem.timeline().knots;
  for (std::size_t i = 0; filled.estimate.time[i] < knots[1]; ++i) {
    const double share = (filled.estimate.time[i] - knots[0]) / (knots[1] - knots[0]);
    const double turned = Log<double>(filled.estimate.q_WB.at(Segment::kUpperArm)[i] *
                                      before.at(Segment::kUpperArm)[i].conjugate())
                              .z();
    EXPECT_NEAR(turned, share * turn, 1e-5);
  }
}

TEST(Trajectory, IsNotANumberOutsideTheSpanThatAllSensorsShare) {
  Observations observations = Brisk(16).observations;
  observations.recordings[1] = Cut(observations.recordings[1], 2.0, 13.0);
  const Filled filled(observations);
  const auto& knots = filled.problem.timeline().knots;
  int inside = 0;
  for (std::size_t i = 0; i < filled.estimate.time.size(); ++i) {
    const double time = filled.estimate.time[i];
    const bool covered = time >= knots.front() && time <= knots.back();
    inside += covered;
    for (const auto& [segment, q_WB] : filled.estimate.q_WB)
      EXPECT_EQ(q_WB[i].coeffs().allFinite(), covered) << Name(segment) << " " << time;
    for (const auto& [name, p_W] : filled.estimate.p_W)
      EXPECT_EQ(p_W[i].allFinite(), covered) << name << " " << time;
  }
  EXPECT_NEAR(inside, 1100, 12);
}

TEST(Trajectory, HangsTheJointsOnTheirSegments) {
  const Filled filled(Brisk(16).observations);
  const Estimate& estimate = filled.estimate;
  ASSERT_EQ(estimate.p_W.size(), 3u);
  const auto& segments = filled.problem.observations().arm.segments;
  for (const std::size_t i : {std::size_t{3}, std::size_t{700}, estimate.time.size() - 20}) {
    const Vector3d elbow =
        estimate.q_WB.at(Segment::kUpperArm)[i] * segments.at(Segment::kUpperArm).p_distal_B;
    const Vector3d wrist =
        estimate.q_WB.at(Segment::kForearm)[i] * segments.at(Segment::kForearm).p_distal_B;
    EXPECT_LT((estimate.p_W.at("elbow")[i] - estimate.p_W.at("shoulder")[i] - elbow).norm(), 1e-12);
    EXPECT_LT((estimate.p_W.at("wrist")[i] - estimate.p_W.at("elbow")[i] - wrist).norm(), 1e-12);
  }
}

TEST(Trajectory, LeadsTheRootThroughItsKnotsWithoutAJump) {
  Filled filled(Brisk(16).observations);
  const auto& knots = filled.problem.timeline().knots;
  const auto truth = [](double t) {
    return Vector3d(0.1 * std::sin(2 * t), 0.05 * std::cos(t), 0.0);
  };
  for (int knot = 0; knot < filled.problem.size().knots; ++knot)
    Eigen::Map<Vector3d>{filled.state.Root(knot, 0)} = truth(knots[static_cast<std::size_t>(knot)]);
  filled.Fill();
  for (std::size_t i = 20; i + 20 < filled.estimate.time.size(); ++i)
    ASSERT_LT((filled.estimate.p_W.at("shoulder")[i] - truth(filled.estimate.time[i])).norm(),
              1e-4);
}

}  // namespace
}  // namespace brachium
