// When a sensor beside the elbow may have slipped, and what speaks for it.
#pragma once

#include <string>
#include <vector>

#include "io/elbow_sensors.h"
#include "problems/arm_model.h"

namespace brachium {

inline constexpr double kLeastPart = 8.0;  // of a trial before and after a slip [s]

struct SlipEvidence {
  double time = 0.0;    // [s]
  double share = 0.0;   // of the squares that one place leaves, explained by two
  std::string sensor;   // the one of which two places explain more
  double change = 0.0;  // between its two places: of the elbow in its axes [m]; or its turn [rad]
};

// Of the specific force at the elbow, which both sensors tell (elbow_check.h), for every second:
// what moves the elbow in a sensor's axes, which is a tilt or a slide along the limb.
std::vector<SlipEvidence> SlipsByForce(const ElbowSensors& sensors);

// Of the carrying angle (elbow_hinge.h), for every third second: turns about any axis but, of the
// forearm, the long one. Empty where the elbow is no hinge.
std::vector<SlipEvidence> SlipsByHinge(const ElbowSensors& sensors, const ArmModel& arm);

}  // namespace brachium
