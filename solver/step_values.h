// The values of a plan's variables: to go back to, and to step from.
//
// A step d is linear, but what turns moves its sensors on circles. Added as it is, a step that turns
// the arm by ψ leaves its sensors off by ψ²/2 of their distance from the joint, stiff relations
// resent that, and a search for a heading that little holds creeps. So places follow the curve:
//   p <- p + s d_p + c,   c = chain(x ⊞ s d) - chain(x) - s J_chain d,
// chain(x): where the segments put the sensor; and velocities get the slope of c over time. To first
// order in d nothing changes.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "solver/front_plan.h"

namespace brachium {

class StepValues {
 public:
  // `state`: the one that the plan points into. All must outlive this.
  StepValues(const ArmProblem& problem, const State& state, const FrontPlan& plan);

  void Save();
  void Restore() const;

  // The saved values and `share` of the step, which holds all columns of the plan.
  void Set(const std::vector<double>& step, double share);

 private:
  using Vectors = std::vector<Eigen::Vector3d>;

  void SetLinear(const std::vector<double>& step, double share) const;
  void PlacesOnChain(Vectors& places) const;
  void FollowTheChain() const;
  void Add(int unknown, const Eigen::Vector3d& more) const;

  const ArmProblem& problem_;
  const State& state_;
  const FrontPlan& plan_;
  std::vector<double> saved_;
  int first_knot_ = 0, knots_ = 0;        // whose places are variables
  Vectors here_, ahead_, behind_, bend_;  // by knot, then sensor
};

}  // namespace brachium
