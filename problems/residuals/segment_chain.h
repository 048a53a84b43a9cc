// Chain of segments: a sensor is where the segments between the arm's root and it put it.
//
//   r = (R_nᵀ (P - p - Σ R_i d_i) - l) / σ
//
// Frames    W world; B_1 ... B_n the segments from the root to the one that wears the sensor.
// Unknowns  q_1 ... q_n: attitudes q_WB; p: root joint in W [m]; P: the sensor in W [m]; l: the
//           sensor in the last segment's axes [m]; d_1 ... d_n-1: from a segment's proximal to its
//           distal joint in its axes [m].
// Weight    σ [m]: the sensor's quiver against its place on the chain, white over the time that the
//           knot stands for: sqrt(2 σ_q² τ / D). Skin, straps, a joint with play and a vibrating
//           machine move a sensor by a bounded way, so their acceleration grows with the square of
//           the frequency: it must not be taken for evidence as good as slow motion's.
// Jacobian  σ ∂r/∂φ_n = [R_nᵀ (P - p - Σ R_i d_i)]x, σ ∂r/∂φ_i = R_nᵀ R_i [d_i]x, σ ∂r/∂p = -R_nᵀ,
//           σ ∂r/∂P = R_nᵀ, σ ∂r/∂d_i = -R_nᵀ R_i, σ ∂r/∂l = -I.
// Axes      those of the last segment; why not the world's: in_body_axes.h.
// Blind to  the heading and the place of the whole; lengths where no sensor is farther along.
// Source    the segment lengths of Zhou et al., Med. Eng. Phys. 30 (2008), eqs. 6 and 7, on places
//           instead of accelerations; the shared joint as in Weygers & Kok, IEEE Sensors J. 20 (2020).
#pragma once

#include "problems/residuals/cost.h"

namespace brachium {

// The blocks of a chain: 4 for each attitude, then vectors of 3.
template <int... kRotation, int... kVector>
constexpr auto SegmentChainBlocks(std::integer_sequence<int, kRotation...>,
                                  std::integer_sequence<int, kVector...>) {
  return std::integer_sequence<int, (kRotation * 0 + 4)..., (kVector * 0 + 3)...>();
}

// kChain: number of segments from the root to the sensor, 1 to 4.
template <int kChain>
class SegmentChain {
 public:
  static constexpr int kResiduals = 3;
  using Blocks = decltype(SegmentChainBlocks(std::make_integer_sequence<int, kChain>(),
                                             std::make_integer_sequence<int, 2 + kChain>()));

  explicit SegmentChain(double sigma) : weight_(1 / sigma) {}

  template <typename T>
  void operator()(const T* const* x, T* r) const {
    Eigen::Map<Vector3T<T>>{r} = T(weight_) * (FromLastJoint<T>(x) - Vector<T>(x[kSensor]));
  }

  void Differentiate(const double* const* x, double* const* J) const {
    const Eigen::Matrix3d wR_nT = weight_ * Last<double>(x).conjugate().toRotationMatrix();
    for (int i = 0; i + 1 < kChain; ++i) {
      const Eigen::Matrix3d wR = wR_nT * Rotation<double>(x[i]).toRotationMatrix();
      Block{J[i]} = wR * Skew<double>(Vector<double>(x[Lever(i)]));
      Block{J[Lever(i)]} = -wR;
    }
    Block{J[kChain - 1]} = weight_ * Skew<double>(FromLastJoint<double>(x));
    Block{J[kSensor]} = -weight_ * Eigen::Matrix3d::Identity();
    Block{J[kRoot]} = -wR_nT;
    Block{J[kPlace]} = wR_nT;
  }

 private:
  template <typename T>
  using Rotation = Eigen::Map<const Eigen::Quaternion<T>>;
  template <typename T>
  using Vector = Eigen::Map<const Vector3T<T>>;
  using Block = Eigen::Map<RowMajor<3, 3>>;

  template <typename T>
  static Rotation<T> Last(const T* const* x) {
    return Rotation<T>(x[kChain - 1]);
  }

  // The sensor in the last segment's axes, from its proximal joint [m].
  template <typename T>
  static Vector3T<T> FromLastJoint(const T* const* x) {
    Vector3T<T> d_W = Vector<T>(x[kPlace]) - Vector<T>(x[kRoot]);
    for (int i = 0; i + 1 < kChain; ++i) d_W -= Rotation<T>(x[i]) * Vector<T>(x[Lever(i)]);
    return Last<T>(x).conjugate() * d_W;
  }

  // Places of the blocks; the lever of segment i is its joint vector, of the last one the sensor's.
  static constexpr int kRoot = kChain, kPlace = kRoot + 1, kSensor = kPlace + 1;
  static constexpr int Lever(int i) { return i + 1 == kChain ? kSensor : kSensor + 1 + i; }

  double weight_;
};

}  // namespace brachium
