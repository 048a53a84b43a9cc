#include "solver/covariance.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "solver/initial_guess.h"
#include "solver/window.h"
#include "tests/support/assess_at.h"
#include "tests/support/dense_information.h"
#include "tests/support/overstretched.h"
#include "tests/support/simulated_trial.h"

namespace brachium {
namespace {

// A trial solved from end to end with the weights that it starts with.
struct Solved {
  ArmProblem problem;
  State state;

  explicit Solved(const Observations& observations, double knot_spacing = 0.1)
      : problem(observations, {}, knot_spacing), state(problem.PriorState()) {
    SolveForward(problem, state, {}, {});
    Solve(problem, state, {}, 0, problem.timeline().Intervals(), {});
  }
  Certainty Assess() { return AssessAt(problem, state); }
};

Observations CutAt(double end) {
  Observations observations = Brisk(16).observations;
  for (Recording& recording : observations.recordings) recording = Cut(recording, 0.0, end);
  return observations;
}

TEST(Certainty, IsThatOfTheDenseInverse) {
  Solved solved(CutAt(4.0));
  const ArmProblem& problem = solved.problem;
  DenseInformation all(problem);
  all.AddTerms(problem, solved.state, 0, problem.size().knots);
  const auto n = all.H.rows();
  for (Eigen::Index row = 0; row < n; ++row) ASSERT_GT(all.H(row, row), 0.0);
  const Eigen::VectorXd sd =
      SolvedInLongDouble(all.H, Eigen::MatrixXd::Identity(n, n)).diagonal().cwiseSqrt();

  const Certainty certainty = solved.Assess();
  EXPECT_TRUE(certainty.singular.empty());
  int constants = 0;
  for (int unknown = problem.FirstConstant(); unknown < problem.unknowns(); ++unknown)
    constants += problem.Describe(unknown).held ? 0 : 1;
  EXPECT_EQ(certainty.constant_sd.size(),
            static_cast<std::size_t>(constants + 2 * problem.size().nodes));
  for (const auto& [unknown, found] : certainty.constant_sd) {
    const Eigen::VectorXd expected = sd.segment(all.OffsetOf(unknown), found.size());
    EXPECT_LT((found.cwiseQuotient(expected).array() - 1.0).abs().maxCoeff(), 1e-8);
  }
  ASSERT_EQ(certainty.root_sd.size(), static_cast<std::size_t>(problem.size().knots));
  for (const int knot : {0, 7, problem.size().knots - 1}) {
    const double expected = sd.segment<3>(all.OffsetOf(problem.Root(knot, 0))).maxCoeff();
    EXPECT_NEAR(certainty.root_sd[static_cast<std::size_t>(knot)] / expected, 1.0, 1e-8);
  }
}

TEST(Certainty, GrowsWithTheLengthOfATrial) {
  Solved brief(CutAt(6.0)), longer(Brisk(16).observations);
  const auto sd = [](Solved& solved, UnknownKind kind, int sensor) {
    return solved.Assess().constant_sd.at(solved.problem.Constant(kind, sensor)).norm();
  };
  EXPECT_LT(sd(longer, UnknownKind::kAccelBias, 1), sd(brief, UnknownKind::kAccelBias, 1));
  EXPECT_LT(sd(longer, UnknownKind::kSensorPosition, 1),
            sd(brief, UnknownKind::kSensorPosition, 1));
}

TEST(Certainty, TakesNothingFromAStopThatAnElbowLeansOn) {
  const Observations observations = CutAt(4.0);
  const auto assessed = [&](double sigma_deg) {
    ModelOptions model;
    model.range_of_motion_sigma_deg = sigma_deg;
    ArmProblem problem(observations, model, 0.1);
    State state = Overstretched(problem);
    problem.FixHeadings(state);
    return AssessAt(problem, state);
  };
  const Certainty firm = assessed(0.1), loose = assessed(1e4);
  EXPECT_EQ(firm.root_sd, loose.root_sd);
  for (const auto& [unknown, sd] : firm.constant_sd) EXPECT_EQ(sd, loose.constant_sd.at(unknown));
}

TEST(DrawnSd, IsAboutThatOfTheCovariance) {
  Solved solved(CutAt(8.0));
  ChainWorkspace workspace(solved.problem);
  workspace.Linearise(solved.problem, solved.state);
  const int clock = solved.problem.Constant(UnknownKind::kClockOffset, 1);
  const double sd =
      AssessCertainty(solved.problem, solved.state, workspace).constant_sd.at(clock)[0];
  EXPECT_NEAR(DrawnSd(workspace, clock) / sd, 1.0, 0.2);
  EXPECT_EQ(DrawnSd(workspace, solved.problem.Constant(UnknownKind::kClockOffset, 0)), 0.0);
}

// Its last digits decide whether the pivot of the heading counts as lost: if not, as next to nothing.
TEST(Certainty, NamesWhatTheInformationDoesNotDetermine) {
  const Observations observations = CutAt(4.0);
  State state = Solved(observations).state;
  const ArmProblem problem(observations, {}, 0.1);  // its heading not tied down
  PoseCovariance poses(problem, state);
  const std::vector<int> singular = AssessAt(problem, state, &poses).singular;
  const bool is_named = std::any_of(singular.begin(), singular.end(), [&](int unknown) {
    return problem.Describe(unknown).kind == UnknownKind::kAttitude;
  });
  const double heading_sd = std::sqrt(poses.Attitudes(20, 0.0)(2, 2));
  EXPECT_TRUE(is_named || heading_sd > 10.0) << heading_sd;
}

}  // namespace
}  // namespace brachium
