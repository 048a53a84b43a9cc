// The shared form of residuals that are weighted sums of vectors: r = Σ w_i x_i - c.
#pragma once

#include <array>

#include "problems/residuals/cost.h"

namespace brachium {

template <int kSize, int kTerms>
class Linear {
 public:
  static constexpr int kResiduals = kSize;
  using Vector = Eigen::Matrix<double, kSize, 1>;

  Linear(const std::array<double, kTerms>& weights, const Vector& constant)
      : weights_(weights), constant_(constant) {}

  template <typename T>
  void operator()(const T* const* x, T* r) const {
    for (int row = 0; row < kSize; ++row) {
      r[row] = T(-constant_[row]);
      for (std::size_t i = 0; i < kTerms; ++i) r[row] += T(weights_[i]) * x[i][row];
    }
  }

  void Differentiate(const double* const*, double* const* J) const {
    for (std::size_t i = 0; i < kTerms; ++i)
      Eigen::Map<RowMajor<kSize, kSize>>(J[i]).setIdentity() *= weights_[i];
  }

 private:
  std::array<double, kTerms> weights_;
  Vector constant_;
};

}  // namespace brachium
