// How a sensor sits on its segment, and how noisy it is: `mounting` and `noise` of trial.json.
#pragma once

#include "io/findings.h"
#include "io/json_input.h"
#include "problems/arm_model.h"
#include "problems/imu.h"

namespace brachium {

// A quaternion may be off the unit sphere by that much; it is normalised.
inline constexpr double kUnitNormTolerance = 1e-3;

// A unit quaternion, w first; one that is off by more than that fails.
Eigen::Quaterniond ParseRotation(const JsonNode& node);

// A mounting has its rotation; without a position the sensor is taken to lie half-way along the
// segment, known to 5 cm.
Mounting ParseMounting(const JsonNode& mounting, const SegmentGeometry& segment,
                       Findings* findings);

// The `noise` of a recording: a preset's name, or an object of one-sided densities and sigmas that
// starts from a preset. Absent: "mtw".
ImuNoise ParseNoise(const JsonNode& recording, Findings* findings);

}  // namespace brachium
