#include "solver/least_squares.h"

#include <gtest/gtest.h>

#include "solver/elimination.h"
#include "solver/initial_guess.h"
#include "tests/support/dense_information.h"
#include "tests/support/simulated_trial.h"

namespace brachium {
namespace {

constexpr SolveOptions kToTheEnd{.most_iterations = 100, .step_in_sd = 1e-6};

// The rest at the start and the first movements, dead reckoned.
struct Stretch {
  ArmProblem problem;
  State state;

  Stretch() : problem(CutTrial(), {.bias_node_spacing_s = 1.0}, 0.1), state(problem.PriorState()) {
    SetFirstKnot(problem, state);
    problem.FixHeadings(state);
    DeadReckon(problem, state, 0, Last());
  }
  int Last() const { return problem.timeline().Intervals(); }

 private:
  static Observations CutTrial() {
    Observations observations = Brisk(16).observations;
    for (Recording& recording : observations.recordings) recording = Cut(recording, 0.0, 4.4);
    return observations;
  }
};

Eigen::VectorXd BlockAt(Stretch& stretch, int unknown) {
  return Eigen::Map<const Eigen::VectorXd>(stretch.problem.Value(stretch.state, unknown),
                                           stretch.problem.Describe(unknown).Size());
}

TEST(LeastSquares, EndsWhereTheGaussNewtonStepIsNothingAgainstTheStandardDeviation) {
  Stretch stretch;
  const auto summary = Solve(stretch.problem, stretch.state, {}, 0, stretch.Last(), kToTheEnd);
  EXPECT_TRUE(summary.converged);
  EXPECT_LT(summary.final_cost, summary.initial_cost);
  DenseInformation all(stretch.problem);
  all.AddTerms(stretch.problem, stretch.state, 0, stretch.Last() + 1);
  const auto n = all.H.rows();
  for (Eigen::Index row = 0; row < n; ++row) all.H(row, row) += all.H(row, row) == 0.0 ? 1.0 : 0.0;
  const Eigen::MatrixXd covariance = SolvedInLongDouble(all.H, Eigen::MatrixXd::Identity(n, n));
  const Eigen::VectorXd step = covariance * all.g;
  EXPECT_LT(step.cwiseQuotient(covariance.diagonal().cwiseSqrt()).cwiseAbs().maxCoeff(), 1e-4);
}

TEST(LeastSquares, CountsEveryResidualOfTheStretchOnce) {
  Stretch stretch;
  double cost = 0.0;
  for (const Term& term : stretch.problem.terms()) {
    std::vector<const double*> x;
    for (const int unknown : term.unknowns)
      x.push_back(stretch.problem.Value(stretch.state, unknown));
    Eigen::VectorXd r(term.cost->num_residuals());
    term.cost->Evaluate(x.data(), r.data(), nullptr);
    double rho[3] = {r.squaredNorm(), 1.0, 0.0};
    if (term.loss) term.loss->Evaluate(r.squaredNorm(), rho);
    cost += 0.5 * rho[0];
  }
  const auto summary = Solve(stretch.problem, stretch.state, {}, 0, stretch.Last(), kToTheEnd);
  EXPECT_NEAR(summary.initial_cost / cost, 1.0, 1e-12);
}

TEST(LeastSquares, LeavesKnotsBeyondTheStretchAsTheyAre) {
  Stretch stretch;
  const Eigen::VectorXd inside = BlockAt(stretch, stretch.problem.Attitude(20, 1));
  const Eigen::VectorXd beyond = BlockAt(stretch, stretch.problem.Attitude(21, 1));
  Solve(stretch.problem, stretch.state, {}, 0, 20, kToTheEnd);
  EXPECT_NE(BlockAt(stretch, stretch.problem.Attitude(20, 1)), inside);
  EXPECT_EQ(BlockAt(stretch, stretch.problem.Attitude(21, 1)), beyond);
}

TEST(LeastSquares, HoldsTheGeometryWhenAskedTo) {
  for (const bool hold : {true, false}) {
    Stretch stretch;
    const int position = stretch.problem.Constant(UnknownKind::kSensorPosition, 1);
    const int joint = stretch.problem.Constant(UnknownKind::kJointVector, 0);
    const int scale = stretch.problem.Constant(UnknownKind::kAccelScale, 0);
    const int bias = stretch.problem.Constant(UnknownKind::kAccelBias, 0);
    SolveOptions options = kToTheEnd;
    options.hold_geometry = hold;
    Solve(stretch.problem, stretch.state, {}, 0, stretch.Last(), options);
    Stretch start;
    for (const int unknown : {position, joint, scale})
      EXPECT_EQ(BlockAt(stretch, unknown) == BlockAt(start, unknown), hold);
    EXPECT_NE(BlockAt(stretch, bias), BlockAt(start, bias));
  }
}

// Nothing is eliminated anew: what a solve's own last pass leaves is as good.
TEST(LeastSquares, HandsOnWhatAnEliminationAtItsMinimumSays) {
  Stretch stretch;
  ChainWorkspace workspace(stretch.problem);
  SolveOptions options = kToTheEnd;
  options.hand_on = true;
  Solve(stretch.problem, stretch.state, {}, 0, 30, options, &workspace);
  const CarriedPrior own = Elimination(workspace).Carry();
  const CarriedPrior anew =
      Elimination(stretch.problem, stretch.state, {}, 0, 30, workspace).Carry();
  EXPECT_EQ(own.unknowns, anew.unknowns);
  for (const int sensor : {0, 1}) {
    State moved = stretch.state;
    moved.Attitude(30, sensor)[0] += 1e-2;
    const auto cost = [&](const CarriedPrior& prior) {
      std::vector<const double*> values;
      for (const int unknown : prior.unknowns)
        values.push_back(stretch.problem.Value(moved, unknown));
      Eigen::VectorXd r(prior.cost->num_residuals());
      prior.cost->Evaluate(values.data(), r.data(), nullptr);
      return r.squaredNorm();
    };
    EXPECT_GT(cost(anew), 1.0);
    EXPECT_NEAR(cost(own) / cost(anew), 1.0, 1e-3);
  }
}

TEST(LeastSquares, MinimisesACarriedPriorAlongWithTheTerms) {
  Stretch stretch;
  Solve(stretch.problem, stretch.state, {}, 0, stretch.Last(), kToTheEnd);
  const Eigen::VectorXd whole = BlockAt(stretch, stretch.problem.Attitude(stretch.Last(), 1));
  ChainWorkspace workspace(stretch.problem);
  const CarriedPrior prior =
      Elimination(stretch.problem, stretch.state, {}, 0, 30, workspace).Carry();
  Solve(stretch.problem, stretch.state, prior, 30, stretch.Last(), kToTheEnd);
  const Eigen::VectorXd after = BlockAt(stretch, stretch.problem.Attitude(stretch.Last(), 1));
  EXPECT_LT((after - whole).norm(), 1e-7);  // linearised at the minimum, the prior keeps it
}

}  // namespace
}  // namespace brachium
