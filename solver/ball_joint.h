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
  std::vector<double> time;           // [s], every 0.1 s but for gaps
  std::vector<Eigen::Matrix3d> R_AB;  // forearm sensor in upper-arm sensor
  Eigen::Vector3d shoulder_to_elbow_A = Eigen::Vector3d::Zero();  // [m]
  Eigen::Vector3d elbow_to_sensor_A = Eigen::Vector3d::Zero();
  Eigen::Vector3d elbow_to_sensor_B = Eigen::Vector3d::Zero();
  double upper_sd = 0.0;    // of shoulder_to_elbow_A, mean of the axes across it [m]
  double fore_sd = 0.0;     // of elbow_to_sensor_B, the same [m]
  double heading_sd = 0.0;  // of B against A, median over the trial [rad]
};

// The smoother's answer for the recordings of upper arm and forearm: mountings of identity, joints and sensors 0.3 m (sd)
// from anywhere, no adduction, and a shoulder that strays as far, as people lean and walk. Held where
// it is, an elbow would have to make up for that: lever arms shrink, and scales take their part.
// Absent, with the reason, where it cannot be had or is not to be trusted.
// Source: the joint that both sensors accelerate with, Seel, Schauer & Raisch, IEEE MSC (2012), for its
//         place, and Weygers & Kok, IEEE Sensors J. 20 (2020), for the relative heading; here in the
//         integral form of segment_chain.h.
std::optional<BallJoint> FollowBallJoint(const Observations& observations, std::string* why);

}  // namespace brachium
