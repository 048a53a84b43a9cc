// Where the sensors' clocks are: about which of them the samples of a trial are summed, and where
// they go in a long one.
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

// How fast each clock runs against the true time, by how far it went since it was first found. A
// crystal keeps its rate for hours, so this also tells where a clock is after a long rest.
class ClockRates {
 public:
  // The clocks as found at an instant, by sensor [s].
  void Add(double time, const std::vector<double>& offsets);

  // How far they go in so many seconds, by sensor [s].
  std::vector<double> Steps(double seconds) const;

 private:
  double since_ = 0.0;  // [s]
  std::vector<double> first_, rates_;
};

}  // namespace brachium
