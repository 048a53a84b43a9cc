// What a run of terms says once it is taken apart along the time axis (front_sweep.h): the marginal
// prior that a window hands on and, run to the end of a trial and back, the covariance of every
// unknown, at a cost linear in the length.
//
// Backwards, with A = H_EE⁻¹ H_ES and Σ_SS known from the next front,
//   Σ_ES = -A Σ_SS,   Σ_EE = H_EE⁻¹ + A Σ_SS Aᵀ.
// Source: selected inversion, Takahashi, Fagan & Chin (1973); on a chain it is the smoother of
// Rauch, Tung & Striebel (1965).
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "solver/front_sweep.h"

namespace brachium {

// Which unknowns a matrix is about: unknown i holds the rows from offset[i].
struct BlockIndex {
  std::vector<int> unknowns;
  std::vector<int> offset;
  int dimension = 0;

  int OffsetOf(int unknown) const;  // -1 where it is not among them
};

// A covariance where it lies; valid while it is visited.
using CovarianceView = Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>;

class Elimination {
 public:
  // Linearises and eliminates `prior` and all terms whose first knot lies in [start_knot,
  // end_knot), at the values in `state`; unknowns that terms from `end_knot` on touch come last.
  // Holds until `workspace` is used again.
  Elimination(const ArmProblem& problem, State& state, const CarriedPrior& prior, int start_knot,
              int end_knot, ChainWorkspace& workspace);

  // What the last pass over a workspace's plan left. Holds until `workspace` is used again.
  explicit Elimination(ChainWorkspace& workspace)
      : plan_(workspace.plan), sweep_(workspace.sweep) {}

  // What was said about the unknowns that later terms touch, as a residual with its point. Requires a
  // plan that hands on.
  CarriedPrior Carry() const;

  // Of the unknowns that do not stay, by their tangent size.
  int eliminated() const;

  // A pivot block was not positive definite: the information does not determine its unknowns.
  std::vector<int> singular() const { return sweep_.Undetermined(plan_); }

  // Visits the fronts from last to first with the joint covariance of their unknowns. Values, terms
  // and prior must be those of the last pass: a search may have stepped on since.
  using Visitor =
      std::function<void(int knot, const BlockIndex& index, const CovarianceView& covariance)>;
  void VisitCovariances(const Visitor& visit) const;

 private:
  const FrontPlan& plan_;
  FrontSweep& sweep_;
};

}  // namespace brachium
