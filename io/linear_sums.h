// A linear least-squares problem, gathered sample by sample.
#pragma once

#include <Eigen/Dense>

namespace brachium {

// Sums of a linear least-squares problem: matrix, vector, squares.
template <int kSize>
struct Sums {
  Eigen::Matrix<double, kSize, kSize> A = Eigen::Matrix<double, kSize, kSize>::Zero();
  Eigen::Matrix<double, kSize, 1> b = Eigen::Matrix<double, kSize, 1>::Zero();
  double squares = 0.0;

  void Add(const Eigen::Matrix<double, kSize, 1>& gradient, double residual) {
    A += gradient * gradient.transpose();
    b -= gradient * residual;
    squares += residual * residual;
  }
  Sums& operator+=(const Sums& other) {
    A += other.A;
    b += other.b;
    squares += other.squares;
    return *this;
  }
  Sums Minus(const Sums& other) const {
    Sums rest = *this;
    rest.A -= other.A;
    rest.b -= other.b;
    rest.squares -= other.squares;
    return rest;
  }
  // The unknowns that explain most, beside a prior of zero with this information.
  Eigen::Matrix<double, kSize, 1> Solve(const Eigen::Matrix<double, kSize, 1>& prior) const {
    Eigen::Matrix<double, kSize, kSize> H = A;
    H.diagonal() += prior;
    return H.ldlt().solve(b);
  }
};

}  // namespace brachium
