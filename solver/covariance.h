// What the information matrix of a solved trial says: how certain each unknown is.
#pragma once

#include <Eigen/Core>
#include <map>
#include <vector>

#include "problems/arm_problem.h"
#include "solver/front_sweep.h"
#include "solver/pose_covariance.h"

namespace brachium {

struct Certainty {
  std::map<int, Eigen::VectorXd> constant_sd;  // by unknown: constants and gyro biases, their unit
  std::vector<double> root_sd;                 // of each knot's arm root, largest axis [m]
  // Of each sensor's start heading against the one before it [rad]; 0 for the first.
  std::vector<double> start_heading_sd;
  std::vector<int> singular;  // unknowns that the information does not determine
};

// By the last pass of `workspace`, which was over the whole trial at `state` as it stands, with the
// terms that stand. Cost and memory are linear in its length. `poses`, unless null, is filled with
// what it collects.
Certainty AssessCertainty(const ArmProblem& problem, const State& state, ChainWorkspace& workspace,
                          PoseCovariance* poses = nullptr);

// Sd of an unknown of one number by the last pass of `workspace`, to a tenth, at the cost of some
// passes; for one that a plan does not know, 0.
double DrawnSd(ChainWorkspace& workspace, int unknown);

}  // namespace brachium
