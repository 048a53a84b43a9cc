// What a solved trial has to report about itself.
#pragma once

#include "problems/arm_problem.h"
#include "problems/estimate.h"
#include "solver/covariance.h"

namespace brachium {

// Whitened residuals by kind and sensor at `state`.
std::vector<ResidualStatistics> DescribeResiduals(const ArmProblem& problem, State& state);

// The constants of the trial, with their standard deviations where `certainty` has them.
std::vector<Constant> DescribeConstants(const ArmProblem& problem, const State& state,
                                        const Certainty& certainty);

// Unknowns about which the samples said next to nothing: their standard deviation is still that of
// their prior. One sentence each, with segment and time span.
std::vector<std::string> HeldByPrior(const ArmProblem& problem, const Certainty& certainty);

// Of these the constants that `certainty` has, of a trial from `start` to `end` [s].
std::vector<std::string> ConstantsHeldByPrior(const ArmProblem& problem, const Certainty& certainty,
                                              double start, double end);

// Constants that the samples moved far away from what was told or assumed, one sentence each: a wrong
// number in the trial, or a model that does not hold.
std::vector<std::string> FarFromTold(const ArmProblem& problem, const State& state);

std::vector<Rest> DescribeRests(const ArmProblem& problem);

}  // namespace brachium
