// Elbow adduction: the elbow is a hinge with a carrying angle, up to a slow deviation and a wobble.
//
//   r_k = (e_k - a_k) / σ_k,   e = (z_U·y_F + s sin κ) / cos κ,   κ = k0 + k1 (y_U·y_F)
//   a:  (a_k - ρ a_k-1) / (σ sqrt(1 - ρ²)),   ρ = exp(-D/τ);   the first: a_0 / σ
//
// Frames    U upper arm, F forearm, ISB axes, all vectors in W: z_U the flexion axis, y long axes
//           (proximal). With R_UF = Rz(flexion) Rx(β) Ry(·), sin β = z_U·y_F exactly and
//           y_U·y_F = cos(flexion) cos β. s = +1 right, -1 left; valgus is -s β, so κ is positive
//           when the forearm deviates away from the body.
// Unknowns  q_WU, q_WF, carrying = [k0, k1] [rad]; a_k: the slow deviation [rad].
// Weight    σ [rad], τ [s]: joint play and misplaced axes, as long as a posture lasts;
//           σ_k [rad]: the wobble of skin and muscle, white over the step: sqrt(2 σ_w² τ_w / D).
//           One process for both would either call a wobble a lasting deviation or take it for
//           hundreds of independent measurements of the heading.
// Jacobian  ∂(u_U·v_F)/∂φ_U = (u × R_UF v)ᵀ, ∂/∂φ_F = (v × R_FU u)ᵀ for unit axes u, v;
//           ∂e/∂(z_U·y_F) = 1/cos κ, ∂e/∂κ = s + e tan κ; ∂r/∂a_k = -1/σ_k.
// Blind to  a rotation common to both segments; flexion; pronation. The relative heading δ changes
//           β by -n_z/cos β with n = z_U × y_F: nothing where the hanging arm is straight.
// Source    Luinge, Veltink & Baten, J. Biomech. 40 (2007) 78-85 (adduction as a measurement, their
//           eq. 6 with the sign put right); axes Wu et al., J. Biomech. 38 (2005) 981-992.
#pragma once

#include <cmath>

#include "problems/residuals/linear.h"
#include "problems/residuals/whitening.h"
#include "problems/segment.h"

namespace brachium {

// One elbow posture's deviation e from the carrying angle.
struct AdductionDeviation {
  double s;  // side

  template <typename T>
  T operator()(const T* q_WU, const T* q_WF, const T* carrying) const {
    using std::cos, std::sin;
    using Rotation = Eigen::Map<const Eigen::Quaternion<T>>;
    const Vector3T<T> y_F = Rotation(q_WF) * Vector3T<T>(Vector3T<T>::UnitY());
    const T sin_beta = (Rotation(q_WU) * Vector3T<T>(Vector3T<T>::UnitZ())).dot(y_F);
    const T cos_flexion = (Rotation(q_WU) * Vector3T<T>(Vector3T<T>::UnitY())).dot(y_F);
    const T kappa = carrying[0] + carrying[1] * cos_flexion;
    return (sin_beta + T(s) * sin(kappa)) / cos(kappa);
  }

  struct Gradient {
    Eigen::RowVector3d phi_U, phi_F;
    Eigen::RowVector2d carrying;
  };

  Gradient Differentiate(const double* q_WU, const double* q_WF, const double* carrying) const {
    using Rotation = Eigen::Map<const Eigen::Quaterniond>;
    const Eigen::Vector3d y = Eigen::Vector3d::UnitY(), z = Eigen::Vector3d::UnitZ();
    const Eigen::Quaterniond q_UF = Rotation(q_WU).conjugate() * Rotation(q_WF);
    const Eigen::Vector3d y_F_U = q_UF * y;
    const Eigen::Quaterniond q_FU = q_UF.conjugate();
    const double kappa = carrying[0] + carrying[1] * y_F_U.y();
    const double e = (y_F_U.z() + s * std::sin(kappa)) / std::cos(kappa);
    const double de_dx = 1 / std::cos(kappa), de_dkappa = s + e * std::tan(kappa);
    const double de_dc = de_dkappa * carrying[1];
    return {de_dx * z.cross(y_F_U).transpose() + de_dc * y.cross(y_F_U).transpose(),
            de_dx * y.cross(q_FU * z).transpose() + de_dc * y.cross(q_FU * y).transpose(),
            Eigen::RowVector2d(de_dkappa, de_dkappa * y_F_U.y())};
  }
};

class ElbowAdduction {
 public:
  static constexpr int kResiduals = 1;
  using Blocks = std::integer_sequence<int, 4, 4, 2, 1>;  // q_WU, q_WF, carrying, a_k

  ElbowAdduction(Side side, double sigma) : deviation_{Sign(side)}, weight_(1 / sigma) {}

  template <typename T>
  void operator()(const T* const* x, T* r) const {
    r[0] = T(weight_) * (deviation_(x[0], x[1], x[2]) - x[3][0]);
  }

  void Differentiate(const double* const* x, double* const* J) const {
    const auto gradient = deviation_.Differentiate(x[0], x[1], x[2]);
    Eigen::Map<Eigen::RowVector3d>{J[0]} = weight_ * gradient.phi_U;
    Eigen::Map<Eigen::RowVector3d>{J[1]} = weight_ * gradient.phi_F;
    Eigen::Map<Eigen::RowVector2d>{J[2]} = weight_ * gradient.carrying;
    J[3][0] = -weight_;
  }

 private:
  AdductionDeviation deviation_;
  double weight_;
};

// The slow deviation from one knot to the next.
class AdductionProcess : public Linear<1, 2> {
 public:
  using Blocks = std::integer_sequence<int, 1, 1>;  // a_k-1, a_k
  explicit AdductionProcess(const FirstOrderStep& step)
      : Linear({-step.weight * step.rho, step.weight}, Vector::Zero()) {}
};

}  // namespace brachium
