// Which joint angles bring the wrist, or the fingertip, to a place.
#pragma once

#include "problems/simulation/arm_chain.h"

namespace brachium {

// Sets shoulder and elbow flexion so that the wrist is at `wrist_T`, from the shoulder, in trunk
// axes, and the elbow on that side of the line to it on which the direction `elbow_T` points. Reads
// the elbow's adduction. In closed form but for the elbow, whose carrying angle varies with its
// flexion; derivatives are as exact as the values. Throws std::domain_error where the wrist is out
// of reach or `elbow_T` points along the line.
void BringWristTo(const MovingPoint& wrist_T, const MovingPoint& elbow_T, const ArmShape& shape,
                  MovingJoints& joints);

// Where a hand shall be.
struct HandPlace {
  enum class Part { kWrist, kFingertip };
  Part part = Part::kWrist;
  Eigen::Vector3d p_T;      // in the upright trunk's axes from the shoulder's mean place [m]
  Eigen::Vector3d elbow_T;  // direction in which the elbow is kept
};

// The same for a still arm, whatever trunk, shoulder, forearm and wrist do.
void BringHandTo(const HandPlace& place, const ArmShape& shape, JointValues& joints);

}  // namespace brachium
