// Which joint goes where and when: the movements of each scenario.
#pragma once

#include <array>
#include <vector>

#include "problems/simulation/scenario.h"

namespace brachium {

// All joints go to `target`, between `start` and `start + duration`. Time in s from the end of the
// rest at the start, before the options' time scale.
struct Movement {
  double start = 0.0;
  double duration = 0.0;
  JointValues target{};
};

// The shortest time in which every scenario moves and comes home [s].
inline constexpr double kShortestPerformance = 10.0;

// How many times slower than composed: the scenario's own slowness times the options'.
double TimeScale(const ScenarioOptions& options);

// The motion of each joint over the trial. Within a movement each joint starts and stops at moments
// of its own. Requires options.IsValid().
std::array<Motion, kJointCount> Perform(const ScenarioOptions& options);

}  // namespace brachium
