// A sensor that comes loose in mid-trial.
#pragma once

#include "io/findings.h"
#include "problems/observations.h"

namespace brachium {

// Both sensors beside the elbow tell the length of the specific force that it feels (elbow_check.h).
// From where each would have to sit for them to agree, one place before an instant and one after
// explain the trial much better than one place throughout: then a sensor slipped there, and this
// warns of it. It sees what moves the elbow in the sensor's axes by centimetres: a sensor that tilts,
// or slides along the limb. One that turns about the line to the elbow shows nothing. Silent where a
// mounting is missing and where the arm moves too little.
void CheckSlip(const Observations& observations, Findings* findings);

}  // namespace brachium
