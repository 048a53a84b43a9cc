// What one body-worn inertial sensor recorded, and how noisy it is known to be.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "problems/arm_model.h"

namespace brachium {

// Noise as one-sided densities N (the data-sheet figure); the two-sided density is N^2/2.
// Presets carry the values of problems/README.md, "Sensor noise".
struct ImuNoise {
  double gyro_density = 0.0127 * kDegree;    // [rad/s/sqrt(Hz)]
  double gyro_bias_sigma = 0.5 * kDegree;    // turn-on [rad/s]
  double gyro_bias_walk = 2.8e-4 * kDegree;  // [rad/s/sqrt(s)]
  double accel_density = 243e-6 * kGravity;  // [m/s^2/sqrt(Hz)]
  double accel_bias_sigma = 0.05;            // [m/s^2]
};

ImuNoise MtwNoise();  // Xsens MTw and sensors of its class
ImuNoise MtxNoise();  // Xsens MTx, MT9B: the sensors of the 2007 and 2008 papers
std::optional<ImuNoise> NoiseFromPreset(const std::string& name);  // "mtw", "mtx"

// A sensor's place on its segment: x_B = R_BS x_S, position from the segment's proximal joint.
struct Mounting {
  Eigen::Quaterniond q_BS = Eigen::Quaterniond::Identity();
  double q_sigma = 2 * kDegree;                      // per axis [rad]
  Eigen::Vector3d p_BS_B = Eigen::Vector3d::Zero();  // [m]
  double p_sigma = 0.01;                             // per axis [m]
};

// Samples of one sensor on its own clock instants. A sample is the mean over its cell; `time` is
// the cell's centre; cell edges lie midway between sample times. Times strictly increase; all
// samples are finite. Lost samples are simply absent: a step longer than the usual one is a gap.
struct Recording {
  Segment segment = Segment::kUpperArm;
  std::vector<double> time;              // [s]
  std::vector<Eigen::Vector3d> gyr_S;    // angular rate [rad/s]
  std::vector<Eigen::Vector3d> acc_S;    // specific force [m/s^2]: +g upward at rest
  std::vector<Eigen::Vector3d> mag_S;    // magnetic field, any unit; empty when absent
  std::vector<Eigen::Quaterniond> q_WS;  // fused orientation of the maker; empty when absent
  ImuNoise noise;
  std::optional<Mounting> mounting;  // absent: not calibrated
  // Usual step of the whole, where this is a part of a recording [s]; 0: that of these samples.
  double period = 0.0;

  std::size_t size() const { return time.size(); }
};

// The usual step between samples: the median of the differences [s], of the whole recording where
// this is a part of it. Needs two samples.
double SamplingPeriod(const Recording& recording);

}  // namespace brachium
