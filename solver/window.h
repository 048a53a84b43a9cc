// Forward windows: a trial solved stretch by stretch, each warm-started by the last and told by a
// marginal prior what the knots that left had to say.
#pragma once

#include "solver/elimination.h"
#include "solver/estimator.h"
#include "solver/least_squares.h"
#include "solver/unmodelled.h"

namespace brachium {

struct WindowOptions {
  double length = 20.0;   // [s]
  double advance = 10.0;  // from one window to the next [s]
  // The whole trial is solved afterwards: geometry is held, windows do not overlap and are left where
  // steps have become small.
  bool only_a_start = false;
  SolverKind solver = SolverKind::kChain;
  UnmodelledSums* unmodelled = nullptr;  // takes what windows leave unexplained, if only_a_start
};

struct WindowReport {
  int windows = 0;
  int unconverged = 0;  // of them
  int iterations = 0;
  double settling_span = 0.0;  // how much of the trial the choice of start headings took [s]
};

// Chooses the start headings by trying several on the first stretch and keeping the cheapest; the
// stretch grows until the choice is clear. What the start pose settles is not tried.
// Leaves the knots of the first window in `state`.
void ChooseStartHeadings(const ArmProblem& problem, State& state, const WindowOptions& options,
                         WindowReport& report);

// Choosing takes at least and at most this much of a trial [s].
inline constexpr double kShortestSettling = 5.0, kLongestSettling = 80.0;

// Sets the first knot, chooses the start headings and fixes the arm's heading there.
void SetStart(ArmProblem& problem, State& state, const WindowOptions& options,
              WindowReport& report);

// One window after another, from the first knot on, whose value `state` has. A knot that is left
// behind keeps the value with which it left its last window. All arguments must outlive this.
class ForwardWindows {
 public:
  // `prior`: about the first knot; none where the trial begins.
  ForwardWindows(const ArmProblem& problem, State& state, CarriedPrior prior,
                 const WindowOptions& options, WindowReport& report);

  // Solves the window that begins at start().
  void Solve();

  // Where the next window begins: no further than `limit`, by one knot at least. Windows that are only
  // a start do not overlap.
  int NextStart(int limit) const;

  // Moves start() there.
  void Advance(int limit);

  int start() const { return start_; }
  int end() const { return end_; }                      // last knot of the window that was solved
  const CarriedPrior& prior() const { return prior_; }  // with which it begins
  ChainWorkspace& workspace() { return workspace_; }
  int left_behind() const { return left_behind_; }  // unknowns, by their tangent size

 private:
  const ArmProblem& problem_;
  State& state_;
  CarriedPrior prior_;
  const WindowOptions& options_;
  SolveOptions solve_;
  WindowReport& report_;
  ChainWorkspace workspace_;
  int start_ = 0, end_ = 0;
  int left_behind_ = 0;
};

// Sets the start and solves window after window; afterwards every knot holds the value with which it
// left its window.
WindowReport SolveForward(ArmProblem& problem, State& state, const WindowOptions& options,
                          const Progress& progress);

}  // namespace brachium
