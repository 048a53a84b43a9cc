// Start heading: the arm starts with the heading of the start guess, and so, loosely, does each
// segment against the one before it.
//
//   h(q; q̄) = e_z · (R̄ Log(R̄ᵀ R)),   r = h(q_0) / σ_0   or   r = (h(q_i) - h(q_i-1)) / σ
//
// Frames    R = R_WB at the first knot, R̄ its start guess; e_z: world vertical.
// Unknowns  q_WB of the first segment; or of a segment and the one before it.
// Weight    σ_0 = 1 mrad, the gauge: gyroscopes and accelerometers cannot see the heading of the
//           whole arm, and no relative quantity depends on it. σ of a radian or two: where neither
//           movement nor the elbow tells a relative heading, it is at least determined, and its
//           standard deviation says that it is a guess.
// Jacobian  ∂h/∂φ = (R̄ᵀ e_z)ᵀ Jr⁻¹(Log(R̄ᵀ R)).
// Blind to  inclination; the second form also to the heading of the whole.
#pragma once

#include "problems/residuals/cost.h"

namespace brachium {

// Turn about the vertical since the start guess [rad].
class HeadingChange {
 public:
  explicit HeadingChange(const Eigen::Quaterniond& q_start)
      : q_start_(q_start), up_B_(q_start.conjugate() * Eigen::Vector3d::UnitZ()) {}

  template <typename T>
  T operator()(const T* q_WB) const {
    const Eigen::Map<const Eigen::Quaternion<T>> q(q_WB);
    return up_B_.cast<T>().dot(Log<T>(q_start_.cast<T>().conjugate() * q));
  }

  Eigen::RowVector3d Differentiate(const double* q_WB) const {
    const Eigen::Map<const Eigen::Quaterniond> q(q_WB);
    return up_B_.transpose() * InverseRightJacobian(Log<double>(q_start_.conjugate() * q));
  }

 private:
  Eigen::Quaterniond q_start_;
  Eigen::Vector3d up_B_;
};

class HeadingGauge {
 public:
  static constexpr int kResiduals = 1;
  using Blocks = std::integer_sequence<int, 4>;

  explicit HeadingGauge(const Eigen::Quaterniond& q_start, double sigma = 1e-3)
      : change_(q_start), weight_(1 / sigma) {}

  template <typename T>
  void operator()(const T* const* x, T* r) const {
    r[0] = T(weight_) * change_(x[0]);
  }

  void Differentiate(const double* const* x, double* const* J) const {
    Eigen::Map<Eigen::RowVector3d>{J[0]} = weight_ * change_.Differentiate(x[0]);
  }

 private:
  HeadingChange change_;
  double weight_;
};

class RelativeStartHeading {
 public:
  static constexpr int kResiduals = 1;
  using Blocks = std::integer_sequence<int, 4, 4>;  // the segment before, the segment

  RelativeStartHeading(const Eigen::Quaterniond& q_before, const Eigen::Quaterniond& q_start,
                       double sigma)
      : before_(q_before), change_(q_start), weight_(1 / sigma) {}

  template <typename T>
  void operator()(const T* const* x, T* r) const {
    r[0] = T(weight_) * (change_(x[1]) - before_(x[0]));
  }

  void Differentiate(const double* const* x, double* const* J) const {
    Eigen::Map<Eigen::RowVector3d>{J[0]} = -weight_ * before_.Differentiate(x[0]);
    Eigen::Map<Eigen::RowVector3d>{J[1]} = weight_ * change_.Differentiate(x[1]);
  }

 private:
  HeadingChange before_, change_;
  double weight_;
};

}  // namespace brachium
