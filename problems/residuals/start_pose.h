// Start pose: joint angles that the person was asked to hold at one instant.
//
//   elbow      r = (angle(R_UF) - told) / σ      one residual for flexion, one for pronation
//   elevation  r = (cos(told) - y_U · e_z) / (σ max(sin(told), sin σ))
//
// Frames    U upper arm, F forearm, W world; angles as in elbow_angles.h; elevation is the angle of
//           the upper arm from hanging, y_U its long axis (proximal), e_z up.
// Unknowns  q_WU, q_WF; q_WU.
// Weight    σ [rad]: how well people take a pose, about 10 deg; an angle that was not told has none.
// Jacobian  elbow_angles.h, with the difference taken to the nearest turn;
//           ∂(y_U·e_z)/∂φ_U = (y × R_UW e_z)ᵀ.
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

class ElbowStartPose {
 public:
  static constexpr int kResiduals = 1;
  using Blocks = std::integer_sequence<int, 4, 4>;  // q_WU, q_WF

  ElbowStartPose(ElbowAngle angle, Side side, double told, double sigma)
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

class ElevationStartPose {
 public:
  static constexpr int kResiduals = 1;
  using Blocks = std::integer_sequence<int, 4>;  // q_WU

  ElevationStartPose(double told, double sigma)
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

}  // namespace brachium
