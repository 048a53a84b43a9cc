#include "solver/batch_smoother.h"

#include <algorithm>

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

// The whole trial to convergence.
void SolveWholeTrial(const ArmProblem& problem, State& state, const SolveOptions& options,
                     ChainWorkspace& workspace, Diagnostics& diagnostics) {
  const SolveSummary summary =
      Solve(problem, state, {}, 0, problem.size().knots - 1, options, &workspace);
  if (diagnostics.iterations == 0) diagnostics.initial_cost = summary.initial_cost;
  diagnostics.iterations += summary.iterations;
  diagnostics.final_cost = summary.final_cost;
  diagnostics.gradient_norm = summary.gradient_norm;
  diagnostics.converged = summary.converged;
  diagnostics.termination = summary.message;
}

// Sensors that feel more than this beside what rigid segments explain move on them, and what they
// show of the elbow's axes is not to be trusted [m/s²]. Rigid ones: up to 0.02, on skin that turns by
// 1 deg 0.05, by 3 deg 0.15.
constexpr double kOnSkin = 0.1;

bool OnSkin(const ArmProblem& problem) {
  return std::any_of(problem.unmodelled().begin(), problem.unmodelled().end(),
                     [](const Unmodelled& left) { return left.acceleration > kOnSkin; });
}

// Sums the samples again where the movement tells a clock to be elsewhere; says whether it did.
// `workspace` then holds a pass over the new sums.
bool FollowsClocks(ArmProblem& problem, State& state, ChainWorkspace& workspace) {
  const ClocksFound clocks = FindClocks(problem, state, workspace);
  if (!clocks.far) return false;
  problem.SumAgain(state, clocks.offsets);
  workspace.plan = FrontPlan(problem);
  workspace.Linearise(problem, state);
  return true;
}

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
  StageClock watch;
  Estimate estimate;
  estimate.method = "smoother";
  estimate.side = observations.arm.side;
  estimate.time = observations.recordings.front().time;
  Diagnostics& diagnostics = estimate.diagnostics;
  const auto stage = [&](const char* name) { estimate.timing.push_back({name, watch.Lap()}); };

  const Observations prepared = Prepared(observations, options_);
  ArmProblem problem(prepared, options_.model, options_.knot_spacing_s,
                     observations.recordings.front().segment);
  stage("preintegration");

  const SolverKind solver = SolverNamed(options_.solver).value();
  State state = problem.PriorState();
  const bool judges_skin = options_.weight_iterations > 0;
  if (!judges_skin) problem.HoldMountings(state);
  // The first weights with lever arms and scales as told: free ones would absorb what the model
  // leaves out, and the weights would confirm them.
  UnmodelledSums left_by_windows(problem);
  const WindowReport windows =
      SolveForward(problem, state,
                   {.length = options_.window_s,
                    .only_a_start = true,
                    .solver = solver,
                    .unmodelled = judges_skin ? &left_by_windows : nullptr},
                   progress);
  if (judges_skin) problem.SetUnmodelled(left_by_windows.Estimate());
  stage("windows");

  ChainWorkspace workspace(problem);
  int sums = kMostSums;
  bool followed = false;
  for (int i = 1; i < options_.weight_iterations; i += followed ? 0 : 1) {
    if (progress) progress("weights", i / (options_.weight_iterations + 1.0));
    SolveWholeTrial(problem, state,
                    {.solver = solver,
                     .most_iterations = 4,
                     .least_decrease = 0.05,
                     .threads = options_.threads},
                    workspace, diagnostics);
    followed = sums-- > 0 && FollowsClocks(problem, state, workspace);
    UnmodelledSums left(problem);
    left.Add(problem, state, 0, problem.size().knots, workspace);
    problem.SetUnmodelled(left.Estimate());
  }
  const bool on_skin = judges_skin && problem.HasElbow() && OnSkin(problem);
  if (on_skin) problem.HoldMountings(state);
  if (progress) progress("whole trial", 0.9);
  for (int i = 0;; ++i) {
    SolveWholeTrial(
        problem, state,
        {.solver = solver, .most_iterations = 200, .step_in_sd = 0.01, .threads = options_.threads},
        workspace, diagnostics);
    if (i == kMostSums || !FollowsClocks(problem, state, workspace)) break;
  }
  stage("whole trial");

  FillTrajectory(problem, state, estimate);
  stage("trajectory");

  Certainty certainty;
  if (options_.covariance) {
    // The last step was small, but what hardly anything holds is held less where it led to.
    workspace.Linearise(problem, state);
    PoseCovariance poses(problem, state);
    certainty = AssessCertainty(problem, state, workspace, &poses);
    FillStandardDeviations(problem, poses, estimate);
    diagnostics.headings = DescribeHeadings(problem, state, poses);
    stage("covariance");
  } else {
    certainty.singular = workspace.sweep.Undetermined(workspace.plan);
  }
  diagnostics.singular = !certainty.singular.empty();
  diagnostics.residuals = DescribeResiduals(problem, state);
  diagnostics.constants = DescribeConstants(problem, state, certainty);
  if (options_.covariance) diagnostics.held_by_prior = HeldByPrior(problem, certainty);
  diagnostics.notes = FarFromTold(problem, state);
  if (on_skin)
    diagnostics.notes.push_back(
        "Sensors move on their segments: mountings are taken as they were told");
  for (const std::string& note : HeadingsNotHeld(diagnostics.headings))
    diagnostics.notes.push_back(note);
  const double residual_scale = ResidualScale(diagnostics.residuals, workspace.plan.columns());
  if (options_.scale_sd_by_residuals) ScaleStandardDeviations(residual_scale, estimate);
  diagnostics.rests = DescribeRests(problem);
  diagnostics.figures = {{"knots", static_cast<double>(problem.size().knots)},
                         {"windows", static_cast<double>(windows.windows)},
                         {"window_iterations", static_cast<double>(windows.iterations)},
                         {"start_heading_span_s", windows.settling_span},
                         {"residual_scale", residual_scale}};
  stage("results");
  return estimate;
}

}  // namespace brachium
