// Shoulder: the root joint wanders about a constant mean and returns to it (Ornstein-Uhlenbeck).
//
//   r_k = (p_k - m - ρ (p_k-1 - m)) / (σ sqrt(1 - ρ²)),   ρ = exp(-D/τ);   r_0 = (p_0 - m) / σ
//
// Frames    p_k: root joint in W [m]; m: its mean over the trial.
// Unknowns  p_k-1, p_k, m.
// Weight    σ [m] per axis: a few cm for a person who stays in place; τ [s]: about 10. A smoother
//           process of that τ would forbid the speeds of real shoulders; an independent σ at every
//           knot would make the answer depend on the knot spacing.
// Jacobian  -w ρ I, w I, -w (1 - ρ) I with w = 1/(σ sqrt(1 - ρ²)).
// Blind to  attitudes; the mean itself.
// Source    Zhou et al., Med. Eng. Phys. 30 (2008), name the moving shoulder as what a fixed base
//           gets wrong; process: Gardiner, Handbook of Stochastic Methods, section 3.8.4.
#pragma once

#include "problems/residuals/linear.h"
#include "problems/residuals/whitening.h"

namespace brachium {

class ShoulderProcess : public Linear<3, 3> {
 public:
  using Blocks = std::integer_sequence<int, 3, 3, 3>;  // p_k-1, p_k, m
  explicit ShoulderProcess(const FirstOrderStep& step)
      : Linear({-step.weight * step.rho, step.weight, -step.weight * (1 - step.rho)},
               Vector::Zero()) {}
};

class ShoulderProcessStart : public Linear<3, 2> {
 public:
  using Blocks = std::integer_sequence<int, 3, 3>;  // p_0, m
  explicit ShoulderProcessStart(double sigma) : Linear({1 / sigma, -1 / sigma}, Vector::Zero()) {}
};

}  // namespace brachium
