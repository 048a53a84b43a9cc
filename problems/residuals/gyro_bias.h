// Gyro bias: turns on with an unknown value, walks slowly, and shows itself in rests.
//
//   walk   r = (b_j+1 - b_j) / (σ_w sqrt(T))
//   rest   r = sqrt(π) (mean rate - b) / sqrt(S_g/T + 2 σ_θ²/T²),   b = (1-α) b_j + α b_j+1
//
// Frames    sensor axes. T: time between the nodes, or length of the rest [s].
// Unknowns  b_j, b_j+1: gyro bias at two nodes [rad/s], linear between them.
// Weight    σ_w: in-run walk [rad/s/sqrt(s)]; S_g: white rate noise (two-sided) [rad²/s]; σ_θ: how far
//           the segment really turns to and fro in the rest [rad]: over T its two ends differ by
//           sqrt(2) σ_θ; π: the probability that the rest is one.
// Jacobian  ∓I / (σ_w sqrt(T)); -(1-α) w I, -α w I.
// Blind to  attitude. A turn of the sensor in the rest looks like bias, hence σ_θ.
// Source    random walk: IEEE Std 952-1997, Annex C.
#pragma once

#include <cmath>

#include "problems/residuals/linear.h"

namespace brachium {

class GyroBiasWalk : public Linear<3, 2> {
 public:
  using Blocks = std::integer_sequence<int, 3, 3>;  // b_j, b_j+1
  GyroBiasWalk(double walk, double duration)
      : Linear({-1 / (walk * std::sqrt(duration)), 1 / (walk * std::sqrt(duration))},
               Vector::Zero()) {}
};

class GyroBiasRest : public Linear<3, 2> {
 public:
  using Blocks = std::integer_sequence<int, 3, 3>;  // b_j, b_j+1
  // `mean_rate` over the rest [rad/s]; `sigma` of that mean as a measure of the bias [rad/s].
  GyroBiasRest(const Eigen::Vector3d& mean_rate, double alpha, double sigma, double probability)
      : GyroBiasRest(mean_rate, alpha, std::sqrt(probability) / sigma) {}

 private:
  GyroBiasRest(const Eigen::Vector3d& mean_rate, double alpha, double weight)
      : Linear({(1 - alpha) * weight, alpha * weight}, weight * mean_rate) {}
};

}  // namespace brachium
