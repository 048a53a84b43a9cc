// One term linearised and squared: what it adds to the information and to the gradient.
#pragma once

#include <ceres/loss_function.h>

#include <span>
#include <vector>

#include "problems/residuals/cost.h"

namespace brachium {

// One block of a term, in the cost's order.
struct TermBlock {
  const double* value;
  int variable;  // of a plan (front_plan.h)
  int tangent;   // columns of its Jacobian
  int place;     // of these in the term's Jacobian; -1 for a block that is no unknown
  int column;    // of these in a front
};

class TermSquare {
 public:
  // Sets memory up for the largest term to come: its residuals, its blocks, their columns.
  void Reserve(int residuals, int blocks, int columns);

  // [J r]ᵀ [J r] at the blocks' values, scaled by ρ' where there is a loss; returns ½ ρ(|r|²).
  // `columns`: of J, all places together.
  double Linearise(const TangentCost& cost, const ceres::LossFunction* loss,
                   std::span<const TermBlock> blocks, int columns);

  // Column `column` of the square's lower triangle, by rows; the last row and column are r's.
  const double* Column(int column) const {
    return &square_[static_cast<std::size_t>(column * stride_)];
  }

  // The column of the front of every column of J.
  const int* PlacesInFront() const { return place_in_front_.data(); }

  // Of every column of J, the end of the columns from it on that are neighbours in the front too.
  const int* RunEnds() const { return run_end_.data(); }

 private:
  int stride_ = 0;
  std::vector<const double*> values_;
  std::vector<double*> jacobians_;
  std::vector<double> residual_, blocks_;  // as the cost writes them
  std::vector<double> rows_, square_;      // side by side, and squared
  std::vector<int> place_in_front_, run_end_;
};

}  // namespace brachium
