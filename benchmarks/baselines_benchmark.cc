// The filters of the baselines on five simulated minutes of an arm: samples of one sensor a second.
#include <benchmark/benchmark.h>

#include "problems/simulation/simulate.h"
#include "solver/estimators.h"

namespace brachium {
namespace {

const Observations& FiveMinutes() {
  static const Observations observations =
      Simulate(MakeScenario({.name = "daily_brisk", .duration = 300.0}), {}).trial.observations;
  return observations;
}

void RunMethod(benchmark::State& state, const char* method) {
  const auto estimator = MakeEstimator(*DefaultOptions(method));
  const Observations& observations = FiveMinutes();
  for (auto _ : state) benchmark::DoNotOptimize(estimator->Run(observations));
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) *
                          static_cast<std::int64_t>(observations.recordings.size() *
                                                    observations.recordings.front().size()));
}
BENCHMARK_CAPTURE(RunMethod, gyroscope, "gyroscope")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(RunMethod, luinge_unconstrained, "luinge_unconstrained")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(RunMethod, luinge, "luinge")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(RunMethod, luinge_rts, "luinge_rts")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(RunMethod, heading_corrected, "heading_corrected")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(RunMethod, zhou, "zhou")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(RunMethod, bai_kinematic, "bai_kinematic")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(RunMethod, bai_dead_reckoning_zupt, "bai_dead_reckoning_zupt")
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace brachium

BENCHMARK_MAIN();
