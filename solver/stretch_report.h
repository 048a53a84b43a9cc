// What a trial that is smoothed in stretches has to report about itself: sums, and constants as they
// stand at its end.
#pragma once

#include <map>

#include "problems/estimate.h"
#include "solver/covariance.h"
#include "solver/residual_sums.h"
#include "solver/window.h"

namespace brachium {

// A stretch that was solved, up to the knot `stop` at which the next one begins.
struct SolvedStretch {
  const ArmProblem& problem;
  State& state;
  int stop = 0;
  bool is_last = false;
  const WindowReport& windows;
  const Certainty& certainty;     // by its last window
  bool singular = false;          // in any of them
  const ResidualSums& residuals;  // before `stop`, each as its window left it
  double unknowns = 0.0;          // before `stop`, by their tangent size
  int sums = 1;                   // how often its samples were summed
};

class StretchReport {
 public:
  void Add(const SolvedStretch& stretch);

  // Motion that leaves.
  void Add(const Estimate& piece);

  // After the last stretch: everything but the motion.
  Estimate Told() const;

 private:
  void AddRests(const SolvedStretch& stretch);
  std::vector<std::string> Notes() const;

  Estimate told_;  // as far as it is known
  ResidualSums residuals_;
  std::map<Segment, Rest> open_rests_;  // that reach the end of the last stretch
  WindowReport windows_;
  double stretches_ = 0.0, sums_ = 0.0, knots_ = 0.0, unknowns_ = 0.0;
  double start_ = 0.0;                        // of the trial [s]
  double heading_known_ = 0.0, loose_ = 0.0;  // samples: with a relative heading, little held
  double loosest_ = 0.0;                      // its greatest sd [rad]
  bool has_contacts_ = false;
};

}  // namespace brachium
