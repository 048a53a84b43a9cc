// Accelerometer: between two knots the sensor moves as its specific force and gravity say.
//
//   r_v = R_kᵀ (v_k+1 - v_k - g D) - dv(b, a, s, τ)                R_k = R_WB,k R_BS
//   r_p = R_kᵀ (P_k+1 - P_k - v_k D - g D²/2) - dp(b, a, s, τ)
//   r   = W [r_v; r_p],   Wᵀ W = (C ⊗ I₃)⁻¹
//
// Frames    W world (z up, g = (0, 0, -gravity)), B the segment that wears the sensor, S sensor.
// Unknowns  q_WB at k; P_k, P_k+1, v_k, v_k+1: place [m] and velocity [m/s] of the sensor in W; gyro
//           bias at the two nodes about the interval [rad/s]; accelerometer bias a [m/s²]; scale
//           errors s of gyroscope and accelerometer [1]; τ: how far its clock is behind [s].
// Weight    C = covariance of (dv, dp) on one axis; their correlation (0.87 for white noise) is kept.
// Jacobian  with u_v, u_p the brackets above in W and ŵ = R_BW u: ∂r/∂φ = R_SB [ŵ]x; the samples'
//           corrections are linear (preintegration.h); all else is ± R_SW.
// Blind to  heading, the place as a whole, a steady velocity; while the sensor keeps its attitude,
//           bias looks like tilt. What ties sensors to each other is segment_chain.h.
// Source    preintegration after Forster et al., IEEE Trans. Robotics 33 (2017), eqs. 37, 45; Zhou et
//           al., Med. Eng. Phys. 30 (2008), eq. 3 with gravity's sign put right.
#pragma once

#include "problems/preintegration.h"
#include "problems/residuals/cost.h"
#include "problems/residuals/whitening.h"

namespace brachium {

class Accelerometer {
 public:
  static constexpr int kResiduals = 6;
  // q_WB, P_k, P_k+1, v_k, v_k+1, gyro biases and scale, accelerometer bias and scale, clock
  using Blocks = std::integer_sequence<int, 4, 3, 3, 3, 3, 3, 3, 3, 3, 3, 1>;

  // `interval` must outlive the residual. `alpha`: where its middle lies between the bias nodes, 0 to
  // 1. `gravity` [m/s²].
  Accelerometer(const Preintegrated& interval, const Eigen::Quaterniond& q_BS, double alpha,
                double gravity, const Whitening2& whitening)
      : interval_(interval), q_BS_(q_BS), alpha_(alpha), gravity_(gravity), whitening_(whitening) {}

  template <typename T>
  void operator()(const T* const* x, T* r) const {
    const double D = interval_.duration;
    Vector3T<T> u_v = Vector<T>(x[4]) - Vector<T>(x[3]);
    Vector3T<T> u_p = Vector<T>(x[2]) - Vector<T>(x[1]) - T(D) * Vector<T>(x[3]);
    u_v.z() += T(gravity_ * D);
    u_p.z() += T(gravity_ * D * D / 2);
    const Eigen::Quaternion<T> q_WB = Eigen::Map<const Eigen::Quaternion<T>>(x[0]);
    const Eigen::Quaternion<T> q_SW = (q_WB * q_BS_.cast<T>()).conjugate();
    const Vector3T<T> bias = T(1 - alpha_) * Vector<T>(x[5]) + T(alpha_) * Vector<T>(x[6]) -
                             interval_.gyro_bias.cast<T>();
    const T behind = x[10][0] - T(interval_.clock_offset);
    const auto s_g = Vector<T>(x[7]), a = Vector<T>(x[8]), s_a = Vector<T>(x[9]);
    const Vector3T<T> r_v = q_SW * u_v - interval_.dv.cast<T>() -
                            interval_.dv_dbg.cast<T>() * bias - interval_.dv_dsg.cast<T>() * s_g -
                            interval_.dv_dba.cast<T>() * a - interval_.dv_dsa.cast<T>() * s_a -
                            interval_.dv_dc.cast<T>() * behind;
    const Vector3T<T> r_p = q_SW * u_p - interval_.dp.cast<T>() -
                            interval_.dp_dbg.cast<T>() * bias - interval_.dp_dsg.cast<T>() * s_g -
                            interval_.dp_dba.cast<T>() * a - interval_.dp_dsa.cast<T>() * s_a -
                            interval_.dp_dc.cast<T>() * behind;
    whitening_.Apply(r_v, r_p, r);
  }

  void Differentiate(const double* const* x, double* const* J) const {
    const double D = interval_.duration;
    const Eigen::Matrix3d R_SB = q_BS_.conjugate().toRotationMatrix();
    const Eigen::Matrix3d R_BW =
        Eigen::Map<const Eigen::Quaterniond>(x[0]).conjugate().toRotationMatrix();
    const Eigen::Matrix3d R_SW = R_SB * R_BW, zero = Eigen::Matrix3d::Zero();
    Eigen::Vector3d u_v = Vector<double>(x[4]) - Vector<double>(x[3]);
    Eigen::Vector3d u_p = Vector<double>(x[2]) - Vector<double>(x[1]) - D * Vector<double>(x[3]);
    u_v.z() += gravity_ * D;
    u_p.z() += gravity_ * D * D / 2;
    Store(J[0], R_SB * Skew<double>(R_BW * u_v), R_SB * Skew<double>(R_BW * u_p));
    Store(J[1], zero, -R_SW);
    Store(J[2], zero, R_SW);
    Store(J[3], -R_SW, -D * R_SW);
    Store(J[4], R_SW, zero);
    Store(J[5], (alpha_ - 1) * interval_.dv_dbg, (alpha_ - 1) * interval_.dp_dbg);
    Store(J[6], -alpha_ * interval_.dv_dbg, -alpha_ * interval_.dp_dbg);
    Store(J[7], -interval_.dv_dsg, -interval_.dp_dsg);
    Store(J[8], -interval_.dv_dba, -interval_.dp_dba);
    Store(J[9], -interval_.dv_dsa, -interval_.dp_dsa);
    StoreClock(J[10]);
  }

 private:
  template <typename T>
  using Vector = Eigen::Map<const Vector3T<T>>;

  void Store(double* J, const Eigen::Matrix3d& J_v, const Eigen::Matrix3d& J_p) const {
    Eigen::Map<RowMajor<6, 3>> block(J);
    block.topRows<3>() = whitening_.vv * J_v;
    block.bottomRows<3>() = whitening_.pv * J_v + whitening_.pp * J_p;
  }

  void StoreClock(double* J) const {
    Eigen::Map<Eigen::Matrix<double, 6, 1>> block(J);
    block.head<3>() = -whitening_.vv * interval_.dv_dc;
    block.tail<3>() = -whitening_.pv * interval_.dv_dc - whitening_.pp * interval_.dp_dc;
  }

  const Preintegrated& interval_;
  Eigen::Quaterniond q_BS_;
  double alpha_;
  double gravity_;
  Whitening2 whitening_;
};

}  // namespace brachium
