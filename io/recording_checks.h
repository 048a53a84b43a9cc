// Mistakes that the numbers of a recording give away: a wrong unit, swapped columns, a turned sign.
#pragma once

#include <string>

#include "io/findings.h"
#include "problems/imu.h"

namespace brachium {

// How far gravity, as the accelerometer sees it, seems to turn in the world over half a second when
// `gyro_scale` times the gyroscope carries it: the median over up to 400 windows whose ends show
// nothing but gravity [rad]. Small for a healthy recording with scale 1. Zero without such windows.
double GravityMismatch(const Recording& recording, double gyro_scale);

// Throws InputError (under `file`) where nothing sensible can follow; warns (under `name`) of what
// only looks wrong.
void CheckSensorUnits(const Recording& recording, const std::string& file, const std::string& name,
                      Findings* findings);

}  // namespace brachium
