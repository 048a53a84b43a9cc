// One pass of numbers along a plan of fronts: linearise the terms, eliminate front by front, and on
// the way back solve for the step. With H = [H_EE H_ES; H_SE H_SS] and g of a front,
//   L Lᵀ = H_EE,   B = H_SE L⁻ᵀ,   y = L⁻¹ g_E,   H_SS -= B Bᵀ,   g_S -= B y,
// and backwards d_E = -L⁻ᵀ (y + Bᵀ d_S). The fronts of one trial have one size, so time and memory
// are linear in its length; a pass allocates nothing. Covariances, whose digits are few where unknowns
// hold each other tightly, do not go by the factor that is kept: for them fronts stand in full
// precision, some at a time from the last to the first, and are eliminated again where they did not.
// Source: the multifrontal Cholesky factorisation, Duff & Reid (1983), on a chain.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "solver/front_plan.h"
#include "solver/large_buffer.h"

namespace brachium {

class FrontSweep {
 public:
  // What a pass found at the values of the plan's variables.
  struct Sums {
    double cost = 0.0;           // Σ ½ ρ(|r|²)
    double gradient_norm = 0.0;  // largest |∂cost/∂column|
    double length_2 = 0.0;  // Σ |y|²: squared length of the step in the metric of H, twice by
                            // how much the linearised cost falls with it
    bool IsFinite() const;
  };

  // Sets memory up for a plan; it is kept from one plan to the next.
  void Prepare(const FrontPlan& plan);

  // Linearises and eliminates, with `damping` times the diagonal of JᵀJ added to it.
  Sums Run(const FrontPlan& plan, double damping);

  // Whether in the last pass the pivot of a column lost all digits.
  bool IsLost(int column) const;

  // Unknowns that the last pass eliminated in fronts with a pivot that lost all digits: they are not
  // determined.
  std::vector<int> Undetermined(const FrontPlan& plan) const;

  // The step of all columns that the last pass calls for, and by how much the linearised cost falls
  // with it.
  double Step(const FrontPlan& plan, std::vector<double>& step);

  // Of the cost at the last pass, all columns.
  const std::vector<double>& gradient() const { return gradient_; }

  // Deviations of all columns with the covariance of the last pass, each from its `signs`: as many
  // random numbers of mean 0 and variance 1, independent.
  void Draw(const FrontPlan& plan, const std::vector<std::vector<double>>& signs,
            std::vector<std::vector<double>>& deviations);

  // The eliminated columns of the last front, as the last pass left them.
  const double* LastFactor() const { return last_.data(); }

  // Visits the fronts from last to first with their eliminated columns as FactorFront left them.
  // Values, terms and prior must be those of the last pass: a search may have stepped on since.
  using Visitor = std::function<void(const FrontPlan::Front& front, const double* L)>;
  void VisitBackwards(const FrontPlan& plan, const Visitor& visit);

 private:
  const Kept* Factor(const FrontPlan::Front& front) const {
    return factors_.data() + front.storage;
  }
  double* Column(const FrontPlan::Front& front, int column);
  double* Mark(const FrontPlan& plan, std::size_t front);
  double* Exact(const FrontPlan& plan, std::size_t front);
  void KeepExact(const FrontPlan& plan, std::size_t front);
  void EliminateAgain(const FrontPlan& plan, std::size_t begin, std::size_t end);
  void Clear(const FrontPlan::Front& front, int begin, int end);
  void CopyRun(const FrontPlan::Front& front, std::span<const FrontPlan::Run> runs,
               const double* before, int stride_before);
  void TakeOver(const FrontPlan& plan, const FrontPlan::Front& front, int stride_before);
  double AddTerm(const FrontPlan& plan, const FrontPlan::Front& front,
                 const FrontPlan::PlannedTerm& term);
  void SumDiagonal(const FrontPlan& plan, const FrontPlan::PlannedTerm& term);
  void Eliminate(const FrontPlan::Front& front);
  void NoteLost(const FrontPlan::Front& front);
  void GatherKept(const FrontPlan& plan, const FrontPlan::Front& front,
                  const std::vector<double>& columns, double* kept);

  double damping_ = 0.0;
  LargeBuffer<Kept> factors_;                // eliminated columns of all fronts
  LargeBuffer<double> last_;                 // those of the last front, unrounded
  LargeBuffer<double> eliminated_;           // those of this front
  LargeBuffer<double> front_, before_;       // the other columns of this front and of the last
  LargeBuffer<double> marks_;                // the same before every kTogether-th front
  LargeBuffer<double> together_;             // eliminated columns of that many fronts
  std::size_t together_begin_ = 0;           // the first of them
  std::vector<double> diagonal_, gradient_;  // of JᵀJ and Jᵀr, all columns
  std::vector<double> least_, y_, d_;
  std::vector<int> lost_;  // columns whose pivots lost all digits in the last pass, increasing
  TermSquare term_;
};

// Memory that successive plans and passes over one problem share.
struct ChainWorkspace {
  explicit ChainWorkspace(const ArmProblem& problem) : plan(problem) {}

  // A pass over a range as it stands in `state`.
  void Linearise(const ArmProblem& problem, State& state, const CarriedPrior& prior,
                 const TermRange& range);

  // Over the whole trial, for what is certain in it. Stops of joints are left out: they hold from one
  // side only.
  void Linearise(const ArmProblem& problem, State& state);

  FrontPlan plan;
  FrontSweep sweep;
};

}  // namespace brachium
