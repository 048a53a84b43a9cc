// Thorax: a thorax sensor carries the shoulder along, up to the shoulder's own movement.
//
//   e_k = R_WT,kᵀ (p_k - t_k) - d_T,   r = (e_k - ρ e_k-1) / (σ sqrt(1 - ρ²));   the first: e_0 / σ
//
// Frames    T thorax; t: its origin, p: the root joint of the arm, both in W [m]; d_T: from the one to
//           the other in thorax axes, as told [m].
// Unknowns  q_WT, t, p at knot k-1, then at k.
// Weight    σ, τ of the shoulder (shoulder_process.h), here about the thorax instead of the world.
// Jacobian  ∂e/∂φ_T = [R_TW (p - t)]x, ∂e/∂t = -R_TW, ∂e/∂p = R_TW.
// Blind to  the pose of the whole body.
// Source    shoulder girdle on the trunk: Bai et al., IEEE TNSRE 23 (2015), section II-B.
#pragma once

#include "problems/residuals/cost.h"
#include "problems/residuals/whitening.h"

namespace brachium {

// One instant's deviation e of the shoulder from where the thorax would carry it.
struct ThoraxDeviation {
  Eigen::Vector3d p_shoulder_T;

  template <typename T>
  Vector3T<T> operator()(const T* const* x) const {
    using Vector = Eigen::Map<const Vector3T<T>>;
    const Eigen::Map<const Eigen::Quaternion<T>> q_WT(x[0]);
    return q_WT.conjugate() * Vector3T<T>(Vector(x[2]) - Vector(x[1])) - p_shoulder_T.cast<T>();
  }

  static void Differentiate(const double* const* x, double weight, double* const* J) {
    using Vector = Eigen::Map<const Eigen::Vector3d>;
    using Block = Eigen::Map<RowMajor<3, 3>>;
    const Eigen::Matrix3d R_TW =
        Eigen::Map<const Eigen::Quaterniond>(x[0]).conjugate().toRotationMatrix();
    Block{J[0]} = weight * Skew<double>(R_TW * (Vector(x[2]) - Vector(x[1])));
    Block{J[1]} = -weight * R_TW;
    Block{J[2]} = weight * R_TW;
  }
};

class ThoraxShoulder {
 public:
  static constexpr int kResiduals = 3;
  using Blocks = std::integer_sequence<int, 4, 3, 3, 4, 3, 3>;  // q_WT, t, p at k-1; at k

  ThoraxShoulder(const Eigen::Vector3d& p_shoulder_T, const FirstOrderStep& step)
      : deviation_{p_shoulder_T}, step_(step) {}

  template <typename T>
  void operator()(const T* const* x, T* r) const {
    Eigen::Map<Vector3T<T>>{r} =
        T(step_.weight) * (deviation_(x + 3) - T(step_.rho) * deviation_(x));
  }

  void Differentiate(const double* const* x, double* const* J) const {
    ThoraxDeviation::Differentiate(x, -step_.weight * step_.rho, J);
    ThoraxDeviation::Differentiate(x + 3, step_.weight, J + 3);
  }

 private:
  ThoraxDeviation deviation_;
  FirstOrderStep step_;
};

class ThoraxShoulderStart {
 public:
  static constexpr int kResiduals = 3;
  using Blocks = std::integer_sequence<int, 4, 3, 3>;  // q_WT, t, p

  ThoraxShoulderStart(const Eigen::Vector3d& p_shoulder_T, double sigma)
      : deviation_{p_shoulder_T}, weight_(1 / sigma) {}

  template <typename T>
  void operator()(const T* const* x, T* r) const {
    Eigen::Map<Vector3T<T>>{r} = T(weight_) * deviation_(x);
  }

  void Differentiate(const double* const* x, double* const* J) const {
    ThoraxDeviation::Differentiate(x, weight_, J);
  }

 private:
  ThoraxDeviation deviation_;
  double weight_;
};

}  // namespace brachium
