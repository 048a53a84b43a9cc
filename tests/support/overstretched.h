// An arm that lies still with its elbow bent backwards, its flexion axis upright.
#pragma once

#include "problems/arm_problem.h"
#include "problems/rotation.h"

namespace brachium {

// Requires an upper arm and a forearm, sensors 0 and 1.
inline State Overstretched(const ArmProblem& problem) {
  State state = problem.PriorState();
  for (int knot = 0; knot < problem.size().knots; ++knot) {
    Eigen::Map<Eigen::Quaterniond>{state.Attitude(knot, 0)}.setIdentity();
    Eigen::Map<Eigen::Quaterniond>{state.Attitude(knot, 1)} =
        Exp<double>(Eigen::Vector3d(-20 * kDegree * Eigen::Vector3d::UnitZ()));
  }
  return state;
}

}  // namespace brachium
