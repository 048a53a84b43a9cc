// How much the model leaves out of the sensors' motion, by the residuals of a solved trial.
//
// A weighted residual r whose assumed variance is right has E|r|² = rows - tr(J Σ Jᵀ): the unknowns,
// of covariance Σ, take up the rest. Of each sensor and kind the sums over the trial give
//   σ̂²/σ² = (Σ|r|² + n) / (Σ rows - tr(J Σ Jᵀ) + n),
// n residuals of the first guess being thrown in, which a short or poorly linked trial keeps. The
// trace comes from a few deviations ξ of covariance Σ, drawn with a fixed seed: E|J ξ|² is it.
// Source: variance components, Förstner (1979); trace by random signs, Hutchinson (1989).
#pragma once

#include <vector>

#include "problems/arm_problem.h"
#include "solver/front_sweep.h"

namespace brachium {

// Of each sensor at `state`, at or next to which `workspace` made its last pass over the whole trial.
std::vector<Unmodelled> EstimateUnmodelled(const ArmProblem& problem, State& state,
                                           ChainWorkspace& workspace);

}  // namespace brachium
