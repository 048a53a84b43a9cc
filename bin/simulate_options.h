// From the flags of brachium simulate to the options of a scenario and of its errors.
#pragma once

#include "bin/simulate_flags.h"
#include "problems/simulation/simulate.h"

namespace brachium {

// Throw UsageError for what cannot be.
ScenarioOptions ScenarioFrom(const MovementFlags& flags, bool draw_errors);
SimulationOptions ErrorsFrom(const ErrorFlags& flags, int seed, const Scenario& scenario);

}  // namespace brachium
