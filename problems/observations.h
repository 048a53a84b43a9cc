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
struct HeldPose {
  double time = 0.0;  // [s]
  std::optional<double> elbow_flexion;
  std::optional<double> forearm_pronation;
  std::optional<double> shoulder_elevation;
  double sigma = 10 * kDegree;  // [rad]
};

// Instants at which a point of the arm is at one and the same place of the world, wherever that is.
struct Contact {
  std::string place;                 // what it is called
  Segment segment = Segment::kHand;  // whose distal joint touches: elbow, wrist, fingertip
  std::vector<double> times;         // [s]
  double sigma = 0.01;               // how far off the place a touch is, per axis [m]
  bool height_only = false;          // the same height, as on a table
};

struct Observations {
  ArmModel arm;
  std::vector<Recording> recordings;  // each segment at most once; the first one's clock rules
  std::vector<Interval> intervals;
  std::optional<HeldPose> start_pose;  // what methods that integrate or filter start from
  std::optional<HeldPose> end_pose;
  std::vector<Contact> contacts;  // of segments that wear sensors, in a chain of two or more
  double gravity = kGravity;      // where it was recorded; on Earth 9.78 to 9.83 [m/s^2]
};

}  // namespace brachium
