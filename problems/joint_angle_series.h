// The clinical joint angles over time.
#pragma once

#include <Eigen/Geometry>
#include <map>
#include <string>
#include <vector>

#include "problems/segment.h"

namespace brachium {

// By name, as many as the segments tell: "elbow_flexion", "elbow_carrying", "forearm_pronation",
// "shoulder_elevation" (from the thorax, or from the vertical without one), "shoulder_plane",
// "shoulder_rotation", "wrist_flexion", "wrist_deviation" [rad]; NaN where an attitude is unknown or
// there is no such angle. The series of all segments are equally long.
std::map<std::string, std::vector<double>> JointAngleSeries(
    const std::map<Segment, std::vector<Eigen::Quaterniond>>& q_WB, Side side);

}  // namespace brachium
