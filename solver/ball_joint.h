// Two sensors as bodies on a ball joint of which nothing is known.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "problems/observations.h"

namespace brachium {

// A is the sensor on the upper arm, B the one on the forearm; all in sensor axes.
struct BallJoint {
  static constexpr double kPeriod = 0.1;  // [s]
  std::vector<double> time;               // [s], kPeriod apart but for gaps
  std::vector<Eigen::Matrix3d> R_AB;      // forearm sensor in upper-arm sensor
  Eigen::Vector3d shoulder_to_elbow_A = Eigen::Vector3d::Zero();  // [m]
  Eigen::Vector3d elbow_to_sensor_A = Eigen::Vector3d::Zero();
  Eigen::Vector3d elbow_to_sensor_B = Eigen::Vector3d::Zero();
  double upper_sd = 0.0;    // of shoulder_to_elbow_A, per axis [m]
  double fore_sd = 0.0;     // of elbow_to_sensor_B, per axis [m]
  double heading_sd = 0.0;  // of B against A, median over the trial [rad]
};

// The smoother's answer for the two recordings. Absent, with the reason, where it cannot be had or is
// not to be trusted.
std::optional<BallJoint> FollowBallJoint(const Recording& upper_arm, const Recording& forearm,
                                         Side side, std::string* why);

}  // namespace brachium
