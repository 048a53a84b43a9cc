// Joints over time, as an estimate and the reference of its trial have them at the same instants.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "problems/cycles.h"
#include "problems/estimate.h"
#include "problems/trial.h"

namespace brachium {

// A column per instant of the reference, NaN where unknown [m].
struct PointSeries {
  std::vector<double> time;
  Eigen::Matrix3Xd estimate, reference;
};

// The joints of these names after the one rotation and shift of all of them together that take the
// estimate closest to the reference, without scale (Umeyama); with `from`, each less that joint.
std::vector<PointSeries> AlignedPoints(const Estimate& estimate, const Reference& reference,
                                       const std::vector<std::string>& joints,
                                       const std::string& from = "");

// An angle of joint_angles.h by its name, at the reference's instants: one row each [rad].
struct AngleSeries {
  std::vector<double> time;
  Series estimate, reference;
};
AngleSeries AnglesOf(const Estimate& estimate, const Reference& reference, const std::string& name);

// The labelled cycles of a trial, or else those of the signal.
std::vector<Interval> CyclesOf(const Trial& trial, const std::vector<double>& time,
                               const Series& signal);

}  // namespace brachium
