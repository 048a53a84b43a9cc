// Gyroscope: the attitude turns between two knots as the rates, less their bias, say.
//
//   r = Log( dR(b)ᵀ R_WS,k⁻¹ R_WS,k+1 ) / σ,   R_WS = R_WB R_BS,
//   dR(b) = dR Exp(c),   c = dR_dbg (b - b̄) + dR_dsg s + dR_dc (τ - τ̄),   b = (1-α) b_j + α b_j+1, the
//   value at the interval's middle
//
// Frames    W world, B segment, S sensor. dR: attitude at the end in the sensor's frame at the start.
// Unknowns  q_WB,k, q_WB,k+1 (right perturbed, rad); b_j, b_j+1: gyro bias at the two nodes about the
//           interval [rad/s]; s: scale error of each axis [1]; τ: how far its clock is
//           behind [s].
// Weight    σ² [rad²]: white noise S_g D, a scale that varies, missing samples; isotropic, since a white
//           isotropic rate noise stays so under rotation.
// Jacobian  with e = Log(·) and M = R_WS,k⁻¹ R_WS,k+1:
//           ∂e/∂φ_k = -Jr⁻¹(e) Mᵀ R_BSᵀ,   ∂e/∂φ_k+1 = Jr⁻¹(e) R_BSᵀ,
//           ∂e/∂b   = -Jr⁻¹(e) Exp(e)ᵀ Jr(c) dR_dbg, likewise for s and τ.
// Blind to  any rotation of the world; s about an axis that the sensor does not turn about; a change
//           of bias and an equal change of mean rate; τ while the rate is steady.
// Source    Forster, Carlone, Dellaert & Scaramuzza, IEEE T-RO 33 (2017) 1-21, eqs. 37 and 44.
#pragma once

#include "problems/preintegration.h"
#include "problems/residuals/cost.h"

namespace brachium {

class Gyroscope {
 public:
  static constexpr int kResiduals = 3;
  using Blocks =
      std::integer_sequence<int, 4, 4, 3, 3, 3, 1>;  // q_WB,k, q_WB,k+1, b_j, b_j+1, s, τ

  // `interval` must outlive the residual. `alpha`: where its middle lies between the bias nodes, 0 to
  // 1. `sigma` [rad].
  Gyroscope(const Preintegrated& interval, const Eigen::Quaterniond& q_BS, double alpha,
            double sigma)
      : interval_(interval), q_BS_(q_BS), alpha_(alpha), weight_(1.0 / sigma) {}

  template <typename T>
  void operator()(const T* const* x, T* r) const {
    using Rotation = Eigen::Map<const Eigen::Quaternion<T>>;
    using Vector = Eigen::Map<const Vector3T<T>>;
    const Eigen::Quaternion<T> q_BS = q_BS_.cast<T>();
    const Vector3T<T> bias = (T(1) - T(alpha_)) * Vector(x[2]) + T(alpha_) * Vector(x[3]);
    const Vector3T<T> correction =
        interval_.dR_dbg.cast<T>() * (bias - interval_.gyro_bias.cast<T>()) +
        interval_.dR_dsg.cast<T>() * Vector(x[4]) +
        interval_.dR_dc.cast<T>() * (x[5][0] - T(interval_.clock_offset));
    const Eigen::Quaternion<T> dq = interval_.dq.cast<T>() * Exp<T>(correction);
    const Eigen::Quaternion<T> turn = (Rotation(x[0]) * q_BS).conjugate() * (Rotation(x[1]) * q_BS);
    Eigen::Map<Vector3T<T>>{r} = T(weight_) * Log<T>(dq.conjugate() * turn);
  }

  void Differentiate(const double* const* x, double* const* J) const {
    using Rotation = Eigen::Map<const Eigen::Quaterniond>;
    using Vector = Eigen::Map<const Eigen::Vector3d>;
    using Block = Eigen::Map<RowMajor<3, 3>>;
    const Eigen::Vector3d bias = (1 - alpha_) * Vector(x[2]) + alpha_ * Vector(x[3]);
    const Eigen::Vector3d correction = interval_.dR_dbg * (bias - interval_.gyro_bias) +
                                       interval_.dR_dsg * Vector(x[4]) +
                                       interval_.dR_dc * (x[5][0] - interval_.clock_offset);
    const Eigen::Quaterniond q_error = (interval_.dq * Exp<double>(correction)).conjugate() *
                                       (Rotation(x[0]) * q_BS_).conjugate() *
                                       (Rotation(x[1]) * q_BS_);
    const Eigen::Matrix3d R_SB = q_BS_.conjugate().toRotationMatrix();
    const Eigen::Matrix3d J_e = weight_ * InverseRightJacobian(Log<double>(q_error));
    Block{J[1]} = J_e * R_SB;
    Block{J[0]} = -J_e * (R_SB * (Rotation(x[1]).conjugate() * Rotation(x[0])).toRotationMatrix());
    const Eigen::Matrix3d J_c =
        -J_e * q_error.conjugate().toRotationMatrix() * RightJacobian(correction);
    const Eigen::Matrix3d J_b = J_c * interval_.dR_dbg;
    Block{J[2]} = (1 - alpha_) * J_b;
    Block{J[3]} = alpha_ * J_b;
    Block{J[4]} = J_c * interval_.dR_dsg;
    Eigen::Map<Eigen::Vector3d>{J[5]} = J_c * interval_.dR_dc;
  }

 private:
  const Preintegrated& interval_;
  Eigen::Quaterniond q_BS_;
  double alpha_;
  double weight_;
};

}  // namespace brachium
