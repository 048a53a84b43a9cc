// One pass of numbers along a plan of fronts: linearise the terms, eliminate front by front, and on
// the way back solve for the step. With H = [H_EE H_ES; H_SE H_SS] and g of a front,
//   L Lᵀ = H_EE,   B = H_SE L⁻ᵀ,   y = L⁻¹ g_E,   H_SS -= B Bᵀ,   g_S -= B y,
// and backwards d_E = -L⁻ᵀ (y + Bᵀ d_S). The fronts of one trial have one size, so time and memory
// are linear in its length; a pass allocates nothing.
// Source: the multifrontal Cholesky factorisation, Duff & Reid (1983), on a chain.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "solver/front_plan.h"

namespace brachium {

class FrontSweep {
 public:
  // What a pass found at the values of the plan's variables.
  struct Sums {
    double cost = 0.0;           // Σ ½ ρ(|r|²)
    double gradient_norm = 0.0;  // largest |∂cost/∂column|
    double length_2 = 0.0;       // Σ |y|²: squared length of the step in the metric of H
    bool IsFinite() const;
  };

  // Sets memory up for a plan; it is kept from one plan to the next.
  void Prepare(const FrontPlan& plan);

  // Linearises and eliminates, with `damping` times the diagonal of JᵀJ added to it.
  Sums Run(const FrontPlan& plan, double damping);

  // Unknowns that the last pass eliminated in fronts with a pivot that lost all digits: they are not
  // determined.
  std::vector<int> Undetermined(const FrontPlan& plan) const;

  // The step of all columns that the last pass calls for, and by how much the linearised cost falls
  // with it. Requires a plan that hands nothing on.
  double Step(const FrontPlan& plan, std::vector<double>& step);

  // Of the cost at the last pass, all columns.
  const std::vector<double>& gradient() const { return gradient_; }

  // A deviation of all columns with the covariance of the last pass, from `signs`: as many random
  // numbers of mean 0 and variance 1, independent. Requires a plan that hands nothing on.
  void Draw(const FrontPlan& plan, const std::vector<double>& signs,
            std::vector<double>& deviation);

  // What the last front hands on: the information about its members that stay, and its gradient.
  Eigen::MatrixXd KeptInformation(const FrontPlan& plan) const;
  Eigen::VectorXd KeptGradient(const FrontPlan& plan) const;

  // The eliminated columns of a front, as FactorFront left them.
  const double* Factor(const FrontPlan::Front& front) const { return &factors_[front.storage]; }

 private:
  void TakeOver(const FrontPlan& plan, const FrontPlan::Front& front, int stride_before);
  double AddTerm(const FrontPlan& plan, const FrontPlan::Front& front,
                 const FrontPlan::PlannedTerm& term);
  // Says whether a pivot lost all digits.
  bool Eliminate(const FrontPlan::Front& front);
  void GatherKept(const FrontPlan& plan, const FrontPlan::Front& front,
                  const std::vector<double>& columns);

  double damping_ = 0.0;
  std::vector<double> factors_;
  std::vector<double> diagonal_, gradient_;  // of JᵀJ and Jᵀr, all columns
  std::vector<double> front_, before_;       // matrices of this front and of the last
  std::vector<double> least_, y_, d_;
  std::vector<int> lost_;  // fronts of the last pass with a pivot that lost all digits
  TermSquare term_;
};

// Memory that successive plans and passes over one problem share.
struct ChainWorkspace {
  explicit ChainWorkspace(const ArmProblem& problem) : plan(problem) {}

  // A pass over the whole trial as it stands in `state`, for what is certain in it. Stops of joints
  // are left out: they hold from one side only.
  void Linearise(const ArmProblem& problem, State& state);

  // The same over a window and the prior that it began with.
  void Linearise(const ArmProblem& problem, State& state, const CarriedPrior& prior, int start_knot,
                 int last_knot);

  FrontPlan plan;
  FrontSweep sweep;
};

}  // namespace brachium
