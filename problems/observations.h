// All that an estimator may see. The reference is not part of it, so it cannot leak into an
// estimate.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problems/arm_model.h"
#include "problems/imu.h"

namespace brachium {

struct Interval {
  std::string label;   // "rest", "calibration:...", "task:NAME", "cycle:NAME"
  double start = 0.0;  // [s]
  double end = 0.0;    // [s]
};

// Joint angles that the person held at one instant [rad], each known to `sigma`; absent = unknown.
struct StartPose {
  double time = 0.0;  // [s]
  std::optional<double> elbow_flexion;
  std::optional<double> forearm_pronation;
  std::optional<double> shoulder_elevation;
  double sigma = 10 * kDegree;  // [rad]
};

struct Observations {
  ArmModel arm;
  std::vector<Recording> recordings;  // each segment at most once; the first one's clock rules
  std::vector<Interval> intervals;
  std::optional<StartPose> start_pose;
  double gravity = kGravity;  // where it was recorded; on Earth 9.78 to 9.83 [m/s^2]
};

}  // namespace brachium
