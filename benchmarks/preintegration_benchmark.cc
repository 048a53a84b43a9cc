// From samples to intervals: items are samples of one sensor at 100 Hz, summed from knot to knot.
#include <benchmark/benchmark.h>

#include "problems/preintegration.h"
#include "problems/simulation/simulate.h"
#include "problems/timeline.h"

namespace brachium {
namespace {

constexpr double kKnotSpacing = 0.1, kNodeSpacing = 10.0;  // [s]

const Recording& OneMinute() {
  static const Recording recording =
      Simulate(MakeScenario({.name = "daily_brisk"}), {}).trial.observations.recordings.back();
  return recording;
}

void CountSamples(benchmark::State& state) {
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) *
                          static_cast<std::int64_t>(OneMinute().size()));
}

// Cells, what is missing or out of range: before any interval is asked for.
void Prepare(benchmark::State& state) {
  const Recording& recording = OneMinute();
  for (auto _ : state) benchmark::DoNotOptimize(Preintegrator(recording).Period());
  CountSamples(state);
}
BENCHMARK(Prepare)->Unit(benchmark::kMicrosecond);

template <typename Interval>
void FromKnotToKnot(benchmark::State& state, const Interval& interval) {
  const std::vector<Preintegrator> samples{Preintegrator(OneMinute())};
  const std::vector<double> knots = MakeTimeline(samples, kKnotSpacing, kNodeSpacing).knots;
  for (auto _ : state)
    for (std::size_t i = 0; i + 1 < knots.size(); ++i)
      benchmark::DoNotOptimize(interval(samples.front(), knots[i], knots[i + 1]));
  CountSamples(state);
}

// Attitude, velocity and place, and what biases, scales and the clock change of them.
void Sum(benchmark::State& state) {
  FromKnotToKnot(state, [](const Preintegrator& samples, double start, double end) {
    return samples.Sum(start, end, Eigen::Vector3d::Zero());
  });
}
BENCHMARK(Sum)->Unit(benchmark::kMicrosecond);

// The attitude alone.
void Turn(benchmark::State& state) {
  FromKnotToKnot(state, [](const Preintegrator& samples, double start, double end) {
    return samples.Turn(start, end, Eigen::Vector3d::Zero());
  });
}
BENCHMARK(Turn)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace brachium

BENCHMARK_MAIN();
