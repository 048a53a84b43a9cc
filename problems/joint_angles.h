// Clinical joint angles of an arm, read from relative rotations. Derived, never stored. All in rad.
//
// Segment axes after ISB on both sides: X anterior (volar), Y proximal, Z to the person's right. A
// left arm is mirrored in the sagittal plane and then read by the right arm's formulas, so that the
// same movement has the same angles on both sides.
// Source: Wu et al., J. Biomech. 38 (2005) 981-992; signs as in problems/README.md.
#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "problems/segment.h"

namespace brachium {

// Right arm: R_UF = Rz(flexion) Rx(-carrying) Ry(pronation).
struct ElbowAngles {
  double flexion = 0.0;    // (-π, π]
  double carrying = 0.0;   // [-π/2, π/2], valgus positive
  double pronation = 0.0;  // (-π, π]: 0 fully supinated, π/2 thumb forward on a hanging arm
};

// Right arm: R_TU = Ry(plane) Rx(-elevation) Ry(rotation).
struct ShoulderAngles {
  std::optional<double> plane;     // 0 abduction, π/2 forward flexion; absent close to the poles
  double elevation = 0.0;          // [0, π]
  std::optional<double> rotation;  // internal positive; absent close to the poles
};

// Right arm: R_FH = Rz(flexion) Rx(deviation) Ry(rotation).
struct WristAngles {
  double flexion = 0.0;    // (-π, π], palmar positive
  double deviation = 0.0;  // [-π/2, π/2], ulnar positive
  double rotation = 0.0;   // (-π, π], the sense of pronation
};

// Below this sine of the elevation, plane and rotation are not told apart: they are left absent.
inline constexpr double kShoulderPoleSine = 0.1;

// The rotation of the mirror image, M R M with M = diag(1, 1, -1): a left arm's made a right arm's.
Eigen::Quaterniond Mirrored(const Eigen::Quaterniond& q_AB);

// Where flexion and pronation turn about one axis (|carrying| = π/2), all is called flexion.
ElbowAngles ElbowAnglesFrom(const Eigen::Quaterniond& q_UF, Side side);

// q_UF, the inverse of ElbowAnglesFrom.
Eigen::Quaterniond ElbowRotation(const ElbowAngles& angles, Side side);

ShoulderAngles ShoulderAnglesFrom(const Eigen::Quaterniond& q_TU, Side side);

// Angle of the upper arm's long axis from hanging, [0, π]. Asks only for the vertical of W (z up);
// no pole, the same on both sides.
double ShoulderElevation(const Eigen::Quaterniond& q_WU);

WristAngles WristAnglesFrom(const Eigen::Quaterniond& q_FH, Side side);

}  // namespace brachium
