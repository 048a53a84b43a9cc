// Weights apart from equations: square roots of inverse covariances.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cmath>

namespace brachium {

// W = L⁻¹ with C = L Lᵀ the covariance of (dv, dp) on one axis; the same for all three axes.
struct Whitening2 {
  double vv = 1.0, pv = 0.0, pp = 1.0;  // W = [vv 0; pv pp]

  static Whitening2 FromCovariance(const Eigen::Matrix2d& C) {
    const Eigen::Matrix2d L = C.llt().matrixL();
    return {1 / L(0, 0), -L(1, 0) / (L(0, 0) * L(1, 1)), 1 / L(1, 1)};
  }

  template <typename T, typename Vector>
  void Apply(const Vector& r_v, const Vector& r_p, T* r) const {
    for (int i = 0; i < 3; ++i) {
      r[i] = T(vv) * r_v[i];
      r[3 + i] = T(pv) * r_v[i] + T(pp) * r_p[i];
    }
  }
};

// Covariance of (dv, dp) after a duration D of white acceleration of two-sided density S [m²/s³].
inline Eigen::Matrix2d WhiteAccelerationCovariance(double S, double D) {
  Eigen::Matrix2d C;
  C << D, D * D / 2, D * D / 2, D * D * D / 3;
  return S * C;
}

// A first-order process of standard deviation σ and correlation time τ, seen over a step D:
// e_k - ρ e_k-1 has standard deviation σ sqrt(1 - ρ²), ρ = exp(-D/τ), whatever D is.
struct FirstOrderStep {
  double rho = 0.0;
  double weight = 1.0;  // 1 / (σ sqrt(1 - ρ²))

  static FirstOrderStep Over(double duration, double sigma, double correlation_time) {
    return {std::exp(-duration / correlation_time),
            1.0 / (sigma * std::sqrt(-std::expm1(-2 * duration / correlation_time)))};
  }
  static FirstOrderStep Start(double sigma) { return {0.0, 1.0 / sigma}; }
};

}  // namespace brachium
