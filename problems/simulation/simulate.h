// From a scenario to a trial: what body-worn sensors would have recorded, and the truth beside it.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "problems/simulation/scenario.h"
#include "problems/simulation/sensor_errors.h"
#include "problems/trial.h"

namespace brachium {

// The trial's reference holds the segments' (bones') true attitudes, not the sensors', and the
// joints "shoulder", "elbow", "wrist" and, where a hand is worn, the fingertip as "hand", regularly
// at the first recording's rate.
struct SimulatedTrial {
  Trial trial;
  std::vector<TrueValue> truth;

  // What sensors whose attitudes were known exactly would say of their segments, through the told
  // mountings, at the reference's times: off the reference by mounting, skin and markers, which no
  // method can tell. An empty list where a mounting is not told.
  std::map<Segment, std::vector<Eigen::Quaterniond>> sensors_q_VB;

  // The value of that name; absent names are the programmer's mistake and throw std::out_of_range.
  const std::vector<double>& True(const std::string& name) const;
};

// Each sample is the mean over its cell of the exact angular rate and specific force (four-point
// Gauss-Legendre), through scale and misalignment, plus bias, plus white noise of variance
// N^2/(2h). Same scenario and options, same bits. A left arm is the exact mirror image of the right
// arm's trial. Requires options.IsValid().
SimulatedTrial Simulate(const Scenario& scenario, const SimulationOptions& options);

}  // namespace brachium
