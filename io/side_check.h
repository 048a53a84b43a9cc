// Is it the arm that it is told to be?
#pragma once

#include "io/findings.h"
#include "problems/observations.h"

namespace brachium {

// Where upper arm and forearm feel gravity alone, it stands as u in the axes of the one and as f in
// those of the other, and a bent elbow shows how far the forearm is pronated: with flexion a and, on
// the right, pronation c, f = R_y(-c) R_z(-a) u. On the left c is the other way round, so that a
// forearm which can only be between palm up and palm down tells the two arms apart. Warns where it is
// turned as no forearm of the told side can be. Silent where a mounting is missing, and where both
// segments hardly ever feel gravity alone with the elbow bent: instants at which two flexions fit, or
// at which the elbow bends about the vertical, do not count.
void CheckSide(const Observations& observations, Findings* findings);

}  // namespace brachium
