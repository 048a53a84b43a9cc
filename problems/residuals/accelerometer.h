// Accelerometer with segment lengths: the sensor, carried by the chain of segments, moves between two
// knots as its specific force says.
//
//   r_v = R_kᵀ (v_k+1 - v_k - g D) - dv(b, a, s)              R_k = R_WB,k R_BS of the last segment
//   r_p = R_kᵀ (P_k+1 - P_k - v_k D - g D²/2) - dp(b, a, s)   P   = p + Σ R_i d_i + R_n l
//   r   = W [r_v; r_p],   Wᵀ W = (C ⊗ I₃)⁻¹
//
// Frames    W world (z up, g = (0, 0, -9.81)); B_1 ... B_n the segments from the chain's root to the
//           one that wears the sensor; S sensor. p: the root joint, d_i: from a segment's proximal to
//           its distal joint in its axes, l: the sensor in the last segment's axes.
// Unknowns  q_1 ... q_n at k, then at k+1; p_k, p_k+1 [m]; v_k, v_k+1: velocity of the sensor [m/s];
//           gyro bias at the two nodes about the interval [rad/s]; accelerometer bias a [m/s²] and
//           scale s [1]; l, d_1 ... d_n-1 [m].
// Weight    C = covariance of (dv, dp) on one axis; their correlation (0.87 for white noise) is kept.
// Jacobian  with u_v, u_p the brackets above in segment axes, u = R_WB,kᵀ (·):
//           ∂r_v/∂φ_n,k = R_SB [u_v]x,   ∂r_p/∂φ_n,k = R_SB ([u_p]x + [l]x),
//           ∂r_p/∂φ_i,k = R_kᵀ R_i [d_i]x, and the opposite with the attitude of k+1 for k+1;
//           the samples' corrections are linear (preintegration.h).
// Blind to  the heading of the whole arm, the place of the root; while all segments keep their
//           attitude, accelerometer bias looks like tilt, and lever arms do not matter at all.
// Source    the integral form of the joint-acceleration link of Weygers & Kok, IEEE Sensors J. 20
//           (2020); Zhou et al., Med. Eng. Phys. 30 (2008), eqs. 6 and 7, with the lever arm put
//           right; preintegration after Forster et al. (2017), eqs. 37, 45.
#pragma once

#include "problems/preintegration.h"
#include "problems/residuals/cost.h"
#include "problems/residuals/whitening.h"

namespace brachium {

// The blocks of a chain: 4 for each attitude at k and k+1, then vectors of 3.
template <int kChain, int... kRotation, int... kVector>
constexpr auto AccelerometerBlocks(std::integer_sequence<int, kRotation...>,
                                   std::integer_sequence<int, kVector...>) {
  return std::integer_sequence<int, (kRotation * 0 + 4)..., (kVector * 0 + 3)...>();
}

// kChain: number of segments from the root to the sensor, 1 to 4.
template <int kChain>
class Accelerometer {
 public:
  static constexpr int kResiduals = 6;
  using Blocks =
      decltype(AccelerometerBlocks<kChain>(std::make_integer_sequence<int, 2 * kChain>(),
                                           std::make_integer_sequence<int, 8 + kChain>()));

  // `alpha`: where the interval's middle lies between the bias nodes, 0 to 1.
  Accelerometer(const Preintegrated& interval, const Eigen::Quaterniond& q_BS, double alpha,
                const Whitening2& whitening)
      : interval_(interval), q_BS_(q_BS), alpha_(alpha), whitening_(whitening) {}

  template <typename T>
  void operator()(const T* const* x, T* r) const {
    const double D = interval_.duration;
    const auto moved = [&](int i) { return Vector3T<T>(Vector<T>(x[i + 1]) - Vector<T>(x[i])); };
    Vector3T<T> u_v = moved(kVelocity);
    Vector3T<T> u_p = moved(kRoot) - T(D) * Vector<T>(x[kVelocity]);
    for (int i = 0; i < kChain; ++i) {
      const auto d = Vector<T>(x[Lever(i)]);
      u_p += Rotation<T>(x[kChain + i]) * d - Rotation<T>(x[i]) * d;
    }
    u_v.z() += T(kGravity * D);
    u_p.z() += T(kGravity * D * D / 2);
    const Eigen::Quaternion<T> q_SW = (Rotation<T>(x[kChain - 1]) * q_BS_.cast<T>()).conjugate();
    const Vector3T<T> bias = (T(1) - T(alpha_)) * Vector<T>(x[kGyroBias]) +
                             T(alpha_) * Vector<T>(x[kGyroBias + 1]) -
                             interval_.gyro_bias.cast<T>();
    const auto a = Vector<T>(x[kAccelBias]), s = Vector<T>(x[kAccelScale]);
    const Vector3T<T> r_v = q_SW * u_v - interval_.dv.cast<T>() -
                            interval_.dv_dbg.cast<T>() * bias - interval_.dv_dba.cast<T>() * a -
                            interval_.dv_dsa.cast<T>() * s;
    const Vector3T<T> r_p = q_SW * u_p - interval_.dp.cast<T>() -
                            interval_.dp_dbg.cast<T>() * bias - interval_.dp_dba.cast<T>() * a -
                            interval_.dp_dsa.cast<T>() * s;
    whitening_.Apply(r_v, r_p, r);
  }

