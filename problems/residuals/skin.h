// Skin: muscle and skin turn a sensor about its segment to and fro, and let it come back.
//
//   r_k = (w_k - ρ w_k-1) / (σ sqrt(1 - ρ²)),   ρ = exp(-D/τ);   r_0 = w_0 / σ
//
// Frames    w_k: the sensor's turn beyond its mounting, segment axes [rad] (as_mounted.h). About the
//           long axis y it is σ, about x and z kTilt σ: skin slides around a bone more easily than it
//           tilts on it.
// Unknowns  w_k-1, w_k.
// Weight    σ [rad]: a few degrees; τ [s]: wobbles of about 1 Hz last 1/(2π) s.
// Jacobian  -ρ/(σ sqrt(1 - ρ²)), 1/(σ sqrt(1 - ρ²)) on the diagonal.
// Blind to  a turn that stays: that is the mounting's. What joints feel of the segment, and not of the
//           sensor, tells w: the lever arms' accelerations and the elbow's adduction.
// Source    sizes: Cereatti et al., J. Biomech. 62 (2017) (upper arm's axial rotation 5-15 deg).
#pragma once

#include "problems/residuals/prior.h"
#include "problems/residuals/whitening.h"

namespace brachium {

inline constexpr double kTilt = 0.4;

class SkinProcess {
 public:
  static constexpr int kResiduals = 3;
  using Blocks = std::integer_sequence<int, 3, 3>;  // w_k-1, w_k

  explicit SkinProcess(const FirstOrderStep& step)
      : rho_(step.rho), weight_(step.weight / kTilt, step.weight, step.weight / kTilt) {}

  template <typename T>
  void operator()(const T* const* x, T* r) const {
    for (int i = 0; i < 3; ++i) r[i] = T(weight_[i]) * (x[1][i] - T(rho_) * x[0][i]);
  }

  void Differentiate(const double* const*, double* const* J) const {
    Eigen::Map<RowMajor<3, 3>>{J[0]} = (-rho_ * weight_).asDiagonal();
    Eigen::Map<RowMajor<3, 3>>{J[1]} = weight_.asDiagonal();
  }

 private:
  double rho_;
  Eigen::Vector3d weight_;
};

class SkinStart : public Prior<3> {
 public:
  explicit SkinStart(double sigma)
      : Prior(Eigen::Vector3d::Zero(), {kTilt * sigma, sigma, kTilt * sigma}) {}
};

}  // namespace brachium
