// brachium sweep run: makes the results of a manifest's tasks.
#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <optional>

#include "bin/commands.h"
#include "bin/help.h"
#include "bin/sweep_run.h"

namespace brachium {
namespace {

struct RunFlags {
  std::string manifest;
  std::string task;
  std::string shard;
  int jobs = 0;

  bool IsValid(std::string* why) const {
    if (jobs < 0) return *why = "jobs must not be negative", false;
    if (!task.empty() && !shard.empty()) return *why = "either --task or --shard", false;
    return true;
  }

  template <typename Flags, typename Visitor>
  static void Visit(Flags& flags, Visitor&& visit) {
    visit("manifest", flags.manifest, "The manifest; results go beside it.");
    visit("task", flags.task,
          "One task only, from 0. Without --task and --shard: SLURM_ARRAY_TASK_ID where it is set, "
          "all tasks elsewhere.");
    visit("shard", flags.shard, "K/N: the K-th of N parts, K from 0 to N-1.");
    visit("jobs", flags.jobs,
          "How many tasks are run at a time, one thread each; 0: SLURM_CPUS_PER_TASK where it is "
          "set, else as many as the machine has. The results do not depend on it.");
  }
};

const CommandHelp kHelp = {
    "--manifest=FILE [--task=I | --shard=K/N] [--jobs=N]",
    "Runs the tasks of a sweep that have no valid result yet. A task that fails leaves a record "
    "and does not stop the others; the next run tries it again. May be ended at any moment and "
    "started again, and run on several machines that share the folder. Exits with 4 when a task "
    "of these failed."};

std::optional<std::size_t> Whole(std::string_view text) {
  std::size_t number = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || rest != text.data() + text.size()) return std::nullopt;
  return number;
}

std::string FromEnvironment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

std::vector<std::size_t> OneTask(const std::string& text, const std::string& origin,
                                 std::size_t tasks) {
  const auto task = Whole(text);
  if (!task || *task >= tasks)
    throw UsageError(origin + "=" + text + ": a task from 0 to " + std::to_string(tasks - 1) +
                     " was expected");
  return {*task};
}

std::vector<std::size_t> OneShard(const std::string& text, std::size_t tasks) {
  constexpr std::size_t kMostShards = 1000000;
  const std::size_t slash = std::min(text.find('/'), text.size());
  const auto shard = Whole(std::string_view(text).substr(0, slash));
  const auto shards = Whole(std::string_view(text).substr(std::min(slash + 1, text.size())));
  if (!shard || !shards || *shard >= *shards || *shards > kMostShards)
    throw UsageError("--shard=" + text +
                     ": K/N with K from 0 to N-1 was expected, N at most a million");
  return TasksOfShard(tasks, *shard, *shards);
}

std::vector<std::size_t> ChosenTasks(const RunFlags& flags, std::size_t tasks) {
  if (!flags.shard.empty()) return OneShard(flags.shard, tasks);
  if (!flags.task.empty()) return OneTask(flags.task, "--task", tasks);
  if (const std::string task = FromEnvironment("SLURM_ARRAY_TASK_ID"); !task.empty())
    return OneTask(task, "SLURM_ARRAY_TASK_ID", tasks);
  return TasksOfShard(tasks, 0, 1);
}

int JobsFrom(int flag) {
  const std::string given = FromEnvironment("SLURM_CPUS_PER_TASK");
  const auto cpus = Whole(given);
  if (flag > 0 || given.empty()) return flag;
  if (!cpus || *cpus == 0 || *cpus > std::numeric_limits<int>::max())
    throw UsageError("SLURM_CPUS_PER_TASK=" + given + ": a whole number was expected");
  return static_cast<int>(*cpus);
}

}  // namespace

int RunSweepRun(CommandLine& line) {
  RunFlags flags;
  line.Add("Flags", flags);
  if (ShowHelp(line, kHelp)) return kGood;
  line.Read();
  RequireGiven(flags.manifest, "manifest");
  RequireValid(flags);
  const SweepManifest manifest(flags.manifest);
  const SweepRunCounts counts =
      RunSweepTasks(manifest, ChosenTasks(flags, manifest.size()), JobsFrom(flags.jobs));
  std::cout << counts.done << " tasks done, " << counts.skipped << " were done before, "
            << counts.failed << " failed\n";
  return counts.failed > 0 ? kIncompleteSweep : kGood;
}

}  // namespace brachium
