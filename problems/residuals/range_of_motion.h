// Range of motion: an elbow neither bends backwards nor beyond its stop. One-sided.
//
//   r = max(0, flexion - upper) / σ + min(0, flexion - lower) / σ
//
// Frames    flexion of R_UF as in elbow_angles.h.
// Unknowns  q_WU, q_WF. Weight σ [rad]: how softly the stop gives way. Jacobian that of flexion where
//           a limit is passed, else zero.
// Blind to  everything inside the range. It tells the two relative headings apart that a hinge allows.
// Source    limits: -5 deg (hyperextension) to 160 deg, wider than the clinical norms of Boone & Azen,
//           J. Bone Joint Surg. 61-A (1979).
#pragma once

#include "problems/residuals/cost.h"
#include "problems/residuals/elbow_angles.h"

namespace brachium {

class ElbowRangeOfMotion {
 public:
  static constexpr int kResiduals = 1;
  using Blocks = std::integer_sequence<int, 4, 4>;  // q_WU, q_WF

  ElbowRangeOfMotion(double lower, double upper, double sigma)
      : lower_(lower), upper_(upper), weight_(1 / sigma) {}

  template <typename T>
  void operator()(const T* const* x, T* r) const {
    const T flexion = ElbowFlexionPronation(x[0], x[1], 1.0).flexion;
    if (flexion > T(upper_))
      r[0] = T(weight_) * (flexion - T(upper_));
    else if (flexion < T(lower_))
      r[0] = T(weight_) * (flexion - T(lower_));
    else
      r[0] = T(0);
  }

  void Differentiate(const double* const* x, double* const* J) const {
    using Row = Eigen::Map<Eigen::RowVector3d>;
    const double flexion = ElbowFlexionPronation(x[0], x[1], 1.0).flexion;
    if (flexion >= lower_ && flexion <= upper_) {
      Row{J[0]}.setZero();
      Row{J[1]}.setZero();
      return;
    }
    const auto gradient = ElbowFlexionPronationGradient(x[0], x[1], 1.0);
    Row{J[0]} = weight_ * gradient.flexion_U;
    Row{J[1]} = weight_ * gradient.flexion_F;
  }

 private:
  double lower_, upper_, weight_;
};

}  // namespace brachium
