// Zero velocity: in a rest the sensor stays where it is, but for a slow sway.
//
//   r_k = sqrt(π) (v_k - ρ v_k-1) / (σ sqrt(1 - ρ²)),   ρ = exp(-D/τ);   r_first = sqrt(π) v / σ
//
// Frames    v: velocity of the sensor in W [m/s].
// Unknowns  v_k-1, v_k.
// Weight    σ 5 mm/s and τ 0.5 s: what breathing and tremor leave of a rest; π: the probability that
//           the rest is one (stillness.h).
// Jacobian  -w ρ I, w I with w = sqrt(π) / (σ sqrt(1 - ρ²)).
// Blind to  attitude and place. No residual for gravity stands beside it: with v = 0 gravity follows
//           from the accelerometer, and a second use of the same samples would count them twice.
// Source    zero-velocity updates as a residual instead of a reset: Bai et al., IEEE TNSRE 23 (2015),
//           section II-D, reset the velocity between movements.
#pragma once

#include <cmath>

#include "problems/residuals/linear.h"
#include "problems/residuals/whitening.h"

namespace brachium {

class ZeroVelocity : public Linear<3, 2> {
 public:
  using Blocks = std::integer_sequence<int, 3, 3>;  // v_k-1, v_k
  ZeroVelocity(const FirstOrderStep& step, double probability)
      : Linear({-std::sqrt(probability) * step.weight * step.rho,
                std::sqrt(probability) * step.weight},
               Vector::Zero()) {}
};

class ZeroVelocityStart : public Linear<3, 1> {
 public:
  using Blocks = std::integer_sequence<int, 3>;
  ZeroVelocityStart(double sigma, double probability)
      : Linear({std::sqrt(probability) / sigma}, Vector::Zero()) {}
};

}  // namespace brachium
