#include "solver/term_square.h"

#include <algorithm>
#include <cmath>

#include "solver/front_factor.h"

namespace brachium {
namespace {

std::size_t U(int i) { return static_cast<std::size_t>(i); }

template <int kColumns>
void CopyRows(const double* from, int rows, int stride, double* to) {
  for (int row = 0; row < rows; ++row, from += kColumns, to += stride)
    for (int i = 0; i < kColumns; ++i) to[i] = from[i];
}

// A row-major block of 1 to 3 columns into rows of `stride` numbers.
void CopyBlock(const double* from, int columns, int rows, int stride, double* to) {
  switch (columns) {
    case 3:
      return CopyRows<3>(from, rows, stride, to);
    case 2:
      return CopyRows<2>(from, rows, stride, to);
    default:
      return CopyRows<1>(from, rows, stride, to);
  }
}

}  // namespace

void TermSquare::Reserve(int residuals, int blocks, int columns) {
  const int stride = Padded(columns + 1);
  values_.resize(U(blocks));
  jacobians_.resize(U(blocks));
  residual_.resize(U(residuals));
  blocks_.resize(U(residuals * columns));
  rows_.resize(U(residuals * stride));
  square_.resize(U(stride * stride));
  place_in_front_.resize(U(columns));
  run_end_.resize(U(columns));
}

double TermSquare::Linearise(const TangentCost& cost, const ceres::LossFunction* loss,
                             std::span<const TermBlock> blocks, int columns) {
  const int residuals = cost.num_residuals();
  double* jacobian = blocks_.data();
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    values_[i] = blocks[i].value;
    jacobians_[i] = jacobian;
    jacobian += residuals * blocks[i].tangent;
  }
  cost.EvaluateTangent(values_.data(), residual_.data(), jacobians_.data());

  const int stride = stride_ = Padded(columns + 1);
  double squares = 0.0;
  for (int row = 0; row < residuals; ++row) {
    const double r = residual_[U(row)];
    double* to = &rows_[U(row * stride)];
    to[columns] = r;
    for (int i = columns + 1; i < stride; ++i) to[i] = 0.0;
    squares += r * r;
  }
  int* place_in_front = place_in_front_.data();
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const TermBlock& block = blocks[i];
    if (block.place < 0) continue;
    CopyBlock(jacobians_[i], block.tangent, residuals, stride, &rows_[U(block.place)]);
    for (int k = 0; k < block.tangent; ++k) place_in_front[block.place + k] = block.column + k;
  }
  for (int column = columns - 1; column >= 0; --column) {
    const bool ends =
        column + 1 == columns || place_in_front[column + 1] != place_in_front[column] + 1;
    run_end_[U(column)] = ends ? column + 1 : run_end_[U(column + 1)];
  }
  if (loss != nullptr) {
    double rho[3];
    loss->Evaluate(squares, rho);
    squares = rho[0];
    const double weight = std::sqrt(rho[1]);
    for (int i = 0; i < residuals * stride; ++i) rows_[U(i)] *= weight;
  }
  SquareColumns(rows_.data(), residuals, columns + 1, square_.data());
  return 0.5 * squares;
}

}  // namespace brachium
