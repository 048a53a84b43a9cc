// Which way is up in the sensor of an arm that hangs.
#pragma once

#include <optional>

#include "problems/observations.h"

namespace brachium {

// The mean direction of specific force, sensor axes, in the calibration:static_pose intervals, else in
// the half second about a told start pose of a hanging arm (elevation and flexion below 45 deg).
// Absent without either, and where the recording has no sample then.
std::optional<Eigen::Vector3d> UpOfTheHangingArm(const Recording& recording,
                                                 const Observations& observations);

}  // namespace brachium
