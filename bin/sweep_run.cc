#include "bin/sweep_run.h"

#include <sys/resource.h>

#include <mutex>

#include "bin/in_parallel.h"
#include "bin/progress_line.h"
#include "bin/run_facts.h"
#include "bin/shared_trials.h"
#include "bin/sweep_task.h"
#include "bin/termination.h"
#include "io/input_error.h"
#include "io/sweep_results.h"

namespace brachium {
namespace {

using Outcome = SweepResult::Outcome;

double MostMemoryMb() {
  struct rusage usage {};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

void RequireSameVersions(const SweepTask& task, const std::string& manifest) {
  if (const auto here = VersionsJson(Versions()); task.versions != here)
    throw InputError(manifest, task.index + 1,
                     "was planned by " + task.versions.dump() + ", and this is " + here.dump() +
                         "; plan again, in another folder");
}

class SweepRun {
 public:
  explicit SweepRun(const SweepManifest& manifest) : manifest_(manifest) {}

  // What is left to do of these tasks.
  std::vector<std::size_t> Pending(const std::vector<std::size_t>& tasks) {
    std::vector<std::size_t> pending;
    for (const std::size_t index : tasks) {
      const SweepTask task = manifest_.At(index);
      RequireSameVersions(task, manifest_.file());
      const auto result = ReadSweepResult(manifest_.folder(), task);
      if (result && result->IsFinal()) {
        ++counts_.skipped;
        continue;
      }
      trials_.Expect(task);
      pending.push_back(index);
    }
    return pending;
  }

  void Run(std::size_t index) {
    const Stopwatch watch;
    const SweepTask task = manifest_.At(index);
    const SweepResult result = Result(task);
    const WithoutInterruption writing;
    WriteSweepResult(manifest_.folder(), task, result);
    AppendTiming(manifest_.folder(), HostName(),
                 {.task = index,
                  .method = task.method,
                  .seconds = watch.Seconds(),
                  .memory_mb = MostMemoryMb()});
    ++(result.IsFinal() ? counts_.done : counts_.failed);
  }

  const SweepRunCounts& counts() const { return counts_; }

 private:
  SweepResult Result(const SweepTask& task) try {
    return RunSweepTask(OptionsOf(task, manifest_.file()), *trials_.Take(task));
  } catch (const InputError& error) {
    return {.outcome = Outcome::kUnreadable, .reason = error.what()};
  }

  const SweepManifest& manifest_;
  SharedTrials trials_;
  SweepRunCounts counts_;  // changed under WithoutInterruption
};

}  // namespace

SweepRunCounts RunSweepTasks(const SweepManifest& manifest, const std::vector<std::size_t>& tasks,
                             int jobs) {
  SweepRun run(manifest);
  const std::vector<std::size_t> pending = run.Pending(tasks);
  ProgressLine line;
  const Progress progress = line.callback();
  std::mutex mutex;
  std::size_t done = 0;
  InParallel(pending.size(), jobs, [&](std::size_t i) {
    run.Run(pending[i]);
    const std::lock_guard lock(mutex);
    ++done;
    if (progress)
      progress("task " + std::to_string(pending[i]) + ", " + std::to_string(done) + " of " +
                   std::to_string(pending.size()),
               static_cast<double>(done) / static_cast<double>(pending.size()));
  });
  return run.counts();
}

std::vector<std::size_t> TasksOfShard(std::size_t tasks, std::size_t shard, std::size_t shards) {
  std::vector<std::size_t> part;
  for (std::size_t i = shard * tasks / shards; i < (shard + 1) * tasks / shards; ++i)
    part.push_back(i);
  return part;
}

}  // namespace brachium
