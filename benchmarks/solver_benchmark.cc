// The parts of a solve on a simulated minute of an arm with two sensors at 100 Hz, its knots as far
// apart as by default; items are knots.
#include <benchmark/benchmark.h>

#include <algorithm>

#include "problems/simulation/simulate.h"
#include "solver/batch_smoother.h"
#include "solver/covariance.h"
#include "solver/least_squares.h"
#include "solver/window.h"

namespace brachium {
namespace {

constexpr double kNoDamping = 1e-15;

struct Minute {
  ArmProblem problem;
  State state;

  Minute()
      : problem(Simulate(MakeScenario({.name = "daily_brisk"}), {}).trial.observations, {},
                SmootherOptions{}.knot_spacing_s),
        state(problem.PriorState()) {}

  int LastKnot() const { return problem.size().knots - 1; }
  WindowReport PassWindows() { return SolveForward(problem, state, {.only_a_start = true}, {}); }
  SolveSummary SolveWhole(SolverKind solver, ChainWorkspace& workspace) {
    return Solve(problem, state, {}, 0, LastKnot(),
                 {.solver = solver, .most_iterations = 200, .step_in_sd = 0.01}, &workspace);
  }
};

// Where the windows leave it.
const State& AfterWindows(Minute& minute) {
  static const State after = (minute.PassWindows(), minute.state);
  minute.state = after;
  minute.problem.FixHeadings(after);
  return after;
}

void CountKnots(benchmark::State& state, const Minute& minute) {
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * minute.LastKnot());
}

// The samples summed, and the terms made of them.
void SetUp(benchmark::State& state) {
  const Observations observations =
      Simulate(MakeScenario({.name = "daily_brisk"}), {}).trial.observations;
  int knots = 0;
  for (auto _ : state)
    knots = ArmProblem(observations, {}, SmootherOptions{}.knot_spacing_s).size().knots;
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * (knots - 1));
}
BENCHMARK(SetUp)->Unit(benchmark::kMillisecond);

// One after the other: the search in each, and what it hands on to the next.
void Windows(benchmark::State& state) {
  Minute minute;
  const State prior = minute.state;
  WindowReport report;
  for (auto _ : state) {
    minute.state = prior;
    report = minute.PassWindows();
  }
  CountKnots(state, minute);
  state.counters["windows"] = report.windows;
  state.counters["steps"] = static_cast<double>(report.iterations) / report.windows;
}
BENCHMARK(Windows)->Unit(benchmark::kMillisecond);

// Which knot eliminates what: once a solve.
void Plan(benchmark::State& state) {
  Minute minute;
  FrontPlan plan(minute.problem);
  for (auto _ : state)
    plan.Build(minute.problem, minute.state, {},
               {.end_knot = minute.LastKnot() + 1, .last_knot = minute.LastKnot()});
  CountKnots(state, minute);
}
BENCHMARK(Plan)->Unit(benchmark::kMicrosecond);

// Where the windows left the minute, linearised and eliminated there.
struct Pass {
  Minute minute;
  ChainWorkspace workspace{minute.problem};

  Pass() {
    AfterWindows(minute);
    workspace.plan.Build(minute.problem, minute.state, {},
                         {.end_knot = minute.LastKnot() + 1, .last_knot = minute.LastKnot()});
    workspace.sweep.Prepare(workspace.plan);
    workspace.sweep.Run(workspace.plan, kNoDamping);
  }
};

// Values and derivatives of all terms, one after another.
void Linearise(benchmark::State& state) {
  Pass pass;
  const FrontPlan& plan = pass.workspace.plan;
  std::vector<double> r(static_cast<std::size_t>(plan.most_residuals()));
  std::vector<double> J(r.size() * static_cast<std::size_t>(plan.widest_term()));
  struct Blocks {
    std::vector<const double*> x;
    std::vector<double*> J;
  };
  std::vector<Blocks> terms;
  for (const Term& term : pass.minute.problem.terms()) {
    Blocks& blocks = terms.emplace_back();
    double* next = J.data();
    for (const int unknown : term.unknowns) {
      blocks.x.push_back(pass.minute.problem.Value(pass.minute.state, unknown));
      blocks.J.push_back(next);
      next +=
          term.cost->num_residuals() * TangentSize(pass.minute.problem.Describe(unknown).Size());
    }
  }
  benchmark::DoNotOptimize(J.data());
  for (auto _ : state) {
    for (std::size_t i = 0; i < terms.size(); ++i)
      pass.minute.problem.terms()[i].cost->EvaluateTangent(terms[i].x.data(), r.data(),
                                                           terms[i].J.data());
    benchmark::ClobberMemory();
  }
  CountKnots(state, pass.minute);
}
BENCHMARK(Linearise)->Unit(benchmark::kMicrosecond);

void LineariseAndEliminate(benchmark::State& state) {
  Pass pass;
  auto& [plan, sweep] = pass.workspace;
  for (auto _ : state) benchmark::DoNotOptimize(sweep.Run(plan, kNoDamping).cost);
  CountKnots(state, pass.minute);
}
BENCHMARK(LineariseAndEliminate)->Unit(benchmark::kMicrosecond);

void StepBack(benchmark::State& state) {
  Pass pass;
  auto& [plan, sweep] = pass.workspace;
  std::vector<double> step;
  for (auto _ : state) benchmark::DoNotOptimize(sweep.Step(plan, step));
  CountKnots(state, pass.minute);
}
BENCHMARK(StepBack)->Unit(benchmark::kMicrosecond);

// From where the windows left it to the minimum, its plan included.
void WholeTrial(benchmark::State& state, SolverKind solver) {
  Minute minute;
  const State& start = AfterWindows(minute);
  ChainWorkspace workspace(minute.problem);
  SolveSummary summary;
  for (auto _ : state) {
    minute.state = start;
    summary = minute.SolveWhole(solver, workspace);
  }
  if (!summary.converged) state.SkipWithError(summary.message.c_str());
  CountKnots(state, minute);
  state.counters["steps"] = summary.iterations;
  state.counters["final_cost"] = summary.final_cost;
}
BENCHMARK_CAPTURE(WholeTrial, chain, SolverKind::kChain)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(WholeTrial, ceres, SolverKind::kCeres)->Unit(benchmark::kMillisecond);

// Of all unknowns, at the minimum: forwards as in a pass, and backwards, again for most fronts.
void Covariance(benchmark::State& state) {
  Minute minute;
  AfterWindows(minute);
  ChainWorkspace workspace(minute.problem);
  minute.SolveWhole(SolverKind::kChain, workspace);
  for (auto _ : state) {
    PoseCovariance poses(minute.problem, minute.state);
    workspace.Linearise(minute.problem, minute.state);
    benchmark::DoNotOptimize(AssessCertainty(minute.problem, minute.state, workspace, &poses));
  }
  CountKnots(state, minute);
}
BENCHMARK(Covariance)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace brachium

BENCHMARK_MAIN();
