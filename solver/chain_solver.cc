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
//
// A step changes the heading of the arm, which little holds, far more than anything else, and stiff
// relations hold its sensors at their places. So places and velocities of a knot turn with the arm:
// x -> Rz(ψ) (x + d - ψ e_z × x), ψ the turn about the vertical of the arm's first segment at that
// knot. To first order that is x + d, and a turn of the whole stays one however far it goes.
class Values {
 public:
  Values(const ArmProblem& problem, const FrontPlan& plan) : plan_(plan) {
    std::size_t size = 0;
    for (const auto& variable : plan.variables()) {
      size += static_cast<std::size_t>(variable.size);
      turning_.push_back(TurningWith(problem, variable.unknown));
    }
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
    Restore();
    const auto& variables = plan_.variables();
    for (std::size_t i = 0; i < variables.size(); ++i) {
      const auto& variable = variables[i];
      if (variable.size == 4 || variable.tangent == 0) continue;
      const double turn = turning_[i] < 0 ? 0.0 : share * Turn(variables, turning_[i], step);
      Move(variable, &step[static_cast<std::size_t>(variable.column)], share, turn);
    }
    for (const auto& variable : variables) {
      if (variable.size != 4) continue;
      const double* d = &step[static_cast<std::size_t>(variable.column)];
      const double turn[3] = {share * d[0], share * d[1], share * d[2]};
      RotationManifold().Plus(variable.value, turn, variable.value);
    }
  }

 private:
  using Variables = std::vector<FrontPlan::Variable>;

  // The attitude with which an unknown turns, or -1.
  int TurningWith(const ArmProblem& problem, int unknown) const {
    const Unknown u = problem.Describe(unknown);
    const bool of_thorax = u.kind == UnknownKind::kRoot ? u.sensor + 1 < problem.size().roots
                                                        : u.sensor < problem.FirstOfArm();
    if (u.kind != UnknownKind::kRoot && u.kind != UnknownKind::kVelocity &&
        u.kind != UnknownKind::kPlace)
      return -1;
    return plan_.IndexOf(problem.Attitude(u.place, of_thorax ? 0 : problem.FirstOfArm()));
  }

  // About the vertical, of a whole step [rad]. The attitude still has its saved value.
  static double Turn(const Variables& variables, int attitude, const std::vector<double>& step) {
    const auto& variable = variables[static_cast<std::size_t>(attitude)];
    const Eigen::Map<const Eigen::Quaterniond> q_WB(variable.value);
    const Eigen::Map<const Eigen::Vector3d> phi_B(&step[static_cast<std::size_t>(variable.column)]);
    return (q_WB * phi_B).z();
  }

  static void Move(const FrontPlan::Variable& variable, const double* d, double share,
                   double turn) {
    double* x = variable.value;
    if (turn != 0.0) {
      const double east = x[0] + share * d[0] + turn * x[1];
      const double north = x[1] + share * d[1] - turn * x[0];
      const double c = std::cos(turn), s = std::sin(turn);
      x[0] = c * east - s * north;
      x[1] = s * east + c * north;
      x[2] += share * d[2];
      return;
    }
    for (int i = 0; i < variable.size; ++i) x[i] += share * d[i];
  }

  const FrontPlan& plan_;
  std::vector<int> turning_;  // of each variable: the one whose turn it follows, or -1
  std::vector<double> saved_;
};

class Descent {
 public:
  Descent(const ArmProblem& problem, ChainWorkspace& workspace, const SolveOptions& options)
      : plan_(workspace.plan),
        sweep_(workspace.sweep),
        options_(options),
        values_(problem, plan_) {}

  SolveSummary Run() {
    values_.Save();
    here_ = sweep_.Run(plan_, damping_);
    summary_.initial_cost = here_.cost;
    if (!here_.IsFinite()) return Ended(false, "The start has no finite cost.");
    while (summary_.iterations < options_.most_iterations) {
      if (damping_ > kMostDamping) return Ended(false, "No step lowers the cost.");
      const double foretold = sweep_.Step(plan_, step_);
      if (here_.length_2 <= options_.step_in_sd * options_.step_in_sd && damping_ <= kNoDamping) {
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
  return Descent(problem, workspace, options).Run();
}

}  // namespace brachium
