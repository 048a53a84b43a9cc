// Levenberg-Marquardt on the block elimination along time: a damped Gauss-Newton method whose every
// pass linearises, eliminates and solves a stretch of a trial front by front.
//
// A step d solves (H + λ D) d = -g, D being the diagonal of H. λ begins so small that steps are
// Gauss-Newton's, shrinks with every step that lowers the cost about as foretold, and grows with
// every step that does not, which is taken back.
// Source: Levenberg (1944), Marquardt (1963); the rule for λ after Nielsen (1999), as in Ceres.
#pragma once

#include "solver/least_squares.h"

namespace brachium {

// As Solve() says; all unknowns of `range` are solved for, nothing is handed on.
SolveSummary SolveChain(const ArmProblem& problem, State& state, const CarriedPrior& prior,
                        const TermRange& range, const SolveOptions& options,
                        ChainWorkspace& workspace);

}  // namespace brachium
