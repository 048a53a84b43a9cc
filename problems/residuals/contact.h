// Contact: at several instants a point of the arm is at one and the same place of the world.
//
//   place    r = (R_nᵀ (c - p - Σ_{i<n} R_i d_i) - d_n) / σ
//   height   r = (e_z · (p + Σ_{i≤n} R_i d_i) - h) / σ
//
// Frames    W world, e_z up; B_1 ... B_n the segments from the root to the one whose distal joint
//           touches: elbow, wrist or fingertip.
// Unknowns  q_1 ... q_n: attitudes q_WB; p: root joint in W [m]; c: the place in W [m], or h: its
//           height [m]; d_n, d_1 ... d_n-1 (height: d_1 ... d_n): from a segment's proximal to its
//           distal joint in its axes [m]. c and h are constants of the trial without a prior: the
//           first touch says where the place is, every further one where the arm is.
// Weight    σ [m] per axis: how far from the place a touch is, each on its own, with the way of the
//           point within half a step of the knots.
// Jacobian  place: as segment_chain.h, for a place is where the segments put the joint as it is with a
//           sensor. Height, with u_i = R_iᵀ e_z: σ ∂r/∂φ_i = (d_i × u_i)ᵀ, σ ∂r/∂p = e_zᵀ,
//           σ ∂r/∂h = -1, σ ∂r/∂d_i = u_iᵀ.
// Axes      a place is looked at from the last segment; why not from the world: in_body_axes.h. c
//           turns with the whole arm, so neither the cost nor JᵀJ knows anything of that turn.
// Blind to  heading and place of the whole, its places included; where there is but one touch, to
//           everything. The shoulder's way and the arm's posture share what is left.
// Source    a place that is found again without a map closes a loop: Thrun & Montemerlo, Int. J.
//           Robotics Research 25 (2006).
#pragma once

#include "problems/residuals/segment_chain.h"

namespace brachium {

template <int kChain>
using ContactPlace = SegmentChain<kChain>;

// The blocks: 4 for each attitude, root, height, joint vectors.
template <int... kRotation, int... kVector>
constexpr auto ContactHeightBlocks(std::integer_sequence<int, kRotation...>,
                                   std::integer_sequence<int, kVector...>) {
  return std::integer_sequence<int, (kRotation * 0 + 4)..., 3, 1, (kVector * 0 + 3)...>();
}

// kChain: number of segments from the root to the point, 1 to 4.
template <int kChain>
class ContactHeight {
 public:
  static constexpr int kResiduals = 1;
  using Blocks = decltype(ContactHeightBlocks(std::make_integer_sequence<int, kChain>(),
                                              std::make_integer_sequence<int, kChain>()));

  explicit ContactHeight(double sigma) : weight_(1 / sigma) {}

  template <typename T>
  void operator()(const T* const* x, T* r) const {
    T height = x[kRoot][2] - x[kHeight][0];
    for (int i = 0; i < kChain; ++i)
      height += (Eigen::Map<const Eigen::Quaternion<T>>(x[i]) * Vector<T>(x[kFirst + i])).z();
    r[0] = T(weight_) * height;
  }

  void Differentiate(const double* const* x, double* const* J) const {
    using Row = Eigen::Map<Eigen::RowVector3d>;
    for (int i = 0; i < kChain; ++i) {
      const Eigen::Map<const Eigen::Quaterniond> q_WB(x[i]);
      const Eigen::Vector3d up_B = q_WB.conjugate() * Eigen::Vector3d::UnitZ();
      const Eigen::Vector3d lever_B = Vector<double>(x[kFirst + i]);
      Row{J[i]} = weight_ * lever_B.cross(up_B).transpose();
      Row{J[kFirst + i]} = weight_ * up_B.transpose();
    }
    Row{J[kRoot]} = weight_ * Eigen::RowVector3d::UnitZ();
    J[kHeight][0] = -weight_;
  }

 private:
  template <typename T>
  using Vector = Eigen::Map<const Vector3T<T>>;
  static constexpr int kRoot = kChain, kHeight = kRoot + 1, kFirst = kHeight + 1;

  double weight_;
};

}  // namespace brachium
