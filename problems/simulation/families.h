// The movements of all scenarios, one file per family. Each is composed for a right arm, in the
// movements' own time; what is drawn comes from `draws` alone.
#pragma once

#include "problems/simulation/movement.h"

namespace brachium {

// everyday.cc: as long as the task asks.
Choreography Daily(const Task& task, Draws& draws);
Choreography Reach(const Task& task, Draws& draws);
Choreography Shrug(const Task& task, Draws& draws);
Choreography ForearmRotation(const Task& task, Draws& draws);

// calibration_movements.cc
Choreography CalibrationMovements(const Task& task, Draws& draws);
Choreography ShoulderStill(const Task& task, Draws& draws);
Choreography StaticPose(const Task& task, Draws& draws);

// routines.cc
Choreography Eating(const Task& task, Draws& draws);
Choreography Morning(const Task& task, Draws& draws);

// designed_paths.cc: as long as the task asks.
Choreography Circle(const Task& task, Draws& draws);
Choreography Rectangle(const Task& task, Draws& draws);

// goniometer.cc
Choreography GoniometerSteps(const Task& task, Draws& draws);
Choreography GoniometerSwing(const Task& task, Draws& draws);

// peg_test.cc
Choreography PegTest(const Task& task, Draws& draws);

// range_of_motion.cc
Choreography RangeOfMotion(const Task& task, Draws& draws);

}  // namespace brachium
