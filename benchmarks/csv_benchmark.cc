// Reading and writing comma-separated text: a recording of a million rows, and the estimate of a
// minute with all its standard deviations.
#include <benchmark/benchmark.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

#include "io/csv.h"
#include "io/estimate_csv.h"
#include "problems/simulation/simulate.h"
#include "solver/batch_smoother.h"

namespace brachium {
namespace {

constexpr std::size_t kRows = 1'000'000;
constexpr std::size_t kColumns = 7;

// Numbers as sensors give them: time to the microsecond, seven significant digits.
std::vector<double> SyntheticRecording() {
  std::vector<double> numbers(kRows * kColumns);
  for (std::size_t row = 0; row < kRows; ++row) {
    const double t = 0.01 * static_cast<double>(row);
    numbers[row * kColumns] = std::round(t * 1e6) / 1e6;
    for (std::size_t c = 1; c < kColumns; ++c)
      numbers[row * kColumns + c] =
          std::round(1e6 * std::sin(t * static_cast<double>(c))) / 1e6 + (c == 6 ? 9.81 : 0.0);
  }
  return numbers;
}

std::vector<CsvColumn> ColumnsOf(const std::vector<double>& numbers) {
  const char* const names[] = {"time_s", "gyr_x", "gyr_y", "gyr_z", "acc_x", "acc_y", "acc_z"};
  std::vector<CsvColumn> columns;
  for (std::size_t c = 0; c < kColumns; ++c)
    columns.push_back({names[c], numbers.data() + c, kColumns});
  return columns;
}

std::string File() {
  return (std::filesystem::temp_directory_path() /
          ("brachium_csv_benchmark." + std::to_string(getpid()) + ".csv"))
      .string();
}

void CountBytes(benchmark::State& state, const std::string& file) {
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) *
                          static_cast<std::int64_t>(std::filesystem::file_size(file)));
  std::filesystem::remove(file);
}

void WriteRecording(benchmark::State& state) {
  const std::vector<double> numbers = SyntheticRecording();
  const std::vector<CsvColumn> columns = ColumnsOf(numbers);
  for (auto _ : state) WriteCsv(File(), kRows, columns);
  CountBytes(state, File());
}
BENCHMARK(WriteRecording)->Unit(benchmark::kMillisecond)->UseRealTime();

void ReadRecording(benchmark::State& state) {
  const std::vector<double> numbers = SyntheticRecording();
  WriteCsv(File(), kRows, ColumnsOf(numbers));
  for (auto _ : state) benchmark::DoNotOptimize(ReadCsv(File()));
  CountBytes(state, File());
}
BENCHMARK(ReadRecording)->Unit(benchmark::kMillisecond)->UseRealTime();

const Estimate& EstimateOfAMinute() {
  static const Estimate estimate =
      BatchSmoother({}).Run(Simulate(MakeScenario({.name = "daily_brisk"}), {}).trial.observations);
  return estimate;
}

void WriteEstimate(benchmark::State& state) {
  const Estimate& estimate = EstimateOfAMinute();
  for (auto _ : state) WriteEstimateCsv(estimate, File());
  CountBytes(state, File());
}
BENCHMARK(WriteEstimate)->Unit(benchmark::kMillisecond)->UseRealTime();

void ReadEstimate(benchmark::State& state) {
  WriteEstimateCsv(EstimateOfAMinute(), File());
  for (auto _ : state) benchmark::DoNotOptimize(ReadEstimateCsv(File()));
  CountBytes(state, File());
}
BENCHMARK(ReadEstimate)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace brachium

BENCHMARK_MAIN();
