// Does time run as fast as it says?
#pragma once

#include <string>

#include "io/findings.h"
#include "problems/imu.h"

namespace brachium {

// Over a second of any movement the mean specific force points up but for a few degrees, because a
// velocity stays bounded. Carried by the gyroscope over the seconds that follow it must go on doing
// so; where a multiple of the rates keeps it upright much better, over short windows and over longer
// ones alike, time runs at that multiple, and this warns of it. Each sensor turns as its skin does
// and measures that, so that neither skin nor a missing rest disturbs. Silent on a sensor that turns
// too seldom, and where a machine swings it as no arm moves.
void CheckRate(const Recording& recording, const std::string& name, Findings* findings);

}  // namespace brachium
