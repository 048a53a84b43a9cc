// Errors of one rotation over time: the whole angle, inclination and heading apart.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "problems/statistics.h"

namespace brachium {

// A rotation split into a turn about an axis and the shortest turn that tilts it.
struct SwingTwist {
  Eigen::Vector3d swing;  // rotation vector, perpendicular to the axis [rad]
  double twist = 0.0;     // (-π, π] [rad]
};

// q = Exp(twist * axis) * Exp(swing), or in the other order with the swing turned: its length and
// the twist are the same in either.
SwingTwist SplitAbout(const Eigen::Quaterniond& q, const Eigen::Vector3d& axis);

// Errors of one rotation [rad], as rotation vectors in the frame of the body.
struct OrientationErrors {
  Statistics rotation;     // the whole angle; its correlation is that of the direction cosines
  Statistics inclination;  // between the vertical as the body has it and as the reference has it
  Statistics heading;      // what is left: the turn about the vertical, signed
  std::array<Statistics, 3> axis;  // components of the whole, signed
};

// Sample by sample; a NaN is a sample left out. `vertical` is the upward unit vector in the axes of
// the body, by the reference.
OrientationErrors OrientationErrorsOf(const std::vector<Eigen::Quaterniond>& estimate,
                                      const std::vector<Eigen::Quaterniond>& reference,
                                      const std::vector<Eigen::Vector3d>& vertical);

}  // namespace brachium
