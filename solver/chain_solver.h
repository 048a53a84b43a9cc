// Levenberg-Marquardt on the block elimination along time: a damped Gauss-Newton method whose every
// pass linearises, eliminates and solves a stretch of a trial front by front.
//
// A step d solves (H + λ D) d = -g, D being the diagonal of H. λ begins so small that steps are
// Gauss-Newton's. A step that lowers the cost by much less than foretold, or raises it, is shortened
// to the bottom of the parabola through both costs and the slope; one that lowers it by much more is
// doubled while that helps. One that does not help when shortened either is taken back, and λ grows.
// Steps are bent as arms turn (step_values.h), and where they shrink slowly the last ones make them
// faster (step_memory.h). The search ends as SolveOptions says, by dᵀ H d = |L⁻¹ g|², the squared
// length of the step in standard deviations: no linear combination of the unknowns moves by more of
// its own.
// Source: Levenberg (1944), Marquardt (1963); Madsen, Nielsen & Tingleff, Methods for Non-Linear
// Least Squares Problems (2004), sections 3.2 and 2.3.
#pragma once

#include "solver/least_squares.h"

namespace brachium {

// As Solve() says; all unknowns of `range` are solved for, nothing is handed on.
SolveSummary SolveChain(const ArmProblem& problem, State& state, const CarriedPrior& prior,
                        const TermRange& range, const SolveOptions& options,
                        ChainWorkspace& workspace);

}  // namespace brachium
