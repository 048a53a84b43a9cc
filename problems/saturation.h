// Where a sensor was out of its range.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace brachium {

// Samples [first, last) whose component `axis` stays on the sensor's limit.
struct SaturatedRun {
  int axis = 0;
  std::size_t first = 0, last = 0;
};

// Three samples or more in a row on the largest size that the component has anywhere, to the step
// of a 16-bit converter. A component that never reaches `least` is not suspected: below the smallest
// range on sale, equal values in a row are a slow peak. In the order of axes, then of samples.
std::vector<SaturatedRun> FindSaturatedRuns(const std::vector<Eigen::Vector3d>& samples,
                                            double least);

inline constexpr double kSmallestGyroRange = 4.0;    // [rad/s]; 250 deg/s is 4.36
inline constexpr double kSmallestAccelRange = 14.7;  // [m/s^2], 1.5 g

// How far the signal lies beyond the limit during the run, as a standard deviation of its mean
// [unit of the samples]: a parabola that crosses the limit with slope s and comes back after T rises
// to s T/4 above it. The slope is the steepest of the two steps on either side of the run.
double HiddenExcess(const std::vector<double>& time, const std::vector<Eigen::Vector3d>& samples,
                    const SaturatedRun& run);

}  // namespace brachium
