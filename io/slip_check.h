// A sensor that comes loose in mid-trial.
#pragma once

#include "io/findings.h"
#include "problems/observations.h"

namespace brachium {

// Both sensors beside the elbow tell the length of the specific force that it feels, and how steady
// its carrying angle is (elbow_check.h). Where one place of a sensor before an instant and one after
// explain the trial much better than one place throughout, it slipped there, and this warns of it
// (slips.h). Turning about the forearm's long axis shows nothing. Silent where a mounting is missing
// and where the arm moves too little.
void CheckSlip(const Observations& observations, Findings* findings);

}  // namespace brachium
