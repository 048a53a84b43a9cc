// Body axes: a residual of the world, seen from a segment.
//
//   r = R_WBᵀ r_W
//
// Frames    W world, B segment; r_W a residual of three world coordinates with equal weights.
// Unknowns  q_WB, then those of r_W.
// Weight    that of r_W: |r| = |r_W|.
// Jacobian  ∂r/∂φ = [r]x, ∂r/∂x = R_WBᵀ ∂r_W/∂x.
// Blind to  heading, now also in its derivatives. Turned with the whole arm by ψ, r_W becomes
//           r_W + ψ × r_W, from which JᵀJ claims the knowledge |ψ × r_W|² about a heading that the
//           cost does not depend on: tens of thousands of residuals then hold the heading where it
//           happens to be, the standard deviations believe it, and Gauss-Newton's steps creep.
#pragma once

#include "problems/residuals/cost.h"

namespace brachium {

template <typename World>
class InBodyAxes {
 public:
  static constexpr int kResiduals = World::kResiduals;
  static_assert(kResiduals == 3);

  template <int... kBlocks>
  static constexpr auto WithAttitude(std::integer_sequence<int, kBlocks...>) {
    return std::integer_sequence<int, 4, kBlocks...>();
  }
  using Blocks = decltype(WithAttitude(typename World::Blocks()));

  explicit InBodyAxes(World world) : world_(std::move(world)) {}

  template <typename T>
  void operator()(const T* const* x, T* r) const {
    Vector3T<T> r_W;
    world_(x + 1, r_W.data());
    Eigen::Map<Vector3T<T>>{r} = Eigen::Map<const Eigen::Quaternion<T>>(x[0]).conjugate() * r_W;
  }

  void Differentiate(const double* const* x, double* const* J) const {
    world_.Differentiate(x + 1, J + 1);
    const Eigen::Matrix3d R_BW =
        Eigen::Map<const Eigen::Quaterniond>(x[0]).conjugate().toRotationMatrix();
    Eigen::Vector3d r;
    (*this)(x, r.data());
    Eigen::Map<RowMajor<3, 3>>{J[0]} = Skew<double>(r);
    for (std::size_t i = 0; i < kVectors; ++i) {
      Eigen::Map<RowMajor<3, 3>> block(J[i + 1]);
      block = (R_BW * block).eval();
    }
  }

 private:
  static constexpr std::size_t kVectors = World::Blocks::size();

  World world_;
};

}  // namespace brachium
