// Sums of whitened residuals, over as many stretches of a trial as there are.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "problems/arm_problem.h"
#include "problems/estimate.h"

namespace brachium {

class ResidualSums {
 public:
  // Adds the terms whose first knot lies in [start_knot, end_knot), at `state`.
  void Add(const ArmProblem& problem, State& state, int start_knot, int end_knot);

  void Add(const ResidualSums& others);

  // By kind and sensor.
  std::vector<ResidualStatistics> Statistics() const;

 private:
  struct Sum {
    std::string name;
    std::size_t count = 0;
    double squares = 0.0;
  };
  std::map<std::pair<ResidualKind, int>, Sum> sums_;
};

// Rms of the whitened residuals over their degrees of freedom: 1 where the model is right,
// or where there are no more of them than unknowns.
double ResidualScale(const std::vector<ResidualStatistics>& residuals, double unknowns);

}  // namespace brachium
