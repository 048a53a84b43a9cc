// One sensor as a free body: its gyroscope integrated once, its accelerometer twice.
//
//   R' = R dR,   v' = v + g D + R dv,   p' = p + v D + g D²/2 + R dp     (preintegration.h)
#pragma once

#include <vector>

#include "problems/preintegration.h"

namespace brachium {

struct FreeStart {
  double time = 0.0;  // [s]
  Eigen::Quaterniond q_WB = Eigen::Quaterniond::Identity();
  Eigen::Vector3d gyro_bias = Eigen::Vector3d::Zero();  // [rad/s]
  double gravity = kGravity;                            // [m/s^2]
};

// NaN at instants outside of the span.
struct FreeMotion {
  std::vector<Eigen::Quaterniond> q_WB;
  std::vector<Eigen::Vector3d> p_W;  // of the sensor, from where it was at the start [m]
};

// From rest at `start` until `end`, at increasing times [s]. The samples must cover that span.
FreeMotion IntegrateFreely(const Preintegrator& samples, const FreeStart& start, double end,
                           const std::vector<double>& times);

}  // namespace brachium
