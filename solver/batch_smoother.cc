#include "solver/batch_smoother.h"

#include <algorithm>
#include <optional>

#include "solver/clocks.h"
#include "solver/covariance.h"
#include "solver/diagnosis.h"
#include "solver/least_squares.h"
#include "solver/observability.h"
#include "solver/residual_sums.h"
#include "solver/stage_clock.h"
#include "solver/standard_deviations.h"
#include "solver/stretch_smoother.h"
#include "solver/trajectory.h"
#include "solver/unmodelled.h"
#include "solver/wearing.h"
#include "solver/window.h"

namespace brachium {
namespace {

// From proximal to distal, with what the options say otherwise than the trial.
Observations Prepared(Observations observations, const SmootherOptions& options) {
  if (options.shoulder_sigma_m > 0.0) observations.arm.shoulder.sigma = options.shoulder_sigma_m;
  std::stable_sort(observations.recordings.begin(), observations.recordings.end(),
                   [](const Recording& a, const Recording& b) { return a.segment < b.segment; });
  return observations;
}

// Sensors that feel more than this beside what rigid segments explain move on them, and what they
// show of the elbow's axes is not to be trusted [m/s²]. Rigid ones: up to 0.02, on skin that turns by
// 1 deg 0.05, by 3 deg 0.15.
constexpr double kOnSkin = 0.1;

bool OnSkin(const ArmProblem& problem) {
  return std::any_of(problem.unmodelled().begin(), problem.unmodelled().end(),
                     [](const Unmodelled& left) { return left.acceleration > kOnSkin; });
}

// The whole trial as one problem, solved step by step.
class WholeTrial {
 public:
  WholeTrial(const Observations& observations, const SmootherOptions& options,
             const Progress& progress)
      : options_(options),
        progress_(progress),
        problem_(Prepared(observations, options), options.model, options.knot_spacing_s,
                 observations.recordings.front().segment),
        state_(problem_.PriorState()) {
    estimate_.method = "smoother";
    estimate_.side = observations.arm.side;
    estimate_.time = observations.recordings.front().time;
    Ends("preintegration");
  }

  Estimate Run() {
    const WindowReport windows = SolveWindows();
    Ends("windows");
    SolveWhole();
    FillTrajectory(problem_, state_, estimate_);
    if (poses_) FillStandardDeviations(problem_, *poses_, estimate_);
    Ends("trajectory");
    Tell(windows);
    Ends("results");
    return std::move(estimate_);
  }

 private:
  bool WeighsResiduals() const { return options_.weight_iterations > 0; }
  SolverKind Solver() const { return SolverNamed(options_.solver).value(); }
  void Ends(const char* stage) { estimate_.timing.push_back({stage, watch_.Lap()}); }

  // The first weights come from windows with lever arms and scales as told: free ones would absorb what
  // the model leaves out, and the weights would confirm them.
  WindowReport SolveWindows() {
    if (!WeighsResiduals()) problem_.HoldMountings(state_);
    UnmodelledSums left(problem_);
    const WindowReport report = SolveForward(problem_, state_,
                                             {.length = options_.window_s,
                                              .only_a_start = true,
                                              .solver = Solver(),
                                              .unmodelled = WeighsResiduals() ? &left : nullptr},
                                             progress_);
    if (WeighsResiduals()) problem_.SetUnmodelled(left.Estimate());
    return report;
  }

  // Its workspace is most of the memory that a trial takes.
  void SolveWhole() {
    ChainWorkspace workspace(problem_);
    EstimateWeights(workspace);
    on_skin_ = WeighsResiduals() && problem_.HasElbow() && OnSkin(problem_);
    if (on_skin_) problem_.HoldMountings(state_);
    Converge(workspace);
    columns_ = workspace.plan.columns();
    Ends("whole trial");
    Assess(workspace);
  }

  void EstimateWeights(ChainWorkspace& workspace) {
    int sums = kMostSums;
    bool followed = false;
    for (int i = 1; i < options_.weight_iterations; i += followed ? 0 : 1) {
      if (progress_) progress_("weights", i / (options_.weight_iterations + 1.0));
      Solve({.solver = Solver(),
             .most_iterations = 4,
             .least_decrease = 0.05,
             .threads = options_.threads},
            workspace);
      followed = sums-- > 0 && FollowsClocks(workspace);
      UnmodelledSums left(problem_);
      left.Add(problem_, 0, problem_.size().knots, workspace);
      problem_.SetUnmodelled(left.Estimate());
    }
  }

  // Where a sensor is missing for long, its turns settle slowly: hundreds of iterations.
  void Converge(ChainWorkspace& workspace) {
    if (progress_) progress_("whole trial", 0.9);
    for (int i = 0;; ++i) {
      Solve({.solver = Solver(),
             .most_iterations = 1000,
             .step_in_sd = 0.01,
             .threads = options_.threads},
            workspace);
      if (i == kMostSums || !FollowsClocks(workspace)) return;
    }
  }

