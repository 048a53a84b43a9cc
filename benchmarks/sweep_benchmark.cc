// What a sweep costs besides its solves: writing the manifest, and merging, of so many tasks. MB: the
// most memory of the program so far, the smaller sweeps first.
#include <benchmark/benchmark.h>
#include <sys/resource.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "io/streamed_file.h"
#include "io/sweep_merge.h"
#include "solver/batch_smoother.h"

namespace brachium {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kTrials = 20;
constexpr int kFigures = 60;

class SweepFolder {
 public:
  ~SweepFolder() { fs::remove_all(path_); }
  const std::string& path() const { return path_; }
  std::string manifest() const { return path_ + "/manifest.jsonl"; }

 private:
  std::string path_ =
      (fs::temp_directory_path() / ("brachium_sweep_benchmark." + std::to_string(getpid())))
          .string();
};

// Trial by trial, at points of two options.
SweepTask TaskNumber(std::size_t index, std::size_t tasks) {
  const std::size_t points = tasks / kTrials, trial = index / points, point = index % points;
  SmootherOptions options;
  options.model.elbow_adduction_sigma_deg = 1.0 + static_cast<double>(point / 50);
  options.model.elbow_wobble_sigma_deg = 1.0 + static_cast<double>(point % 50);
  SweepTask task{.index = index,
                 .trial = "trial" + std::to_string(trial),
                 .path = "/data/trials/trial" + std::to_string(trial),
                 .duration = 90.0,
                 .method = "smoother"};
  SmootherOptions::Visit(options, [&](const char* name, const auto& value, const char*) {
    task.options[name] = value;
  });
  for (const char* name : {"elbow_adduction_sigma_deg", "elbow_wobble_sigma_deg"})
    task.varied[name] = task.options[name];
  task.versions = VersionsJson({{"brachium", "0"}});
  task.inputs = InputsHash({});
  task.key = KeyOf(task);
  return task;
}

void WriteManifest(const SweepFolder& folder, std::size_t tasks) {
  StreamedFile manifest(folder.manifest());
  for (std::size_t i = 0; i < tasks; ++i) manifest.Append(ManifestLine(TaskNumber(i, tasks)));
  manifest.Commit(true, "");
}

// As the program writes them, but not synced one by one.
void WriteResults(const SweepFolder& folder, std::size_t tasks) {
  nlohmann::ordered_json figures;
  figures[kUsualSweepFigure] = 1.0 / 3.0;
  for (int i = 1; i < kFigures; ++i)
    figures["joint_angles.some_angle_" + std::to_string(i) + ".rmse_deg"] = i / 7.0;
  for (std::size_t i = 0; i < tasks; ++i) {
    const std::string file = SweepResultFile(folder.path(), i);
    fs::create_directories(fs::path(file).parent_path());
    std::ofstream(file) << nlohmann::ordered_json{
        {"task", i},         {"key", TaskNumber(i, tasks).key},
        {"outcome", "done"}, {"trusted", true},
        {"reason", ""},      {"figures", figures}};
  }
}

double MostMemoryMb() {
  struct rusage usage {};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

void Plan(benchmark::State& state) {
  const SweepFolder folder;
  for (auto _ : state) WriteManifest(folder, static_cast<std::size_t>(state.range(0)));
  state.counters["MB"] = MostMemoryMb();
}

void Merge(benchmark::State& state) {
  const SweepFolder folder;
  const auto tasks = static_cast<std::size_t>(state.range(0));
  WriteManifest(folder, tasks);
  WriteResults(folder, tasks);
  for (auto _ : state) {
    const SweepManifest manifest(folder.manifest());
    SweepRows rows(folder.path());
    const SweepTable table = ReadSweep(manifest, kUsualSweepFigure, &rows);
    WriteSweep(folder.path(), table, &rows, true);
    if (!table.Complete()) state.SkipWithError("the results are not those of the plan");
  }
  state.counters["MB"] = MostMemoryMb();
}

void UpTo100000(benchmark::internal::Benchmark* sweep) {
  sweep->Arg(10000)->Arg(100000)->Iterations(1)->Unit(benchmark::kMillisecond)->UseRealTime();
}
BENCHMARK(Plan)->Apply(UpTo100000);
BENCHMARK(Merge)->Apply(UpTo100000);

}  // namespace
}  // namespace brachium

BENCHMARK_MAIN();
