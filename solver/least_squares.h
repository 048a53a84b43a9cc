// A stretch of a trial as a Ceres problem: the one place where terms meet `ceres::Problem`.
#pragma once

#include <ceres/ceres.h>

#include "problems/arm_problem.h"
#include "solver/elimination.h"

namespace brachium {

struct SolveOptions {
  int most_iterations = 50;
  double function_tolerance = 0.0;  // relative change of cost that ends the search
  double step_tolerance = 1e-9;     // relative size of the step that ends it
  int threads = 1;
  bool hold_geometry = false;  // keep scales, lever arms and joint vectors as they are
};

// Minimises `prior` and the terms with start_knot <= first knot and last knot <= last_knot over the
// unknowns that they touch, in place.
ceres::Solver::Summary Solve(const ArmProblem& problem, State& state, const CarriedPrior& prior,
                             int start_knot, int last_knot, const SolveOptions& options);

}  // namespace brachium
