// A sensor as it sits on a moving arm: what an ideal one would measure at any instant.
#pragma once

#include <array>

#include "problems/imu.h"
#include "problems/simulation/scenario.h"
#include "problems/simulation/sensor_errors.h"

namespace brachium {

// Where a sensor sits when nobody is precise, on the right arm: the upper arm's laterally near the
// elbow, the forearm's dorsally near the wrist (as Luinge wears them), the girdle's on the shoulder
// blade, the hand's on its back (as Bai wears them), turned up to 20 deg from the segment's axes'
// nearest directions at random. `distal` is the segment's distal joint.
Mounting DrawMounting(Segment segment, const Eigen::Vector3d& distal, Draws& draws);

// How the sensor moves on its segment: turning R_BB' = Ry Rx Rz [rad] and shift [m], segment axes.
struct Wobble {
  std::array<Motion, 3> turn;   // about x, y, z
  std::array<Motion, 3> shift;  // along x, y, z
  Motion envelope;              // 0 at both rests, 1 between
  bool present = false;
};

Wobble DrawWobble(const SoftTissue& soft_tissue, Segment segment, double duration, Draws& draws);

// The wobble's turning at one instant.
TurningFrame TurnOf(const Wobble& wobble, double t);

struct WornSensor {
  Segment segment = Segment::kUpperArm;
  Mounting mounting;  // true
  Wobble wobble;
};

// Angular rate omega_WS_S [rad/s] and specific force f_S = R_SW (a_W - g_W) [m/s^2], with the pose
// that they belong to.
struct SensorInstant {
  Eigen::Vector3d gyr_S, acc_S;
  Eigen::Quaterniond q_WS;
  MovingPoint point_W;
};

SensorInstant At(const WornSensor& sensor, const Scenario& scenario, double t);

}  // namespace brachium
