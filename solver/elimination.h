// Block elimination along the time axis: the Gaussian information of a run of terms, taken apart
// knot by knot. Serves the marginal prior of a window and, run to the end of a trial and back, the
// covariance of every unknown, at a cost linear in the length.
//
// Terms come in order of their first knot. At each knot the unknowns that no later term touches are
// eliminated from a small dense front: with H = [H_EE H_ES; H_SE H_SS], g likewise,
//   A = H_EE⁻¹ H_ES,   H_SS -= H_SE A,   g_S -= Aᵀ g_E,
// and the rest is carried to the next front. Backwards, with Σ_SS known from the next front,
//   Σ_ES = -A Σ_SS,   Σ_EE = H_EE⁻¹ + A Σ_SS Aᵀ.
// Source: selected inversion, Takahashi, Fagan & Chin (1973); on a chain it is the smoother of
// Rauch, Tung & Striebel (1965).
#pragma once

#include <Eigen/Core>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

#include "problems/arm_problem.h"
#include "problems/residuals/marginal_prior.h"

namespace brachium {

// A marginal prior and the unknowns that it speaks of, in its blocks' order.
struct CarriedPrior {
  std::unique_ptr<MarginalPrior> cost;  // none before the first window
  std::vector<int> unknowns;
};

// Which unknowns a matrix is about: unknown i holds the rows from offset[i].
struct BlockIndex {
  std::vector<int> unknowns;
  std::vector<int> offset;
  int dimension = 0;

  int OffsetOf(int unknown) const;  // -1 where it is not among them
};

class Elimination {
 public:
  // Memory that successive eliminations of one problem share.
  struct Workspace {
    std::vector<int> last_touch, offset_of;
  };

  // Linearises and eliminates `prior` and all terms whose first knot lies in [start_knot,
  // end_knot), at the values in `state`. Unknowns that terms from `end_knot` on touch are kept;
  // none is where end_knot is past the last knot. `keep_fronts` stores what the way back needs.
  Elimination(const ArmProblem& problem, State& state, const CarriedPrior& prior, int start_knot,
              int end_knot, bool keep_fronts, Workspace& workspace);

  // What was said about the unknowns that stay, as a residual with its point in `state`.
  CarriedPrior Carry(const ArmProblem& problem, State& state) const;

  // A pivot block was not positive definite: the information does not determine its unknowns.
  const std::vector<int>& singular() const { return singular_; }

  // Visits the fronts from last to first with the joint covariance of their unknowns. Requires
  // keep_fronts and an end past the last knot.
  using Visitor =
      std::function<void(int knot, const BlockIndex& index, const Eigen::MatrixXd& covariance)>;
  void VisitCovariances(const Visitor& visit) const;

 private:
  struct Front {
    int knot;
    BlockIndex index;    // eliminated unknowns first
    int eliminated = 0;  // their dimension
    Eigen::MatrixXd H_EE_inverse, A;
  };
  static bool IsTouchedFrom(const ArmProblem& problem, int end_knot, int unknown);
  void Eliminate(Front& front, Eigen::MatrixXd& H, Eigen::VectorXd& g, bool keep);

  BlockIndex kept_;
  Eigen::MatrixXd H_;
  Eigen::VectorXd g_;
  std::vector<Front> fronts_;
  std::vector<int> singular_;
};

}  // namespace brachium
