#include "solver/chain_solver.h"

#include <algorithm>
#include <cmath>

#include "solver/step_memory.h"
#include "solver/step_values.h"

namespace brachium {
namespace {

// The least is what a search begins with: more would hold weakly determined directions back.
constexpr double kLeastDamping = 1e-15;
constexpr double kNoDamping = 1e-12;  // up to here steps are Gauss-Newton's
constexpr double kMostDamping = 1e16;
constexpr double kMoreDamping = 100.0, kLessDamping = 0.1;  // after a step refused, or taken

// Gains: how much of the foretold decrease a step brings.
constexpr double kLongGain = 1.5;    // above this the slope has not levelled off
constexpr double kFairGain = 0.25;   // below this it went too far
constexpr double kLeastGain = 1e-3;  // that is taken for one
constexpr double kShortest = 0.08;   // share of a step worth a try; else damping serves better
constexpr double kLongest = 64.0;

// At the bottom of a well squared steps shrink ever faster; unless a loss bends, by this much less.
constexpr double kDoubt = 100.0;

// A decrease below this share of the cost drowns in its rounding errors.
constexpr double kRounding = 1e-14;

class Descent {
 public:
  Descent(const ArmProblem& problem, const State& state, ChainWorkspace& workspace,
          const SolveOptions& options)
      : plan_(workspace.plan),
        sweep_(workspace.sweep),
        options_(options),
        values_(problem, state, plan_) {}

  SolveSummary Run() {
    values_.Save();
    here_ = sweep_.Run(plan_, damping_);
    summary_.initial_cost = here_.cost;
    if (!here_.IsFinite()) return Ended(false, "The start has no finite cost.");
    while (summary_.iterations < options_.most_iterations) {
      if (damping_ > kMostDamping) return Ended(false, "No step lowers the cost.");
      if (damping_ <= kNoDamping && 0.5 * here_.length_2 <= options_.least_decrease * here_.cost)
        return Ended(true, "The cost hardly falls any more.");
      const double foretold = sweep_.Step(plan_, step_);
      if (damping_ <= kNoDamping && IsSmall()) {
        values_.Set(step_, 1.0);
        here_.cost = std::max(0.0, here_.cost - foretold);
        return Ended(true, "The step is small against the standard deviations.");
      }
      ++summary_.iterations;
      if (TryMixed(foretold) || Try(foretold)) continue;
      values_.Restore();
      if (foretold < kRounding * here_.cost) {
        if (damping_ <= kNoDamping) sweep_.Run(plan_, kLeastDamping);
        return Ended(true, "The cost does not fall any further in double precision.");
      }
      Refuse();
    }
    return Ended(false, "The most iterations were made.");
  }

 private:
  // Whether the step is, or the next one will be if it shrinks by no less than a hundredth of what
  // this one did.
  bool IsSmall() const {
    const double shrinks = std::min(1.0, kDoubt * here_.length_2 / length_2_before_);
    return here_.length_2 * shrinks <= options_.step_in_sd * options_.step_in_sd;
  }

  // Takes the step that the last ones call for, if there is one and it is good.
  bool TryMixed(double foretold) {
    memory_.Stand(step_, sweep_.gradient(), here_.length_2);
    if (damping_ > kNoDamping || !memory_.Mix(mixed_)) return false;
    if (Gain(mixed_, 1.0, foretold) >= kFairGain) return Take(mixed_, 1.0);
    memory_.Forget();
    return false;
  }

  // Takes the step, or more of it while the cost falls on, or where it went too far the share of it
  // that the parabola through the costs asks for, if the cost falls.
  bool Try(double foretold) {
    const double gain = Gain(step_, 1.0, foretold);
    if (gain >= kLongGain) return TakeLonger(foretold);
    if (gain >= kFairGain) return Take(step_, 1.0);
    const double share = 1 / (2 - gain);
    return share > kShortest && Gain(step_, share, foretold) >= kLeastGain && Take(step_, share);
  }

  bool TakeLonger(double foretold) {
    double share = 1.0, cost = there_.cost;
    while (share < kLongest && Gain(step_, 2 * share, foretold) > 0.0 && there_.cost < cost) {
      share *= 2;
      cost = there_.cost;
    }
    if (there_.cost != cost) Gain(step_, share, foretold);
    return Take(step_, share);
  }

  // How much of the foretold decrease a share of a step brings, linearised there for the next step.
  double Gain(const std::vector<double>& step, double share, double foretold) {
    values_.Set(step, share);
    damping_there_ = std::max(kLessDamping * damping_, kLeastDamping);
    there_ = sweep_.Run(plan_, damping_there_);
    return there_.IsFinite() ? (here_.cost - there_.cost) / foretold : -HUGE_VAL;
  }

  bool Take(const std::vector<double>& step, double share) {
    memory_.Go(step, share);
    values_.Save();
    length_2_before_ = share == 1.0 ? here_.length_2 : 0.0;
    here_ = there_;
    damping_ = damping_there_;
    return true;
  }

  void Refuse() {
    damping_ *= kMoreDamping;
    here_ = sweep_.Run(plan_, damping_);
  }

  // The last pass is left as good as undamped, for those who ask it what is certain.
  SolveSummary Ended(bool converged, const char* message) {
    if (damping_ > kNoDamping) sweep_.Run(plan_, kLeastDamping);
    summary_.final_cost = here_.cost;
    summary_.gradient_norm = here_.gradient_norm;
    summary_.converged = converged;
    summary_.message = message;
    return summary_;
  }

  FrontPlan& plan_;
  FrontSweep& sweep_;
  const SolveOptions& options_;
  StepValues values_;
  FrontSweep::Sums here_, there_;  // of the values that stand, and of those that are tried
  double damping_ = kLeastDamping, damping_there_ = 0.0;
  double length_2_before_ = 0.0;  // of the step that led here, if it was a whole one
  std::vector<double> step_, mixed_;
  StepMemory memory_;
  SolveSummary summary_;
};

}  // namespace

SolveSummary SolveChain(const ArmProblem& problem, State& state, const CarriedPrior& prior,
                        const TermRange& range, const SolveOptions& options,
                        ChainWorkspace& workspace) {
  workspace.plan.Build(problem, state, prior, range);
  workspace.sweep.Prepare(workspace.plan);
  return Descent(problem, state, workspace, options).Run();
}

}  // namespace brachium
