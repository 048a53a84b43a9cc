// Forward windows: a trial solved stretch by stretch, each warm-started by the last and told by a
// marginal prior what the knots that left had to say.
#pragma once

#include "solver/elimination.h"
#include "solver/estimator.h"
#include "solver/least_squares.h"
#include "solver/unmodelled.h"

namespace brachium {

struct WindowOptions {
  double length = 5.0;   // [s]
  double advance = 2.5;  // from one window to the next [s]
  // The whole trial is solved afterwards: geometry is held, windows do not overlap and are left where
  // steps have become small.
  bool only_a_start = false;
  SolverKind solver = SolverKind::kChain;
  UnmodelledSums* unmodelled = nullptr;  // takes what windows leave unexplained, if only_a_start
};

struct WindowReport {
  int windows = 0;
  int iterations = 0;
  double settling_span = 0.0;  // how much of the trial the choice of start headings took [s]
};

// Chooses the start headings by trying several on the first stretch and keeping the cheapest; the
// stretch grows until the choice is clear. What the start pose settles is not tried.
// Leaves the knots of the first window in `state`.
void ChooseStartHeadings(const ArmProblem& problem, State& state, const WindowOptions& options,
                         WindowReport& report);

// Sets the first knot, fixes the arm's heading there, and solves window after window; afterwards
// every knot holds the value with which it left its window.
WindowReport SolveForward(ArmProblem& problem, State& state, const WindowOptions& options,
                          const Progress& progress);

}  // namespace brachium
