// Every method by its name on a simulated minute of an arm with two sensors at 100 Hz; items are
// samples of one sensor.
#include <benchmark/benchmark.h>

#include "problems/simulation/simulate.h"
#include "solver/estimators.h"

namespace brachium {
namespace {

constexpr double kDuration = 60.0;  // [s]

const Observations& OneMinute() {
  static const Observations observations =
      Simulate(MakeScenario({.name = "daily_brisk", .duration = kDuration}), {}).trial.observations;
  return observations;
}

void RunMethod(benchmark::State& state, const std::string& method) {
  const auto estimator = MakeEstimator(*DefaultOptions(method));
  const Observations& observations = OneMinute();
  if (std::string why; !estimator->Accepts(observations, &why))
    return state.SkipWithError(why.c_str());
  for (auto _ : state) benchmark::DoNotOptimize(estimator->Run(observations));
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) *
                          static_cast<std::int64_t>(observations.recordings.size() *
                                                    observations.recordings.front().size()));
  state.counters["x_real_time"] =
      benchmark::Counter(kDuration, benchmark::Counter::kIsIterationInvariantRate);
}

}  // namespace
}  // namespace brachium

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  for (const std::string& method : brachium::MethodNames())
    benchmark::RegisterBenchmark(method.c_str(), brachium::RunMethod, method)
        ->Unit(benchmark::kMillisecond);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
