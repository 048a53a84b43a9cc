// A stretch of a trial by Ceres: the one place where terms meet `ceres::Problem`, and the reference
// for the chain.
#pragma once

#include "solver/least_squares.h"

namespace brachium {

// As Solve() says; all unknowns of `range` are solved for, nothing is handed on.
SolveSummary SolveByCeres(const ArmProblem& problem, State& state, const CarriedPrior& prior,
                          const TermRange& range, const SolveOptions& options);

}  // namespace brachium
