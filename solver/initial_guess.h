// Where the search starts: attitudes from gravity and the start pose, knots from dead reckoning.
#pragma once

#include "problems/arm_problem.h"

namespace brachium {

// Attitudes at the first knot: inclination from the first seconds of specific force, the first
// segment's heading zero, the forearm's from the start pose where it was told, all others zero.
void SetFirstKnot(const ArmProblem& problem, State& state);

// Turns a segment at the first knot about the vertical [rad].
void TurnFirstKnot(State& state, int sensor, double heading);

// Knots after `from` up to `to`: attitudes and velocities dead reckoned with the biases of the
// state, the root held where it was.
void DeadReckon(const ArmProblem& problem, State& state, int from, int to);

// Carries the bias at a node to all later ones.
void HoldBias(const ArmProblem& problem, State& state, int node);

}  // namespace brachium
