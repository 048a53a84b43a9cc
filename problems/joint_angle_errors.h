// Errors of the clinical joint angles.
#pragma once

#include <map>
#include <string>

#include "problems/alignment.h"
#include "problems/segment.h"
#include "problems/statistics.h"

namespace brachium {

// By name, as many as the segments tell: "elbow_flexion", "elbow_carrying", "forearm_pronation",
// "shoulder_elevation" (from the thorax, or from the vertical without one), "shoulder_plane",
// "shoulder_rotation", "wrist_flexion", "wrist_deviation" [rad]. The shortest way round the circle;
// an instant at which either has no such angle is left out. Needs the segments' own frames.
std::map<std::string, Statistics> JointAngleErrors(const std::map<Segment, RotationPairs>& segments,
                                                   Side side);

}  // namespace brachium
