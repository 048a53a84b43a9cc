// The mirror image of a trial: a left arm from a right arm, and back.
//
// Body and sensor axes are mirrored in z, the world in its x-z plane (y -> -y), so "up" stays.
// Polar vectors: (x, y, -z), in the world (x, -y, z). Angular rates: (-x, -y, z). Inner rotations:
// (w, -x, -y, z); rotations to the world: Rx(180 deg) of that, (x, w, -z, -y).
#pragma once

#include "problems/simulation/scenario.h"
#include "problems/trial.h"

namespace brachium {

ArmMotion Mirrored(const ArmMotion& arm);
Mounting Mirrored(const Mounting& mounting);

// Swaps the side. Recordings that carry a magnetometer or a fused orientation lose both.
Trial Mirrored(const Trial& trial);

inline Eigen::Vector3d MirroredPolar(const Eigen::Vector3d& v_B) {
  return {v_B.x(), v_B.y(), -v_B.z()};
}
inline Eigen::Vector3d MirroredAxial(const Eigen::Vector3d& v_B) {
  return {-v_B.x(), -v_B.y(), v_B.z()};
}

}  // namespace brachium