  void Differentiate(const double* const* x, double* const* J) const {
    const double D = interval_.duration;
    const Eigen::Matrix3d R_SB = q_BS_.conjugate().toRotationMatrix();
    const Eigen::Matrix3d R_BW = Rotation<double>(x[kChain - 1]).conjugate().toRotationMatrix();
    const Eigen::Matrix3d R_SW = R_SB * R_BW;
    const Eigen::Matrix3d kZero = Eigen::Matrix3d::Zero();

    Eigen::Vector3d u_v = Vector<double>(x[kVelocity + 1]) - Vector<double>(x[kVelocity]);
    Eigen::Vector3d u_p =
        Vector<double>(x[kRoot + 1]) - Vector<double>(x[kRoot]) - D * Vector<double>(x[kVelocity]);
    u_v.z() += kGravity * D;
    u_p.z() += kGravity * D * D / 2;
    for (int i = 0; i < kChain; ++i) {
      const Eigen::Vector3d d = Vector<double>(x[Lever(i)]);
      const Eigen::Matrix3d R_S_before = R_SW * Rotation<double>(x[i]).toRotationMatrix();
      const Eigen::Matrix3d R_S_after = R_SW * Rotation<double>(x[kChain + i]).toRotationMatrix();
      u_p += R_SW.transpose() * ((R_S_after - R_S_before) * d);
      const Eigen::Matrix3d d_cross = Skew<double>(d);
      if (i + 1 < kChain) Store(J[i], kZero, R_S_before * d_cross);
      Store(J[kChain + i], kZero, -R_S_after * d_cross);
      Store(J[Lever(i)], kZero, R_S_after - R_S_before);
    }
    const Eigen::Vector3d lever = Vector<double>(x[Lever(kChain - 1)]);
    Store(J[kChain - 1], R_SB * Skew<double>(R_BW * u_v),
          R_SB * (Skew<double>(R_BW * u_p) + Skew<double>(lever)));
    Store(J[kRoot], kZero, -R_SW);
    Store(J[kRoot + 1], kZero, R_SW);
    Store(J[kVelocity], -R_SW, -D * R_SW);
    Store(J[kVelocity + 1], R_SW, kZero);
    Store(J[kGyroBias], -(1 - alpha_) * interval_.dv_dbg, -(1 - alpha_) * interval_.dp_dbg);
    Store(J[kGyroBias + 1], -alpha_ * interval_.dv_dbg, -alpha_ * interval_.dp_dbg);
    Store(J[kAccelBias], -interval_.dv_dba, -interval_.dp_dba);
    Store(J[kAccelScale], -interval_.dv_dsa, -interval_.dp_dsa);
  }

 private:
  template <typename T>
  using Rotation = Eigen::Map<const Eigen::Quaternion<T>>;
  template <typename T>
  using Vector = Eigen::Map<const Vector3T<T>>;

  // Places of the blocks; the lever of segment i is its joint vector, of the last one the sensor's.
  static constexpr int kRoot = 2 * kChain, kVelocity = kRoot + 2, kGyroBias = kVelocity + 2,
                       kAccelBias = kGyroBias + 2, kAccelScale = kAccelBias + 1,
                       kSensor = kAccelScale + 1;
  static constexpr int Lever(int i) { return i + 1 == kChain ? kSensor : kSensor + 1 + i; }

  void Store(double* J, const Eigen::Matrix3d& J_v, const Eigen::Matrix3d& J_p) const {
    Eigen::Map<RowMajor<6, 3>> block(J);
    block.topRows<3>() = whitening_.vv * J_v;
    block.bottomRows<3>() = whitening_.pv * J_v + whitening_.pp * J_p;
  }

  Preintegrated interval_;
  Eigen::Quaterniond q_BS_;
  double alpha_;
  Whitening2 whitening_;
};

}  // namespace brachium
