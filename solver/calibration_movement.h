// One movement that somebody was asked for and labelled: about which axis the sensor turned, how far,
// and which way was up before and after.
//
//   axis   the eigenvector of the largest eigenvalue of Σ w wᵀ over the samples with |w| above a fifth
//          of the fastest: total least squares, every direction of error alike; along the turning
//   angle  ∫ w · axis dt over the whole interval
//   up     mean specific force of the first and of the last quarter of a second, a unit vector
// w is the angular rate less its bias, all in sensor axes.
#pragma once

#include <string>
#include <vector>

#include "problems/observations.h"

namespace brachium {

struct CalibrationLimits {
  double least_turn = 0.0;      // of a movement [rad]
  double largest_misfit = 0.0;  // of directions that should agree, or be at right angles [rad]
};

struct CalibrationMovement {
  Eigen::Vector3d axis_S = Eigen::Vector3d::Zero();
  double angle = 0.0;  // [rad]
  Eigen::Vector3d up_before_S = Eigen::Vector3d::Zero();
  Eigen::Vector3d up_after_S = Eigen::Vector3d::Zero();
};

// The movements of that label which can be used; for the others a sentence each in `faults`: too few
// samples, no rest at an end, too small, or about no single axis.
std::vector<CalibrationMovement> MeasureMovements(const Recording& recording,
                                                  const std::vector<Interval>& intervals,
                                                  const std::string& label,
                                                  const CalibrationLimits& limits,
                                                  std::vector<std::string>* faults);

// A direction told several times over.
struct MeanDirection {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();  // a unit vector
  double spread = 0.0;                             // rms angle from the mean [rad]
  double worst = 0.0;                              // [rad]
  int count = 0;
};

MeanDirection Average(const std::vector<Eigen::Vector3d>& directions);

double AngleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

// For messages: "12 deg".
std::string Degrees(double angle);

}  // namespace brachium
