// How an arm (or a rig that stands for one) is built: lengths, joints, priors. No measurement.
#pragma once

#include <Eigen/Core>
#include <map>
#include <numbers>

#include "problems/segment.h"

namespace brachium {

inline constexpr double kDegree = std::numbers::pi / 180.0;  // [rad]
inline constexpr double kGravity = 9.81;                     // [m/s^2]

// Where a segment's distal joint lies, in segment axes from the proximal joint [m].
// An anatomical segment of length L has it at (0, -L, 0); a girdle or a rig anywhere.
struct SegmentGeometry {
  Eigen::Vector3d p_distal_B = Eigen::Vector3d::Zero();  // [m]
  double sigma = 0.005;                                  // of each component [m]; a tape: 5 mm
};

// Carrying angle (valgus positive, both sides) k = k0 + k1 (y_U . y_F); see elbow_adduction.h.
struct ElbowModel {
  bool adduction_constraint = true;           // false: a ball joint, or a rig
  double carrying_angle = 10 * kDegree;       // k0 [rad], adults: 5-15 deg
  double carrying_angle_sigma = 8 * kDegree;  // [rad]
  double carrying_slope_sigma = 5 * kDegree;  // of k1 about zero [rad]
};

// The shoulder as a process about a constant mean; see shoulder_process.h.
struct ShoulderModel {
  double sigma = 0.03;             // [m] per axis
  double correlation_time = 10.0;  // [s]
};

struct ArmModel {
  Side side = Side::kRight;
  std::map<Segment, SegmentGeometry> segments;  // every segment that wears a sensor has one
  ElbowModel elbow;
  ShoulderModel shoulder;
};

// Anatomical default for a segment that no one measured (adult mean, sigma 2 cm).
SegmentGeometry DefaultGeometry(Segment segment, Side side);

}  // namespace brachium
