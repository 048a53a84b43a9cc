#include "solver/unmodelled.h"

#include <gtest/gtest.h>

#include "solver/initial_guess.h"
#include "solver/window.h"
#include "tests/support/dense_information.h"
#include "tests/support/simulated_trial.h"

namespace brachium {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

// A trial solved from end to end with the weights that it starts with.
struct Solved {
  ArmProblem problem;
  State state;
  ChainWorkspace workspace{problem};

  explicit Solved(const Observations& observations)
      : problem(observations, {}, 0.1), state(problem.PriorState()) {
    SolveForward(problem, state, {}, {});
    Solve(problem, state, {}, 0, problem.timeline().Intervals(), {});
  }

  std::vector<Unmodelled> Estimated() {
    workspace.Linearise(problem, state);
    UnmodelledSums sums(problem);
    sums.Add(problem, 0, problem.size().knots, workspace);
    return sums.Estimate();
  }

  // (Σ|r|² + 30) / (Σ rows - tr(J Σ Jᵀ) + 30), by the dense covariance.
  double DenseRatio(const MatrixXd& covariance, ResidualKind kind, int sensor) {
    double squares = 30.0, redundancy = 30.0;
    for (const Term& term : problem.terms()) {
      if (term.kind != kind || term.sensor != sensor) continue;
      DenseInformation one(problem);
      one.Add(*term.cost, term.unknowns, problem, state);
      redundancy += term.cost->num_residuals() - one.H.cwiseProduct(covariance).sum();
      std::vector<const double*> values;
      for (const int unknown : term.unknowns) values.push_back(problem.Value(state, unknown));
      VectorXd r(term.cost->num_residuals());
      term.cost->Evaluate(values.data(), r.data(), nullptr);
      squares += r.squaredNorm();
    }
    return squares / redundancy;
  }
};

Observations BrieflyMoved() {
  Observations observations = Brisk(16).observations;
  for (Recording& recording : observations.recordings) recording = Cut(recording, 6.0, 8.0);
  observations.start_pose.reset();
  return observations;
}

TEST(Unmodelled, IsWhatTheDenseCovarianceSays) {
  Solved solved(BrieflyMoved());
  const ArmProblem& problem = solved.problem;
  DenseInformation all(problem);
  all.AddTerms(problem, solved.state, 0, problem.size().knots);
  const auto n = all.H.rows();
  const MatrixXd covariance = SolvedInLongDouble(all.H, MatrixXd::Identity(n, n));
  const std::vector<Unmodelled> found = solved.Estimated();
  for (int sensor = 0; sensor < 2; ++sensor) {
    const Unmodelled& one = found[static_cast<std::size_t>(sensor)];
    const Unmodelled& told = problem.unmodelled()[static_cast<std::size_t>(sensor)];
    const double quiver = solved.DenseRatio(covariance, ResidualKind::kSegmentChain, sensor) *
                          told.quiver * told.quiver;
    EXPECT_NEAR(one.quiver * one.quiver / quiver, 1.0, 0.03) << sensor;
    const double white =
        0.5 *
        std::pow(
            problem.observations().recordings[static_cast<std::size_t>(sensor)].noise.accel_density,
            2);
    const double memory = 2 * problem.options().unmodelled_correlation_s;
    const auto density = [&](double acceleration) {
      return white + memory * acceleration * acceleration;
    };
    const double ratio = solved.DenseRatio(covariance, ResidualKind::kAccelerometer, sensor);
    EXPECT_NEAR(density(one.acceleration) / (ratio * density(told.acceleration)), 1.0, 0.03)
        << sensor;
  }
}

TEST(Unmodelled, IsTheSameEveryTime) {
  Solved solved(BrieflyMoved());
  const std::vector<Unmodelled> once = solved.Estimated(), again = solved.Estimated();
  for (std::size_t sensor = 0; sensor < 2; ++sensor) {
    EXPECT_EQ(once[sensor].acceleration, again[sensor].acceleration);
    EXPECT_EQ(once[sensor].quiver, again[sensor].quiver);
  }
}

TEST(Unmodelled, IsLargerWhereMoreIsLeftOut) {
  const auto of_forearm = [](double wobble) {
    SimulationOptions options;
    options.soft_tissue = {.translation_rms = wobble, .frequency = 2.0};
    return Solved(Brisk(16, options).observations).Estimated().at(1).acceleration;
  };
  const double firm = of_forearm(0.0), soft = of_forearm(0.006);
  EXPECT_GT(firm, 0.0);
  EXPECT_GT(soft, 2 * firm);
}

}  // namespace
}  // namespace brachium
