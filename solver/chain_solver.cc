#include "solver/chain_solver.h"

#include <algorithm>
#include <cmath>

#include "problems/rotation_manifold.h"

namespace brachium {
namespace {

// The least is what a search begins with: more would hold weakly determined directions back.
constexpr double kLeastDamping = 1e-15;
constexpr double kNoDamping = 1e-12;  // up to here steps are Gauss-Newton's
constexpr double kMostDamping = 1e16;
constexpr double kMoreDamping = 100.0, kLessDamping = 0.1;  // after a step refused, or taken

// Gains: how much of the foretold decrease a step brings.
constexpr double kFairGain = 0.25;     // below this it went too far
constexpr double kCreepingGain = 1.4;  // above this it went not far enough
constexpr double kLeastGain = 1e-3;    // that is taken for one
constexpr double kShortest = 0.08;     // share of a step worth a try; else damping serves better
constexpr double kLongest = 10.0;      // share of a step that is believed

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

  // To the saved values and `share` of the step.
  void Set(const std::vector<double>& step, double share) const {
    const double* from = saved_.data();
    for (const auto& variable : plan_.variables()) {
      if (variable.tangent > 0)
        Move(variable, from, &step[static_cast<std::size_t>(variable.column)], share);
      from += variable.size;
    }
  }

 private:
  static void Move(const FrontPlan::Variable& variable, const double* from, const double* d,
                   double share) {
    if (variable.size == 4) {
      const double turn[3] = {share * d[0], share * d[1], share * d[2]};
      RotationManifold().Plus(from, turn, variable.value);
      return;
    }
    for (int i = 0; i < variable.size; ++i) variable.value[i] = from[i] + share * d[i];
  }

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
      const double foretold = sweep_.Step(plan_, step_);
      if (damping_ <= kNoDamping && IsLast(foretold)) {
        values_.Set(step_, 1.0);
        here_.cost -= foretold;
        return Ended(true, "The step is small against the standard deviations.");
      }
      ++summary_.iterations;
      if (Try(foretold)) continue;
      values_.Restore();
      if (foretold < kRounding * here_.cost)
        return Ended(true, "The cost does not fall any further in double precision.");
      Refuse();
    }
    return Ended(false, "The most iterations were made.");
  }

 private:
  // Whether nothing worth another pass is left after a step.
  bool IsLast(double foretold) const {
    return here_.length_2 <= options_.step_in_sd * options_.step_in_sd ||
           foretold <= options_.least_decrease * here_.cost;
  }

  // Takes the step, or the share of it that the parabola through the costs asks for, if the cost
  // falls: less where it went too far, more where Gauss-Newton's steps creep because the cost bends
  // less than they assume.
  bool Try(double foretold) {
    const double damping = std::max(kLessDamping * damping_, kLeastDamping);
    const double gain = Gain(1.0, damping, foretold);
    const double share = gain < 2 - 1 / kLongest ? 1 / (2 - gain) : kLongest;
    if (gain < kFairGain)
      return share > kShortest && Gain(share, damping_, foretold) >= kLeastGain && Take();
    if (gain < kCreepingGain || Gain(share, damping, foretold) > gain) return Take();
    return Gain(1.0, damping, foretold) >= kFairGain && Take();
  }

  // How much of the foretold decrease a share of the step brings, linearised there.
  double Gain(double share, double damping, double foretold) {
    values_.Set(step_, share);
    there_ = sweep_.Run(plan_, damping);
    damping_there_ = damping;
    return there_.IsFinite() ? (here_.cost - there_.cost) / foretold : -HUGE_VAL;
  }

  bool Take() {
    values_.Save();
    here_ = there_;
    damping_ = damping_there_;
    return true;
  }

  void Refuse() {
    damping_ *= kMoreDamping;
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
  FrontSweep::Sums here_, there_;  // of the values that stand, and of those that are tried
  double damping_ = kLeastDamping, damping_there_ = 0.0;
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
