// Smooth motion in closed form, to be sampled at any time.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstddef>
#include <vector>

namespace brachium {

// Turns about all axes by up to a radian or two at up to about 3 rad/s.
inline Eigen::Quaterniond SmoothRotation(double t, double phase = 0.0) {
  return Eigen::AngleAxisd(1.2 * std::sin(0.9 * t + phase), Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(0.8 * std::sin(1.7 * t + 2.0 * phase + 0.4), Eigen::Vector3d::UnitX()) *
         Eigen::AngleAxisd(0.9 * std::sin(2.3 * t - phase + 1.1), Eigen::Vector3d::UnitY());
}

// A walk of about 0.4 m/s in the plane, with some height [m].
inline Eigen::Vector3d SmoothPoint(double t) {
  return {0.4 * t + 0.3 * std::sin(1.3 * t), 0.5 * std::cos(0.7 * t), 0.1 * std::sin(2.0 * t)};
}

inline std::vector<double> EvenTimes(double start, double step, std::size_t n) {
  std::vector<double> times(n);
  for (std::size_t i = 0; i < n; ++i) times[i] = start + step * static_cast<double>(i);
  return times;
}

// f(t) at each time.
template <typename Function>
auto Sampled(const std::vector<double>& times, const Function& f) {
  std::vector<decltype(f(0.0))> values;
  for (const double t : times) values.push_back(f(t));
  return values;
}

}  // namespace brachium
