// What a movement does not repeat: where the shoulder is, how the elbow gives, where a joint ends.
#pragma once

#include "problems/simulation/movement.h"
#include "problems/simulation/scenario.h"

namespace brachium {

// Adds to each movement, and to the pose it all starts from, a wandering of the elbow's adduction
// and of the shoulder. Requires both rms to be >= 0.
void AddWander(const ScenarioOptions& options, double adduction_rms, double shoulder_rms,
               JointValues& start, std::vector<Movement>& movements);

// How the shoulder moves, told as a process of that rms: an AR(1) sequence over movements that take
// `mean_step` seconds each.
ShoulderModel ShoulderProcess(double shoulder_rms, double mean_step);

// Lets each movement but the last, which goes home, end elsewhere than it should, within the joints'
// limits. A hand's place is met all the same.
void AddExecutionErrors(const ScenarioOptions& options, std::vector<Movement>& movements);

}  // namespace brachium
