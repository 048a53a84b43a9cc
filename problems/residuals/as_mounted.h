// As mounted: a residual about segments whose sensors are turned against how they were told to sit.
//
//   R_WB = R_WC Exp(ε)ᵀ,   R_BS = Exp(ε) R_told,   ε = δ + w_k
//
// Frames    B the segment; C where it would be, were its sensor mounted as told: what the sensor
//           shows, R_WS = R_WC R_told.
// Unknowns  those of the residual, with q_WC for each q_WB; then the δ of each and the w_k of each,
//           B axes [rad]: for the whole trial, and what skin and muscle add at the moment.
// Weight    that of the residual.
// Jacobian  ∂φ_B/∂φ_C = Exp(ε), ∂φ_B/∂δ = ∂φ_B/∂w_k = -Jr(-ε).
// Blind to  what the residual is blind to. Sensors alone know nothing of δ; an elbow shows where its
//           two axes lie in them, but neither the zero of flexion, a turn about the flexion axis, nor
//           that of pronation, a turn about the forearm: of these δ keeps its prior.
// Source    which of a hinge's axes sensors show: Seel, Raisch & Schauer, Sensors 14 (2014).
#pragma once

#include <algorithm>
#include <array>

#include "problems/residuals/cost.h"

namespace brachium {

// The blocks of rotations come first in the residual's.
template <typename Segments>
class AsMounted {
  template <int... kBlocks>
  static constexpr int Rotations(std::integer_sequence<int, kBlocks...>) {
    return (0 + ... + (kBlocks == 4 ? 1 : 0));
  }
  static constexpr int kRotations = Rotations(typename Segments::Blocks());
  static constexpr int kInner = static_cast<int>(Segments::Blocks::size());

  template <int... kBlocks, int... kTurn>
  static constexpr auto WithTurns(std::integer_sequence<int, kBlocks...>,
                                  std::integer_sequence<int, kTurn...>) {
    return std::integer_sequence<int, kBlocks..., (kTurn * 0 + 3)...>();
  }

 public:
  static constexpr int kResiduals = Segments::kResiduals;
  using Blocks = decltype(WithTurns(typename Segments::Blocks(),
                                    std::make_integer_sequence<int, 2 * kRotations>()));

  explicit AsMounted(Segments segments) : segments_(std::move(segments)) {}

  template <typename T>
  void operator()(const T* const* x, T* r) const {
    segments_(OfSegments<T>(x).blocks.data(), r);
  }

  void Differentiate(const double* const* x, double* const* J) const {
    segments_.Differentiate(OfSegments<double>(x).blocks.data(), J);
    for (int i = 0; i < kRotations; ++i) {
      const Eigen::Vector3d turn = Turn(x, i);
      const Block J_B = Eigen::Map<Block>(J[i]);
      Eigen::Map<Block>{J[kInner + i]} = -J_B * RightJacobian(-turn);
      Eigen::Map<Block>{J[kInner + kRotations + i]} = Eigen::Map<Block>(J[kInner + i]);
      Eigen::Map<Block>{J[i]} = J_B * Exp<double>(turn).toRotationMatrix();
    }
  }

 private:
  using Block = RowMajor<kResiduals, 3>;

  template <typename T>
  static Vector3T<T> Turn(const T* const* x, int i) {
    using Vector = Eigen::Map<const Vector3T<T>>;
    return Vector(x[kInner + i]) + Vector(x[kInner + kRotations + i]);
  }

  // The residual's own blocks.
  template <typename T>
  struct OfSegments {
    std::array<Eigen::Quaternion<T>, kRotations> q_WB;
    std::array<const T*, kInner> blocks;

    explicit OfSegments(const T* const* x) {
      std::copy_n(x, kInner, blocks.begin());
      for (int i = 0; i < kRotations; ++i) {
        const auto at = static_cast<std::size_t>(i);
        q_WB[at] = Eigen::Map<const Eigen::Quaternion<T>>(x[i]) * Exp<T>(-Turn<T>(x, i));
        blocks[at] = q_WB[at].coeffs().data();
      }
    }
  };

  Segments segments_;
};

}  // namespace brachium
