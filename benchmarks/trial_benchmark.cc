// A whole trial against its length: `brachium reconstruct` as users run it, reading and writing
// included, on simulated arms with two sensors at 100 Hz. Every run is a process of its own, whose
// memory and seconds no other run mixes with; trials are simulated once, in a temporary folder.
//
//   trial_benchmark --benchmark_filter=minutes:1/ --benchmark_repetitions=5
//
// Time is wall time. Counters: processor_s; MB, the most memory; x_real_time; the program's own
// stages [s] (timing.json), and as stage:else what is left of the wall time.
#include <benchmark/benchmark.h>
#include <stdlib.h>
#include <sys/resource.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/own_child.h"

namespace brachium {
namespace {

namespace fs = std::filesystem;

struct Spent {
  int exit_code = -1;
  double wall_s = 0.0, processor_s = 0.0, mb = 0.0;
};

double Seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

// Runs the program, silently.
Spent Run(std::vector<std::string> words) {
  words.insert(words.begin(), BRACHIUM_PROGRAM);
  Spent spent;
  rusage usage = {};
  const auto start = std::chrono::steady_clock::now();
  spent.exit_code = OwnChild(std::move(words)).Wait(&usage);
  spent.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  spent.processor_s = Seconds(usage.ru_utime) + Seconds(usage.ru_stime);
  spent.mb = static_cast<double>(usage.ru_maxrss) * 1024 / 1e6;
  return spent;
}

class Trials {
 public:
  Trials() {
    std::string name = (fs::temp_directory_path() / "brachium_trial_benchmark.XXXXXX").string();
    if (mkdtemp(name.data()) != nullptr) path_ = name;
  }
  ~Trials() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove_all(path_, ignored);
  }

  // Its folder; empty where it could not be made.
  std::string OfMinutes(std::int64_t minutes) {
    const std::string folder = path_ + "/" + std::to_string(minutes) + "min";
    if (path_.empty()) return "";
    if (made_.contains(minutes)) return folder;
    if (Run({"simulate", "--scenario=daily_brisk", "--duration_s=" + std::to_string(60 * minutes),
             "--output=" + folder})
            .exit_code != 0)
      return "";
    made_.insert(minutes);
    return folder;
  }
  std::string Estimate() const { return path_ + "/estimate"; }

 private:
  std::string path_;
  std::set<std::int64_t> made_;
};

void CountStages(benchmark::State& state, const std::string& timing_file, double wall_s) {
  const auto timing = nlohmann::json::parse(std::ifstream(timing_file));
  double rest = wall_s;
  for (const auto& stage : timing.at("stages")) {
    const double seconds = stage.at("seconds").get<double>();
    state.counters["stage:" + stage.at("stage").get<std::string>()] = seconds;
    rest -= seconds;
  }
  state.counters["stage:else"] = rest;
}

void Reconstruct(benchmark::State& state) {
  static Trials trials;
  const std::int64_t minutes = state.range(0);
  const std::string trial = trials.OfMinutes(minutes);
  if (trial.empty()) return state.SkipWithError("no trial could be simulated");
  Spent spent;
  for (auto _ : state) {
    spent = Run({"reconstruct", "--trial=" + trial, "--output=" + trials.Estimate(), "--overwrite",
                 state.range(1) == 0 ? "--covariance=false" : "--covariance=true"});
    state.SetIterationTime(spent.wall_s);
  }
  if (spent.exit_code != 0)
    return state.SkipWithError(
        ("the program exits with " + std::to_string(spent.exit_code)).c_str());
  state.counters["processor_s"] = spent.processor_s;
  state.counters["MB"] = spent.mb;
  state.counters["x_real_time"] = 60.0 * static_cast<double>(minutes) / spent.wall_s;
  CountStages(state, trials.Estimate() + "/timing.json", spent.wall_s);
}
BENCHMARK(Reconstruct)
    ->ArgNames({"minutes", "covariance"})
    ->ArgsProduct({{1, 2, 5, 10, 30, 60}, {1, 0}})
    ->Iterations(1)
    ->UseManualTime()
    ->Unit(benchmark::kSecond);

}  // namespace
}  // namespace brachium

BENCHMARK_MAIN();
