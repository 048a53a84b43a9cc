// Which joint goes where and when: the movements of each scenario.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "problems/simulation/scenario.h"

namespace brachium {

// All joints go to `target`, between `start` and `start + duration`. Time in s from the end of the
// rest at the start, before the options' time scale.
struct Movement {
  double start = 0.0;
  double duration = 0.0;
  JointValues target{};
  std::string label{};  // of an interval, with half of the rests at both ends
};

// The shortest time in which the scenario moves and comes home [s].
double ShortestPerformance(const ScenarioOptions& options);

// How many times slower than composed: the scenario's own slowness times the options'.
double TimeScale(const ScenarioOptions& options);

// The motion of each joint over the trial. Within a movement each joint starts and stops at moments
// of its own. Requires options.IsValid().
std::array<Motion, kJointCount> Perform(const ScenarioOptions& options);

// The intervals of the labelled movements. Requires options.IsValid().
std::vector<Interval> LabelledIntervals(const ScenarioOptions& options);

}  // namespace brachium
