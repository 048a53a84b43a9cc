// A stretch of a trial as a least-squares problem, and what solves it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "problems/arm_problem.h"
#include "solver/front_sweep.h"

namespace brachium {

enum class SolverKind {
  kChain,  // Levenberg-Marquardt on the block elimination along time (chain_solver.h)
  kCeres,  // the same objective by Ceres: slower, the reference
};
std::optional<SolverKind> SolverNamed(std::string_view name);  // "chain", "ceres"

struct SolveOptions {
  SolverKind solver = SolverKind::kChain;
  int most_iterations = 50;
  // The search ends with a step that moves no linear combination of the unknowns by more than this
  // share of its standard deviation, or after which the next one would not. Smaller: closer to the
  // minimum, more iterations.
  double step_in_sd = 1e-4;
  // Or before a step that, were the objective quadratic, lowers the cost by less than this share: the
  // values that stand are then those at which the last pass was made.
  double least_decrease = 0.0;
  int threads = 1;  // of Ceres; the chain takes one
  // Leave the terms that begin at the last knot to those who go on from it, to whom
  // Elimination(workspace).Carry() tells what this stretch had to say.
  bool hand_on = false;
  bool hold_geometry = false;  // keep scales, lever arms and joint vectors as they are
};

struct SolveSummary {
  int iterations = 0;  // steps tried
  double initial_cost = 0.0, final_cost = 0.0;
  double gradient_norm = 0.0;  // largest component at the last linearisation
  bool converged = false;
  std::string message;
};

// Minimises `prior` and the terms with start_knot <= first knot and last knot <= last_knot over the
// unknowns that they touch, in place. `workspace`, made for this problem, saves memory from being
// asked for again and again, and holds the last pass afterwards.
SolveSummary Solve(const ArmProblem& problem, State& state, const CarriedPrior& prior,
                   int start_knot, int last_knot, const SolveOptions& options,
                   ChainWorkspace* workspace = nullptr);

}  // namespace brachium
