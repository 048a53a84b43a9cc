#include "solver/term_square.h"

#include <cmath>

namespace brachium {
namespace {

std::size_t U(int i) { return static_cast<std::size_t>(i); }

template <int kColumns>
void CopyRows(const double* from, int rows, double weight, double* to) {
  for (int row = 0; row < rows; ++row, from += kColumns, to += kLane) {
    for (int i = 0; i < kColumns; ++i) to[i] = weight * from[i];
    for (int i = kColumns; i < kLane; ++i) to[i] = 0.0;
  }
}

// A row-major block of 1 to 3 columns into rows of kLane numbers.
void CopyBlock(const double* from, int columns, int rows, double weight, double* to) {
  switch (columns) {
    case 3:
      return CopyRows<3>(from, rows, weight, to);
    case 2:
      return CopyRows<2>(from, rows, weight, to);
    default:
      return CopyRows<1>(from, rows, weight, to);
  }
}

}  // namespace

void TermSquare::Reserve(int residuals, int blocks, int columns) {
  values_.resize(U(blocks));
  jacobians_.resize(U(blocks));
  residual_.resize(U(residuals));
  blocks_.resize(U(residuals * columns));
  rows_.resize(U(residuals * (blocks + 1) * kLane));
  in_front_.resize(U(blocks));
  squares_.resize(U(blocks * kLane));
  gradient_.resize(U(blocks * kLane));
}

double TermSquare::LineariseAtValues(const TangentCost& cost, const ceres::LossFunction* loss,
                                     std::span<const TermBlock> blocks) {
  residuals_ = cost.num_residuals();
  double* jacobian = blocks_.data();
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    jacobians_[i] = jacobian;
    jacobian += residuals_ * blocks[i].tangent;
  }
  cost.EvaluateTangent(values_.data(), residual_.data(), jacobians_.data());

  double rho[3] = {0.0, 1.0, 0.0};
  for (int row = 0; row < residuals_; ++row) rho[0] += residual_[U(row)] * residual_[U(row)];
  if (loss != nullptr) loss->Evaluate(rho[0], rho);
  const double weight = std::sqrt(rho[1]);
  int unknowns = 0;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const TermBlock& block = blocks[i];
    if (block.place < 0) continue;
    CopyBlock(jacobians_[i], block.tangent, residuals_, weight,
              &rows_[U(block.place * residuals_ * kLane)]);
    ++unknowns;
  }
  CopyBlock(residual_.data(), 1, residuals_, weight, &rows_[U(unknowns * residuals_ * kLane)]);
  return 0.5 * rho[0];
}

}  // namespace brachium
