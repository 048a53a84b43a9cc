// Prior: what is known of a vector before any sample.
//
//   r = (x - x̄) / σ
//
// Used for turn-on biases, accelerometer bias and scale, carrying angle, the sensor's place on its
// segment, the first velocity, and the place of the root at the first knot (a gauge: σ tiny).
// Unknowns  x, of any unit. Weight σ in the same unit. Jacobian diag(1/σ).
#pragma once

#include "problems/residuals/cost.h"

namespace brachium {

template <int kSize>
class Prior {
 public:
  static constexpr int kResiduals = kSize;
  using Blocks = std::integer_sequence<int, kSize>;
  using Vector = Eigen::Matrix<double, kSize, 1>;

  Prior(const Vector& mean, const Vector& sigma) : mean_(mean), weight_(sigma.cwiseInverse()) {}

  template <typename T>
  void operator()(const T* const* x, T* r) const {
    for (int i = 0; i < kSize; ++i) r[i] = T(weight_[i]) * (x[0][i] - T(mean_[i]));
  }

  void Differentiate(const double* const*, double* const* J) const {
    Eigen::Map<RowMajor<kSize, kSize>>{J[0]} = weight_.asDiagonal();
  }

 private:
  Vector mean_;
  Vector weight_;
};

}  // namespace brachium
