// From knots to sample times: the estimate as it leaves the smoother.
#pragma once

#include "problems/arm_problem.h"
#include "problems/estimate.h"

namespace brachium {

// Attitudes and joint positions at the first recording's sample times. Between knots the attitude
// follows the gyroscope, closed onto the next knot in proportion to time; the root follows a cubic.
// Samples outside the knots hold NaN.
void FillTrajectory(const ArmProblem& problem, const State& state, Estimate& estimate);

}  // namespace brachium
