// How much the model leaves out of the sensors' motion, by the residuals of a solved trial.
//
// A weighted residual r whose assumed variance is right has E|r|² = rows - tr(J Σ Jᵀ): the unknowns,
// of covariance Σ, take up the rest. Of each sensor and kind the sums over the trial give
//   σ̂²/σ² = (Σ|r|² + n) / (Σ rows - tr(J Σ Jᵀ) + n),
// n residuals of the first guess being thrown in, which a short or poorly linked trial keeps. The
// trace comes from a few deviations ξ of covariance Σ, drawn with a fixed seed: E|J ξ|² is it.
// Source: variance components, Förstner (1979); trace by random signs, Hutchinson (1989).
#pragma once

#include <random>
#include <vector>

#include "problems/arm_problem.h"
#include "solver/front_sweep.h"

namespace brachium {

class UnmodelledSums {
 public:
  // The first guess is what `problem` goes by.
  explicit UnmodelledSums(const ArmProblem& problem);

  // Takes the terms whose first knot lies in [start_knot, end_knot) at the values to which the plan of
  // `workspace` points, whose last pass was over them. The problem may be another one, with other
  // guesses, of the same sensors.
  void Add(const ArmProblem& problem, int start_knot, int end_knot, ChainWorkspace& workspace);

  // Of each sensor, by all terms that were taken.
  std::vector<Unmodelled> Estimate() const;

 private:
  // Of one kind: residuals unweighted again, their squares summed, and how many of them the unknowns
  // do not take up; their variance.
  struct Spread {
    double squares = 0.0, redundancy = 0.0;
    double Variance() const;
  };

  // White density of an accelerometer, and what goes for it where something lasting is left out.
  struct Densities {
    explicit Densities(const ArmProblem& problem);
    double Of(std::size_t sensor, double acceleration) const;
    double AccelerationOf(std::size_t sensor, double density) const;
    double memory;
    std::vector<double> white;
  };

  Densities densities_;
  int draws_;
  std::mt19937_64 random_{1};
  std::vector<Spread> accelerations_, quivers_;  // by sensor
};

}  // namespace brachium
