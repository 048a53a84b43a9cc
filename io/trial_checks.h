// Mistakes that show only beside what trial.json says, or between the sensors of a trial.
#pragma once

#include "io/findings.h"
#include "problems/observations.h"

namespace brachium {

// Warns of a rest in which a sensor moves, of a maker's orientation that does not hold gravity
// upright (inverted, w last, z down), of gravity of another size, of an arm that hangs upward in the
// told start pose, of a forearm that turns as the other side's would, and of what CheckElbow and
// CheckSlip find.
void CheckTrial(const Observations& observations, Findings* findings);

}  // namespace brachium
