#include "solver/chain_solver.h"

#include <algorithm>
#include <cmath>

#include "problems/rotation_manifold.h"

namespace brachium {
namespace {

constexpr double kStartDamping = 1e-8;
constexpr double kLeastDamping = 1e-16;
constexpr double kMostDamping = 1e16;
constexpr double kRefusedDamping =
    1e-6;                            // at least, where a step was refused: less changes nothing
constexpr double kLeastGain = 1e-3;  // of the foretold decrease that a step must bring
// A decrease below this share of the cost drowns in its rounding errors.
constexpr double kRounding = 1e-14;

// The values of a plan's variables, to go back to and to step from.
class Values {
 public:
  explicit Values(const FrontPlan& plan) : plan_(plan) {
    std::size_t size = 0;
    for (const auto& variable : plan.variables()) size += static_cast<std::size_t>(variable.size);
    saved_.resize(size);
  }

  void Save() {
    double* to = saved_.data();
    for (const auto& variable : plan_.variables())
      to = std::copy_n(variable.value, variable.size, to);
  }

  void Restore() const {
    const double* from = saved_.data();
    for (const auto& variable : plan_.variables()) {
      std::copy_n(from, variable.size, variable.value);
      from += variable.size;
    }
  }

  void Move(const std::vector<double>& step) const {
    for (const auto& variable : plan_.variables()) {
      if (variable.tangent == 0) continue;
      const double* d = &step[static_cast<std::size_t>(variable.column)];
      if (variable.size == 4)
        RotationManifold().Plus(variable.value, d, variable.value);
      else
        for (int i = 0; i < variable.size; ++i) variable.value[i] += d[i];
    }
  }

 private:
  const FrontPlan& plan_;
  std::vector<double> saved_;
};

class Descent {
 public:
  Descent(ChainWorkspace& workspace, const SolveOptions& options)
      : plan_(workspace.plan), sweep_(workspace.sweep), options_(options), values_(plan_) {}

  SolveSummary Run() {
    values_.Save();
    here_ = sweep_.Run(plan_, damping_);
    summary_.initial_cost = here_.cost;
    if (!here_.IsFinite()) return Ended(false, "The start has no finite cost.");
    while (summary_.iterations < options_.most_iterations) {
      if (damping_ > kMostDamping) return Ended(false, "No step lowers the cost.");
      if (here_.weak_pivots > 0) {
        Refuse();
        continue;
      }
      const double foretold = sweep_.Step(plan_, step_);
      if (here_.length_2 <= options_.step_in_sd * options_.step_in_sd &&
          damping_ <= kStartDamping) {
        values_.Move(step_);
        here_.cost -= foretold;
        return Ended(true, "The step is small against the standard deviations.");
      }
      ++summary_.iterations;
      if (Try(foretold)) continue;
      if (foretold < kRounding * here_.cost)
        return Ended(true, "The cost does not fall any further in double precision.");
      Refuse();
    }
    return Ended(false, "The most iterations were made.");
  }

 private:
  // Takes the step if the cost falls as it should; else leaves all values as they were.
  bool Try(double foretold) {
    values_.Move(step_);
    const double less = std::max(damping_ / 3, kLeastDamping);
    const FrontSweep::Sums there = sweep_.Run(plan_, less);
    if (!there.IsFinite() || !(here_.cost - there.cost > kLeastGain * foretold)) {
      values_.Restore();
      return false;
    }
    values_.Save();
    here_ = there;
    damping_ = less;
    growth_ = 2.0;
    return true;
  }

  void Refuse() {
    damping_ = std::max(growth_ * damping_, kRefusedDamping);
    growth_ *= 2.0;
    here_ = sweep_.Run(plan_, damping_);
  }

  SolveSummary Ended(bool converged, const char* message) {
    summary_.final_cost = here_.cost;
    summary_.gradient_norm = here_.gradient_norm;
    summary_.converged = converged;
    summary_.message = message;
    return summary_;
  }

  FrontPlan& plan_;
  FrontSweep& sweep_;
  const SolveOptions& options_;
  Values values_;
  FrontSweep::Sums here_;  // of the values that stand
  double damping_ = kStartDamping, growth_ = 2.0;
  std::vector<double> step_;
  SolveSummary summary_;
};

}  // namespace

SolveSummary SolveChain(const ArmProblem& problem, State& state, const CarriedPrior& prior,
                        const TermRange& range, const SolveOptions& options,
                        ChainWorkspace& workspace) {
  workspace.plan.Build(problem, state, prior, range);
  workspace.sweep.Prepare(workspace.plan);
  return Descent(workspace, options).Run();
}

}  // namespace brachium
