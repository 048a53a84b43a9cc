// The joint angles that are told of an arm, by name: which segments they stand between, and how they
// are read (joint_angles.h).
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "problems/joint_angles.h"

namespace brachium {

struct ArmAngle {
  std::string name;                 // "elbow_flexion", ...
  std::optional<Segment> proximal;  // none: the world
  Segment distal;
  // From the distal segment's attitude in the proximal one [rad]; NaN where the angle is absent.
  std::function<double(const Eigen::Quaterniond& q_AB)> of;
};

// Of the segments whose attitudes are known. Without a thorax the shoulder has but its elevation.
std::vector<ArmAngle> ArmAngles(const std::set<Segment>& known, Side side);

using Attitudes = std::map<Segment, std::vector<Eigen::Quaterniond>>;  // all equally long

// One angle over time [rad]; NaN where an attitude is unknown or there is no such angle.
std::vector<double> SeriesOf(const ArmAngle& angle, const Attitudes& q_WB);

// All angles that the segments tell, by name.
std::map<std::string, std::vector<double>> JointAngleSeries(const Attitudes& q_WB, Side side);

}  // namespace brachium