  void Solve(const SolveOptions& options, ChainWorkspace& workspace) {
    const SolveSummary summary =
        brachium::Solve(problem_, state_, {}, 0, problem_.size().knots - 1, options, &workspace);
    Diagnostics& diagnostics = estimate_.diagnostics;
    if (diagnostics.iterations == 0) diagnostics.initial_cost = summary.initial_cost;
    diagnostics.iterations += summary.iterations;
    diagnostics.final_cost = summary.final_cost;
    diagnostics.gradient_norm = summary.gradient_norm;
    diagnostics.converged = summary.converged;
    diagnostics.termination = summary.message;
  }

  // Sums the samples again where the movement tells a clock to be elsewhere; says whether it did.
  // `workspace` then holds a pass over the new sums.
  bool FollowsClocks(ChainWorkspace& workspace) {
    const ClocksFound clocks = FindClocks(problem_, state_, workspace);
    if (!clocks.far) return false;
    problem_.SumAgain(state_, clocks.offsets);
    workspace.plan = FrontPlan(problem_);
    workspace.Linearise(problem_, state_);
    return true;
  }

  // The last step was small, but what hardly anything holds is held less where it led to: standard
  // deviations need a pass of their own.
  void Assess(ChainWorkspace& workspace) {
    if (!options_.covariance) {
      certainty_.singular = workspace.sweep.Undetermined(workspace.plan);
      return;
    }
    workspace.Linearise(problem_, state_);
    poses_.emplace(problem_, state_);
    certainty_ = AssessCertainty(problem_, state_, workspace, &*poses_);
    Ends("covariance");
  }

  void Tell(const WindowReport& windows) {
    Diagnostics& diagnostics = estimate_.diagnostics;
    diagnostics.singular = !certainty_.singular.empty();
    diagnostics.residuals = DescribeResiduals(problem_, state_);
    diagnostics.constants = DescribeConstants(problem_, state_, certainty_);
    diagnostics.notes = FarFromTold(problem_, state_);
    if (on_skin_)
      diagnostics.notes.push_back(
          "Sensors move on their segments: mountings are taken as they were told");
    if (poses_) {
      diagnostics.held_by_prior = HeldByPrior(problem_, certainty_);
      diagnostics.headings = DescribeHeadings(problem_, state_, *poses_);
      for (const std::string& note : HeadingsNotHeld(diagnostics.headings))
        diagnostics.notes.push_back(note);
    }
    const double residual_scale = ResidualScale(diagnostics.residuals, columns_);
    if (options_.scale_sd_by_residuals) ScaleStandardDeviations(residual_scale, estimate_);
    diagnostics.rests = DescribeRests(problem_);
    diagnostics.figures = {{"knots", static_cast<double>(problem_.size().knots)},
                           {"windows", static_cast<double>(windows.windows)},
                           {"window_iterations", static_cast<double>(windows.iterations)},
                           {"start_heading_span_s", windows.settling_span},
                           {"residual_scale", residual_scale}};
  }

  const SmootherOptions& options_;
  const Progress& progress_;
  StageClock watch_;
  Estimate estimate_;
  ArmProblem problem_;
  State state_;
  bool on_skin_ = false;
  int columns_ = 0;  // of all unknowns
  Certainty certainty_;
  std::optional<PoseCovariance> poses_;
};

Estimate SmoothedInStretches(const Observations& observations, const SmootherOptions& options,
                             const Progress& progress) {
  StreamedObservations trial = Streamed(observations);
  Estimate motion;
  const auto collect = [&](const Estimate& piece) { AppendMotion(piece, motion); };
  Estimate estimate = SmoothInStretches(trial, options, collect, progress);
  estimate.streamed = 0;
  AppendMotion(motion, estimate);
  return estimate;
}

}  // namespace

bool SmootherOptions::IsValid(std::string* why) const {
  if (!(knot_spacing_s >= 0.0)) return *why = "knot_spacing_s must not be negative", false;
  if (!(window_s > 0.0)) return *why = "window_s must be greater than 0", false;
  if (!(window_advance_s >= 0.0 && window_advance_s <= window_s))
    return *why = "window_advance_s must not be negative, and at most window_s", false;
  if (weight_iterations < 0) return *why = "weight_iterations must not be negative", false;
  if (!SolverNamed(solver)) return *why = "solver must be chain or ceres", false;
  if (threads < 1) return *why = "threads must be at least 1", false;
  if (!(shoulder_sigma_m >= 0.0)) return *why = "shoulder_sigma_m must not be negative", false;
  if (scale_sd_by_residuals && !whole_trial)
    return *why = "scale_sd_by_residuals needs whole_trial", false;
  return model.IsValid(why);
}

bool BatchSmoother::Accepts(const Observations& observations, std::string* why) const {
  return IsWholeChain(observations, why);
}

Estimate BatchSmoother::Run(const Observations& observations, const Progress& progress) const {
  if (!options_.whole_trial) return SmoothedInStretches(observations, options_, progress);
  return WholeTrial(observations, options_, progress).Run();
}

}  // namespace brachium
