// About which clocks the samples of a trial are summed: those where they were found, as far as the
// movement tells them.
#pragma once

#include <vector>

#include "problems/arm_problem.h"
#include "solver/front_sweep.h"

namespace brachium {

// Samples are summed again at most so often.
inline constexpr int kMostSums = 4;

struct ClocksFound {
  std::vector<double> offsets;  // by sensor, to sum about: true time less its own [s]
  bool far = false;             // from what the samples are summed about, one of them
};

// The clocks of `state`, each where it lies near to what its samples are summed about, or else where
// the last pass of `workspace` knows it to a third of its prior; one that movement does not tell
// stays: in slow movement of sensors that are wrong otherwise it would run away.
ClocksFound FindClocks(const ArmProblem& problem, const State& state, ChainWorkspace& workspace);

}  // namespace brachium
