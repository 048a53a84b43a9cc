// What a sensor says when it is moved least: its noise, its gyroscope's bias, its gravity.
#pragma once

#include <Eigen/Core>

#include "problems/imu.h"

namespace brachium {

struct QuietestSecond {
  double start = 0.0;                                    // [s]
  Eigen::Vector3d mean_rate = Eigen::Vector3d::Zero();   // [rad/s]
  Eigen::Vector3d mean_force = Eigen::Vector3d::Zero();  // [m/s^2]
  double rate_noise = 0.0;                               // rms about the mean over all axes [rad/s]
  double force_noise = 0.0;                              // [m/s^2]
};

// The second over which the angular rate varies least; of a shorter recording, all of it.
QuietestSecond FindQuietestSecond(const Recording& recording);

}  // namespace brachium
