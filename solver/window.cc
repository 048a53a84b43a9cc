#include "solver/window.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "solver/initial_guess.h"

namespace brachium {
namespace {

constexpr int kHeadings = 6;              // tried about the full turn
constexpr double kClearlyCheaper = 12.0;  // twice the log-likelihood ratio that settles a heading
constexpr double kDistinct = 20 * kDegree;

constexpr SolveOptions kWindowSolve{.most_iterations = 20, .step_in_sd = 1e-3};
constexpr SolveOptions kStartSolve{
    .most_iterations = 20, .least_decrease = 0.1, .hold_geometry = true};

// Lever arms that may flip would let a wrong heading explain everything.
constexpr SolveOptions kSettlingSolve{
    .most_iterations = 20, .step_in_sd = 1.0, .hold_geometry = true};

int KnotAt(const ArmProblem& problem, double time) {
  const auto& knots = problem.timeline().knots;
  const auto found = std::lower_bound(knots.begin(), knots.end(), time - 1e-9);
  return std::min(static_cast<int>(found - knots.begin()), problem.timeline().Intervals());
}

// Heading of a segment at the first knot against the one before it [rad].
double RelativeHeading(const State& state, int sensor) {
  using Attitude = Eigen::Map<const Eigen::Quaterniond>;
  const Eigen::Quaterniond q_turn =
      Attitude(state.Attitude(0, sensor)) * Attitude(state.Attitude(0, sensor - 1)).conjugate();
  return 2 * std::atan2(q_turn.z(), q_turn.w());
}

double Distance(double a, double b) {
  return std::abs(std::remainder(a - b, 2 * std::numbers::pi));
}

bool IsSettledByPose(const ArmProblem& problem, int sensor) {
  const auto& pose = problem.observations().start_pose;
  return pose && pose->forearm_pronation && sensor == problem.SensorOn(Segment::kForearm) &&
         problem.SensorOn(Segment::kUpperArm) >= 0;
}

struct Trial {
  State state;
  double cost;
};

// Tries headings of one segment over the knots up to `last`; says whether one is clearly cheaper.
bool TryHeadings(const ArmProblem& problem, State& state, int sensor, int last,
                 const SolveOptions& solve, ChainWorkspace& workspace, WindowReport& report) {
  std::optional<Trial> best;
  std::vector<std::pair<double, double>> found;  // heading reached, cost
  for (int i = 0; i < kHeadings; ++i) {
    Trial trial{state, 0.0};
    for (int link = sensor; link < problem.size().sensors; ++link)
      TurnFirstKnot(trial.state, link, 2 * std::numbers::pi * i / kHeadings);
    DeadReckon(problem, trial.state, 0, last);
    const auto summary = Solve(problem, trial.state, {}, 0, last, solve, &workspace);
    report.iterations += summary.iterations;
    trial.cost = summary.final_cost;
    found.emplace_back(RelativeHeading(trial.state, sensor), trial.cost);
    if (!best || trial.cost < best->cost) best = std::move(trial);
  }
  const double heading = RelativeHeading(best->state, sensor);
  state = std::move(best->state);
  return std::all_of(found.begin(), found.end(), [&](const auto& other) {
    return Distance(other.first, heading) < kDistinct ||
           2 * (other.second - best->cost) > kClearlyCheaper;
  });
}

}  // namespace

void ChooseStartHeadings(const ArmProblem& problem, State& state, const WindowOptions& options,
                         WindowReport& report) {
  const Timeline& timeline = problem.timeline();
  ChainWorkspace workspace(problem);
  SolveOptions solve = kSettlingSolve;
  solve.solver = options.solver;
  for (int sensor = 1; sensor < problem.size().sensors; ++sensor) {
    if (IsSettledByPose(problem, sensor)) continue;
    const State start = state;
    bool clear = false;
    for (double span = kShortestSettling; !clear && span <= kLongestSettling; span *= 2) {
      state = start;
      const int last = KnotAt(problem, timeline.knots.front() + span);
      clear = TryHeadings(problem, state, sensor, last, solve, workspace, report) ||
              last == timeline.Intervals();
      report.settling_span =
          std::max(report.settling_span,
                   timeline.knots[static_cast<std::size_t>(last)] - timeline.knots.front());
    }
  }
}

void SetStart(ArmProblem& problem, State& state, const WindowOptions& options,
              WindowReport& report) {
  SetFirstKnot(problem, state);
  problem.FixHeadings(state);
  ChooseStartHeadings(problem, state, options, report);
  problem.FixHeadings(state);
}

ForwardWindows::ForwardWindows(const ArmProblem& problem, State& state, CarriedPrior prior,
                               const WindowOptions& options, WindowReport& report)
    : problem_(problem),
      state_(state),
      prior_(std::move(prior)),
      options_(options),
      solve_(options.only_a_start ? kStartSolve : kWindowSolve),
      report_(report),
      workspace_(problem) {
  solve_.solver = options.solver;
}

void ForwardWindows::Solve() {
  const Timeline& timeline = problem_.timeline();
  const int known = end_, last = timeline.Intervals();
  const double time = timeline.knots[static_cast<std::size_t>(start_)];
  end_ = std::max(KnotAt(problem_, time + options_.length), start_ + 1);
  if (end_ + 1 >= last) end_ = last;
  DeadReckon(problem_, state_, known, end_);
  solve_.hand_on = options_.only_a_start && end_ < last;
  const auto summary = brachium::Solve(problem_, state_, prior_, start_, end_, solve_, &workspace_);
  report_.iterations += summary.iterations;
  report_.unconverged += summary.converged ? 0 : 1;
  if (options_.only_a_start && options_.unmodelled != nullptr)
    options_.unmodelled->Add(problem_, start_, solve_.hand_on ? end_ : end_ + 1, workspace_);
  ++report_.windows;
}

int ForwardWindows::NextStart(int limit) const {
  if (options_.only_a_start) return end_;
  const double time = problem_.timeline().knots[static_cast<std::size_t>(start_)];
  return std::min(std::max(KnotAt(problem_, time + options_.advance), start_ + 1), limit);
}

void ForwardWindows::Advance(int limit) {
  const Timeline& timeline = problem_.timeline();
  const int next = NextStart(limit);
  HoldBias(problem_, state_,
           timeline.NodeBefore(timeline.knots[static_cast<std::size_t>(end_)]) + 1);
  if (options_.only_a_start) {
    prior_ = Elimination(workspace_).Carry();
    start_ = next;
    return;
  }
  const Elimination elimination(problem_, state_, prior_, start_, next, workspace_);
  left_behind_ += elimination.eliminated();
  prior_ = elimination.Carry();
  start_ = next;
}

WindowReport SolveForward(ArmProblem& problem, State& state, const WindowOptions& options,
                          const Progress& progress) {
  WindowReport report;
  SetStart(problem, state, options, report);
  const Timeline& timeline = problem.timeline();
  const int last = timeline.Intervals();
  const double begin = timeline.knots.front(), span = timeline.knots.back() - begin;
  ForwardWindows windows(problem, state, {}, options, report);
  for (;;) {
    windows.Solve();
    const double time = timeline.knots[static_cast<std::size_t>(windows.end())];
    if (progress) progress("windows", (time - begin) / span);
    if (windows.end() == last) return report;
    windows.Advance(last);
  }
}

}  // namespace brachium
