// Heading gauge: the first segment starts with the heading that the start guess gave it.
//
//   r = e_z · (R̄ Log(R̄ᵀ R)) / σ
//
// Frames    R = R_WB of the first segment at the first knot, R̄ its start guess; e_z: world vertical.
// Unknowns  q_WB. Weight σ = 1 mrad. Jacobian (R̄ᵀ e_z)ᵀ Jr⁻¹(Log(R̄ᵀ R)) / σ.
// Blind to  inclination. Gyroscopes and accelerometers cannot see the heading of the whole arm; one
//           prior fixes it, and no relative quantity depends on it.
#pragma once

#include "problems/residuals/cost.h"

namespace brachium {

class HeadingGauge {
 public:
  static constexpr int kResiduals = 1;
  using Blocks = std::integer_sequence<int, 4>;

  explicit HeadingGauge(const Eigen::Quaterniond& q_start, double sigma = 1e-3)
      : q_start_(q_start),
        up_B_(q_start.conjugate() * Eigen::Vector3d::UnitZ()),
        weight_(1 / sigma) {}

  template <typename T>
  void operator()(const T* const* x, T* r) const {
    const Eigen::Map<const Eigen::Quaternion<T>> q(x[0]);
    r[0] = T(weight_) * up_B_.cast<T>().dot(Log<T>(q_start_.cast<T>().conjugate() * q));
  }

  void Differentiate(const double* const* x, double* const* J) const {
    const Eigen::Map<const Eigen::Quaterniond> q(x[0]);
    Eigen::Map<Eigen::RowVector3d>{J[0]} =
        weight_ * up_B_.transpose() * InverseRightJacobian(Log<double>(q_start_.conjugate() * q));
  }

 private:
  Eigen::Quaterniond q_start_;
  Eigen::Vector3d up_B_;
  double weight_;
};

}  // namespace brachium
