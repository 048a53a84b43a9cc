// The batch smoother: the whole trial as one nonlinear least-squares problem, approached through
// windows that move forward in time and hand a marginal prior on.
#pragma once

#include <string>

#include "solver/estimator.h"

namespace brachium {

// Sigmas are physical: they depend neither on the sampling rate nor on the knot spacing.
struct SmootherOptions {
  double knot_spacing_s = 0.05;
  bool whole_trial = true;
  double window_s = 5.0;

  bool IsValid(std::string* why) const;

  // Names, values and help texts, once: flags, run.flags, summary.json and sweeps read them here.
  // `Options` is SmootherOptions or const SmootherOptions.
  template <typename Options, typename Visitor>
  static void Visit(Options& options, Visitor&& visit) {
    visit("knot_spacing_s", options.knot_spacing_s,
          "Time between instants with unknowns [s]. Smaller follows faster motion and costs more; "
          "0 puts one at every sample.");
    visit("whole_trial", options.whole_trial,
          "Solve the whole trial at once after the windows. Off: windows only, memory bounded.");
    visit("window_s", options.window_s, "Length of a forward window [s].");
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
