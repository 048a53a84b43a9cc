// Held pose: joint angles that the person was asked to hold at one instant, at the start or the end.
//
//   elbow      r = (angle(R_UF) - told) / σ      one residual for flexion, one for pronation
//   elevation  r = (cos(told) - y_U · e_z) / (σ max(sin(told), sin σ))
//   facing     r = (η(x_U) - η(x_G)) / σ,   η(x) = atan2(e_2 · x, e_1 · x)
//
// Frames    U upper arm, F forearm, G girdle or thorax, W world; angles as in elbow_angles.h;
//           elevation is the angle of the upper arm from hanging, y_U its long axis (proximal), x_U
//           and x_G point forward, e_z up, e_1 and e_2 horizontal.
// Unknowns  q_WU, q_WF; q_WU; q_WG, q_WU.
// Weight    σ [rad]: how well people take a pose, about 10 deg; an angle that was not told has none.
//           A hanging upper arm is not asked to face forward, its elbow does so to some 20 deg.
// Jacobian  elbow_angles.h, with the difference taken to the nearest turn;
//           ∂(y_U·e_z)/∂φ_U = (y × R_UW e_z)ᵀ;
//           ∂η/∂φ = (u - u_x e_x)ᵀ / (1 - u_x²), u = Rᵀ e_z.
// Blind to  the common heading. Pronation of a hanging arm is what fixes the relative heading.
// Source    Luinge, Veltink & Baten (2007): arms along the body, thumbs forward.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "problems/residuals/cost.h"
#include "problems/residuals/elbow_angles.h"

namespace brachium {

enum class ElbowAngle { kFlexion, kPronation };

class ElbowHeldPose {
 public:
  static constexpr int kResiduals = 1;
  using Blocks = std::integer_sequence<int, 4, 4>;  // q_WU, q_WF

  ElbowHeldPose(ElbowAngle angle, Side side, double told, double sigma)
      : angle_(angle), s_(Sign(side)), told_(told), weight_(1 / sigma) {}

  template <typename T>
  void operator()(const T* const* x, T* r) const {
    using std::atan2, std::cos, std::sin;
    const auto angles = ElbowFlexionPronation(x[0], x[1], s_);
    const T error = (angle_ == ElbowAngle::kFlexion ? angles.flexion : angles.pronation) - T(told_);
    r[0] = T(weight_) * atan2(sin(error), cos(error));
  }

  void Differentiate(const double* const* x, double* const* J) const {
    const auto gradient = ElbowFlexionPronationGradient(x[0], x[1], s_);
    const bool flexion = angle_ == ElbowAngle::kFlexion;
    using Row = Eigen::Map<Eigen::RowVector3d>;
    Row{J[0]} = weight_ * (flexion ? gradient.flexion_U : gradient.pronation_U);
    Row{J[1]} = weight_ * (flexion ? gradient.flexion_F : gradient.pronation_F);
  }

 private:
  ElbowAngle angle_;
  double s_;
  double told_;
  double weight_;
};

class ElevationHeldPose {
 public:
  static constexpr int kResiduals = 1;
  using Blocks = std::integer_sequence<int, 4>;  // q_WU

  ElevationHeldPose(double told, double sigma)
      : cos_told_(std::cos(told)),
        weight_(1 / (sigma * std::max(std::sin(told), std::sin(sigma)))) {}

  template <typename T>
  void operator()(const T* const* x, T* r) const {
    const Eigen::Map<const Eigen::Quaternion<T>> q_WU(x[0]);
    r[0] = T(weight_) * (T(cos_told_) - (q_WU * Vector3T<T>(Vector3T<T>::UnitY())).z());
  }

  void Differentiate(const double* const* x, double* const* J) const {
    const Eigen::Map<const Eigen::Quaterniond> q_WU(x[0]);
    const Eigen::Vector3d up_U = q_WU.conjugate() * Eigen::Vector3d::UnitZ();
    Eigen::Map<Eigen::RowVector3d>{J[0]} =
        -weight_ * Eigen::Vector3d::UnitY().cross(up_U).transpose();
  }

 private:
  double cos_told_;
  double weight_;
};

// Requires axes x that are not upright.
class FacingHeldPose {
 public:
  static constexpr int kResiduals = 1;
  using Blocks = std::integer_sequence<int, 4, 4>;  // q_WG, q_WU

  explicit FacingHeldPose(double sigma) : weight_(1 / sigma) {}

  template <typename T>
  void operator()(const T* const* x, T* r) const {
    using std::atan2;
    const Vector3T<T> body = Front(x[0]), arm = Front(x[1]);
    r[0] = T(weight_) *
           atan2(body.x() * arm.y() - body.y() * arm.x(), body.x() * arm.x() + body.y() * arm.y());
  }

  void Differentiate(const double* const* x, double* const* J) const {
    Eigen::Map<Eigen::RowVector3d>{J[0]} = -weight_ * HeadingGradient(x[0]);
    Eigen::Map<Eigen::RowVector3d>{J[1]} = weight_ * HeadingGradient(x[1]);
  }

 private:
  template <typename T>
  static Vector3T<T> Front(const T* q_WB) {
    const Eigen::Map<const Eigen::Quaternion<T>> q(q_WB);
    return q * Vector3T<T>(Vector3T<T>::UnitX());
  }

  static Eigen::RowVector3d HeadingGradient(const double* q_WB) {
    const Eigen::Map<const Eigen::Quaterniond> q(q_WB);
    Eigen::Vector3d u = q.conjugate() * Eigen::Vector3d::UnitZ();
    const double upright = u.x();
    u.x() = 0.0;
    return u.transpose() / (1 - upright * upright);
  }

  double weight_;
};

}  // namespace brachium
