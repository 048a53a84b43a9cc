// Two sensors beside one joint: what they say of it must agree.
#pragma once

#include <string>

#include "io/findings.h"
#include "problems/observations.h"

namespace brachium {

// The specific force at the elbow, carried there from the upper arm's sensor and from the forearm's,
//   |f_S + dω_S/dt x r_S + ω_S x (ω_S x r_S)|,   r_S from the sensor to the elbow,
// is one and the same length, whatever the orientations; and attitudes that the gyroscopes carry and
// the accelerometers level leave the elbow's carrying angle where it is (elbow_hinge.h). Where these
// two together hold much better with the recordings exchanged, an accelerometer turned round, or one
// clock shifted, warns of that and returns true. Brisk movement shows in the forces. What skin does
// to them outweighs a slow arm, but it turns a sensor by a few degrees only, and the hinge tells.
// Silent where a mounting is missing or the arm hardly moves. Source of the first relation: Seel,
// Raisch & Schauer, Sensors 14 (2014), eq. 9.
bool CheckElbow(const Observations& observations, Findings* findings);

}  // namespace brachium
