// Faster steps where Gauss-Newton's creep: large residuals, such as skin moving under sensors, bend
// the cost by more or less than JᵀJ says, and steps overshoot or fall short by the same share again
// and again. What the last steps did to the next ones tells by how much. With f the Gauss-Newton
// steps, Δx what was gone and Δf, Δg the changes of the steps and gradients that came of it,
//   step = f - (ΔX + ΔF) γ,   γ = argmin |f - ΔF γ|²_H,
// in the metric H of the standard deviations, where H f = -g makes the sums inner products of Δf, g.
// Source: Anderson, J. ACM 12 (1965); Walker & Ni, SIAM J. Numer. Anal. 49 (2011), Eq. (2.1).
#pragma once

#include <deque>
#include <vector>

namespace brachium {

class StepMemory {
 public:
  // The Gauss-Newton step from here and the gradient here, all columns; `length_2` the step's
  // squared length in standard deviations.
  void Stand(const std::vector<double>& step, const std::vector<double>& gradient, double length_2);

  // What was gone from where it stood last.
  void Go(const std::vector<double>& step, double share);

  // The step from what is remembered; false where nothing is.
  bool Mix(std::vector<double>& mixed) const;

  void Forget() { moves_.clear(); }

 private:
  // What was gone, and how the Gauss-Newton step and the gradient changed by it.
  struct Move {
    std::vector<double> x, f, g;
  };

  std::vector<double> gone_, step_, gradient_;
  double length_2_ = 0.0;
  std::deque<Move> moves_;
};

}  // namespace brachium
