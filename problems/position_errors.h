// Errors of one point over time.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "problems/sampling.h"
#include "problems/statistics.h"

namespace brachium {

// [m]; a point whose x or y is NaN is left out.
struct PositionErrors {
  Statistics distance;                 // in space, or in the plane where no height is known
  Statistics horizontal;               // in the plane
  std::optional<Statistics> vertical;  // signed; absent where no height is known
  std::array<Statistics, 2> axis;      // along x and y of the reference's world, signed
};

// A column per instant.
PositionErrors PositionErrorsOf(const Eigen::Matrix3Xd& estimate,
                                const Eigen::Matrix3Xd& reference);

// The way along points picked about every 0.1 s, so that their noise adds little; gaps are left
// out. In space, or in the plane where no height is known [m].
double PathLength(const SampleTimes& times, const Eigen::Matrix3Xd& points);

}  // namespace brachium
