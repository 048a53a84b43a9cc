// The batch smoother: the whole trial as one nonlinear least-squares problem, approached through
// windows that move forward in time and hand a marginal prior on.
#pragma once

#include <string>

#include "problems/arm_problem.h"
#include "solver/estimator.h"

namespace brachium {

struct SmootherOptions {
  double knot_spacing_s = 0.1;
  bool whole_trial = true;
  double window_s = 20.0;
  double window_advance_s = 0.0;
  int weight_iterations = 2;
  bool covariance = true;
  bool scale_sd_by_residuals = false;
  std::string solver = "chain";
  int threads = 1;
  double shoulder_sigma_m = 0.0;
  ModelOptions model;

  bool IsValid(std::string* why) const;

  double WindowAdvance() const { return window_advance_s > 0.0 ? window_advance_s : window_s / 2; }

  // Names, values and help texts, once: flags, run.flags, summary.json and sweeps read them here.
  // `Options` is SmootherOptions or const SmootherOptions.
  template <typename Options, typename Visitor>
  static void Visit(Options& options, Visitor&& visit) {
    visit("knot_spacing_s", options.knot_spacing_s,
          "Time between instants with unknowns [s]. Smaller follows faster motion and costs more; "
          "0 puts one at every sample.");
    visit("whole_trial", options.whole_trial,
          "Solve the whole trial at once after the windows. Off: windows only, stretch by stretch "
          "in memory that does not grow with the trial; standard deviations then know nothing of "
          "what comes later.");
    visit("window_s", options.window_s, "Length of a forward window [s].");
    visit("window_advance_s", options.window_advance_s,
          "From the start of one window to the start of the next [s]; 0: half a window. Where the "
          "whole trial is solved, windows do not overlap.");
    visit(
        "weight_iterations", options.weight_iterations,
        "How often the accelerometers' weights are estimated from the residuals: first from those "
        "of the windows, then of the whole trial, which is solved again each time. 0 keeps the "
        "first guess. Without the whole trial any other number means: of all stretches so far.");
    visit("covariance", options.covariance,
          "Tell standard deviations, of the constants too, and what only its prior holds. Off: "
          "about a third of the time is saved.");
    visit(
        "scale_sd_by_residuals", options.scale_sd_by_residuals,
        "Multiply all standard deviations by the rms of the whitened residuals over their degrees "
        "of freedom (summary.json, figures.residual_scale). It mends sigmas that are all wrong "
        "alike; what hardly shows in residuals, a gyroscope's noise told wrong, it does not.");
    visit("solver", options.solver,
          "What finds the minimum: chain, which eliminates along time, or ceres, which is slower "
          "and checks it.");
    visit("threads", options.threads,
          "Threads of one solve by ceres; the chain takes one. The answer depends on their number "
          "in the last digits.");
    visit(
        "shoulder_sigma_m", options.shoulder_sigma_m,
        "How far the shoulder strays from its mean place, per axis [m]; 0: as the trial says. Less "
        "holds the arm's place better, and takes a shrug for something else.");
    ModelOptions::Visit(options.model, visit);
  }
};

class BatchSmoother final : public Estimator {
 public:
  explicit BatchSmoother(const SmootherOptions& options) : options_(options) {}
  bool Accepts(const Observations& observations, std::string* why) const override;
  Estimate Run(const Observations& observations, const Progress& progress = {}) const override;

 private:
  SmootherOptions options_;
};

}  // namespace brachium
