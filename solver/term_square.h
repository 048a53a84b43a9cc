// One term linearised and squared: what it adds to the information and to the gradient.
#pragma once

#include <ceres/loss_function.h>

#include <span>
#include <vector>

#include "problems/residuals/cost.h"
#include "solver/front_factor.h"

namespace brachium {

// One block of a term, in the cost's order.
struct TermBlock {
  int variable;  // of a plan (front_plan.h)
  int tangent;   // columns of its Jacobian
  int place;     // among the term's unknowns in the front's order; -1 for a block that is none
  int column;    // in a front
};

class TermSquare {
 public:
  // Sets memory up for the largest term to come: its residuals, its blocks, their columns.
  void Reserve(int residuals, int blocks, int columns);

  // J and r at the blocks' values, scaled by √ρ' where there is a loss; returns ½ ρ(|r|²). `value`: from
  // a variable's number to where its value stands.
  template <typename Value>
  double Linearise(const TangentCost& cost, const ceres::LossFunction* loss,
                   std::span<const TermBlock> blocks, Value value) {
    for (std::size_t i = 0; i < blocks.size(); ++i) values_[i] = value(blocks[i].variable);
    return LineariseAtValues(cost, loss, blocks);
  }

  // Adds [J r]ᵀ [J r] to a front of that stride; `column`: from a column's number to where it stands.
  template <typename Column>
  void AddTo(std::span<const TermBlock> blocks, Column column, int gradient_row, int stride) {
    int unknowns = 0;
    for (const TermBlock& block : blocks) {
      if (block.place < 0) continue;
      in_front_[static_cast<std::size_t>(block.place)] = {block.tangent, block.column,
                                                          column(block.column)};
      ++unknowns;
    }
    AddSquare(rows_.data(), residuals_, {in_front_.data(), static_cast<std::size_t>(unknowns)},
              gradient_row, stride, squares_.data(), gradient_.data());
  }

  // Of column k of an unknown, after AddTo: its entries of JᵀJ's diagonal and of Jᵀr.
  double Diagonal(const TermBlock& block, int k) const { return squares_[At(block, k)]; }
  double Gradient(const TermBlock& block, int k) const { return gradient_[At(block, k)]; }

 private:
  double LineariseAtValues(const TangentCost& cost, const ceres::LossFunction* loss,
                           std::span<const TermBlock> blocks);
  static std::size_t At(const TermBlock& block, int k) {
    return static_cast<std::size_t>(block.place * kLane + k);
  }

  int residuals_ = 0;  // of the term that stands
  std::vector<const double*> values_;
  std::vector<double*> jacobians_;
  std::vector<double> residual_, blocks_;  // as the cost writes them
  std::vector<double> rows_;               // as AddSquare reads them
  std::vector<FrontBlock> in_front_;
  std::vector<double> squares_, gradient_;
};

}  // namespace brachium
