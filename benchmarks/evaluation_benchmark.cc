// Comparing ten minutes of an estimate with a reference whose frames are clusters and whose clock is
// not the sensors'.
#include <benchmark/benchmark.h>

#include "problems/evaluation.h"
#include "problems/simulation/simulate.h"

namespace brachium {
namespace {

void EvaluateTenMinutes(benchmark::State& state) {
  const Trial trial = Simulate(MakeScenario({.duration = 600.0}), {}).trial;
  Reference reference = *trial.reference;
  Estimate estimate;
  estimate.side = trial.observations.arm.side;
  estimate.time = reference.time;
  estimate.q_WB = reference.q_VB;
  estimate.p_W = reference.p_V;
  reference.frames = Reference::Frames::kCluster;
  reference.clock_offset.reset();
  for (auto _ : state) benchmark::DoNotOptimize(Evaluate(estimate, reference).used);
}
BENCHMARK(EvaluateTenMinutes)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace brachium

BENCHMARK_MAIN();
