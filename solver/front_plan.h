// The order in which a run of terms is taken apart along the time axis: what happens where, found
// once and then followed by every pass of numbers (front_sweep.h).
//
// Terms come in order of their first knot. At each knot there is a front: the unknowns that terms
// have touched and that are not eliminated yet. Those that no later term touches are eliminated
// there; the rest is handed on to the next front, and the last front eliminates all. All columns are
// in the order of elimination, so that what a front eliminates comes first in it and what it hands on
// keeps its order.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "problems/arm_problem.h"
#include "problems/residuals/marginal_prior.h"
#include "solver/term_square.h"

namespace brachium {

// A marginal prior and the unknowns that it speaks of, in its blocks' order.
struct CarriedPrior {
  std::unique_ptr<MarginalPrior> cost;  // none before the first window
  std::vector<int> unknowns;
};

// Which terms are taken, and what becomes of their unknowns.
struct TermRange {
  int start_knot = 0;  // terms whose first knot lies in [start_knot, end_knot)
  int end_knot = 0;
  int last_knot = 0;           // and that do not reach beyond this one
  bool hand_on = false;        // what terms from end_knot on touch comes last
  bool hold_geometry = false;  // scales, geometry and clocks are numbers, not unknowns
  bool leave_stops = false;    // take no stops of joints
};

// Scales, mountings, lever arms, joint vectors and clocks: what `hold_geometry` holds.
bool IsGeometry(UnknownKind kind);

class FrontPlan {
 public:
  // An unknown of the plan, in the order of elimination. Held unknowns have no columns.
  struct Variable {
    int unknown;
    double* value;
    int size, tangent;
    int column;      // of the step, which holds all columns of the plan
    int last_front;  // that touches it; past the last front for one that is handed on
  };
  struct PlannedTerm {
    const TangentCost* cost;
    const ceres::LossFunction* loss;  // or null
    std::size_t first_block;
    int blocks;
  };
  struct Member {
    int variable;  // index
    int column;    // in the front
  };
  // Neighbouring columns that a front takes over: from where in the last front, to where in this.
  struct Run {
    int from, to, length;
  };
  struct Front {
    int knot;
    int columns = 0, eliminated = 0;
    int first_column = 0;     // of the step: where its eliminated columns begin
    int first_staying = 0;    // column: from here on all stand where the last front left them
    std::size_t storage = 0;  // where its factor lies: eliminated columns of Stride() numbers
    std::size_t first_term = 0, terms = 0;
    std::size_t first_member = 0, members = 0;
    std::size_t first_run = 0, runs = 0;
    int Stride() const { return Padded(columns + 1); }  // columns and the gradient, padded
  };

  // `problem` must not change the unknowns of its terms while the plan is used.
  explicit FrontPlan(const ArmProblem& problem);

  // Makes the plan of a range; it points into `state`, the terms and the prior.
  void Build(const ArmProblem& problem, State& state, const CarriedPrior& prior,
             const TermRange& range);

  const std::vector<Variable>& variables() const { return variables_; }
  // Of an unknown's variable; -1 where the plan has none.
  int IndexOf(int unknown) const { return variable_of_[static_cast<std::size_t>(unknown)]; }
  const std::vector<Front>& fronts() const { return fronts_; }
  int columns() const { return columns_; }              // of all variables
  int handed_on() const { return handed_on_; }          // of them, the last ones: what is handed on
  std::size_t storage() const { return storage_; }      // numbers that the factor takes
  int widest_stride() const { return widest_stride_; }  // of all fronts
  int most_residuals() const { return most_residuals_; }  // of one term
  int widest_term() const { return widest_term_; }        // tangent columns, held ones too
  int most_blocks() const { return most_blocks_; }        // of one term
  std::span<const PlannedTerm> Terms(const Front& front) const {
    return {terms_.data() + front.first_term, front.terms};
  }
  std::span<const TermBlock> Blocks(const PlannedTerm& term) const {
    return {blocks_.data() + term.first_block, static_cast<std::size_t>(term.blocks)};
  }
  std::span<const Member> Members(const Front& front) const {
    return {members_.data() + front.first_member, front.members};
  }
  std::span<const Run> Runs(const Front& front) const {
    return {runs_.data() + front.first_run, front.runs};
  }

 private:
  void Reset();
  void AddTerm(const ArmProblem& problem, State& state, const TangentCost& cost,
               const ceres::LossFunction* loss, const std::vector<int>& unknowns, int knot,
               bool hold_geometry);
  int VariableOf(const ArmProblem& problem, State& state, int unknown, bool hold_geometry);
  void OrderVariables();
  void EnterMembers(Front& front);
  void PlaceBlocks(const Front& front);
  void FindRuns(const Front& before, Front& front);

  std::vector<int> last_knot_;    // of each unknown: first knot of the trial's last term on it
  std::vector<int> variable_of_;  // of each unknown; -1: none
  std::vector<Variable> variables_;
  std::vector<Front> fronts_;
  std::vector<PlannedTerm> terms_;
  std::vector<TermBlock> blocks_;
  std::vector<Member> members_;
  std::vector<Run> runs_;
  std::vector<int> column_in_front_;  // of each variable; -1 before its first front
  std::vector<int> active_;           // variables that the last front handed on
  std::vector<TermBlock*> in_order_;  // of one term
  int columns_ = 0, handed_on_ = 0, widest_stride_ = 0, most_residuals_ = 0, widest_term_ = 0,
      most_blocks_ = 0;
  std::size_t storage_ = 0;
};

}  // namespace brachium
