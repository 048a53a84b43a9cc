// brachium sweep submit: hands the tasks that are left to Slurm, or runs them here.
#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <iostream>

#include "bin/commands.h"
#include "bin/help.h"
#include "bin/sweep_jobs.h"
#include "bin/sweep_merge.h"
#include "bin/sweep_run.h"
#include "bin/sweep_text.h"
#include "io/output_folder.h"
#include "io/sweep_merge.h"
#include "io/sweep_results.h"

namespace brachium {
namespace {

namespace fs = std::filesystem;

struct SubmitFlags {
  std::string manifest;
  std::string engine = "slurm";
  bool dry_run = false;
  double shard_minutes = 10.0;
  int at_a_time = 0;
  std::string account;
  std::string partition;

  bool IsValid(std::string* why) const {
    if (engine != "slurm" && engine != "local")
      return *why = "--engine=" + engine + ": slurm or local was expected", false;
    if (shard_minutes <= 0.0) return *why = "shard_minutes must be positive", false;
    if (at_a_time < 0) return *why = "at_a_time must not be negative", false;
    return true;
  }

  template <typename Flags, typename Visitor>
  static void Visit(Flags& flags, Visitor&& visit) {
    visit("manifest", flags.manifest, "The manifest, in a folder that all machines share.");
    visit("engine", flags.engine, "slurm: an array of jobs and a merge after it; local: here.");
    visit("dry_run", flags.dry_run, "Show what would be submitted, and submit nothing.");
    visit("shard_minutes", flags.shard_minutes,
          "About how long a job of the array takes [min]. More asks less of the scheduler.");
    visit("at_a_time", flags.at_a_time, "Most jobs of the array at a time; 0: no limit.");
    visit("account", flags.account, "Passed to sbatch.");
    visit("partition", flags.partition, "Passed to sbatch.");
  }
};

const CommandHelp kHelp = {
    "--manifest=FILE --engine=slurm|local [--dry_run] [flags]",
    "Submits those parts of a sweep that have tasks left, as a Slurm array of one core each, and a "
    "merge that waits for it. Time and memory are asked for by the tasks run so far; if there are "
    "none, one is run here first."};

struct Measured {
  std::size_t tasks = 0;
  double seconds = 0.0;  // mean of a task
  double memory_mb = 0.0;
};

Measured MeasuredTasks(const std::string& folder) {
  Measured measured;
  ForEachTiming(folder, [&](const TaskTiming& timing) {
    ++measured.tasks;
    measured.seconds += timing.seconds;
    measured.memory_mb = std::max(measured.memory_mb, timing.memory_mb);
  });
  if (measured.tasks > 0) measured.seconds /= static_cast<double>(measured.tasks);
  return measured;
}

std::vector<std::size_t> OpenShards(const SweepManifest& manifest, std::size_t shards) {
  std::vector<std::size_t> open;
  for (std::size_t shard = 0; shard < shards; ++shard) {
    const auto tasks = TasksOfShard(manifest.size(), shard, shards);
    const bool left = std::any_of(tasks.begin(), tasks.end(), [&](std::size_t i) {
      const auto result = ReadSweepResult(manifest.folder(), manifest.At(i));
      return !result || !result->IsFinal();
    });
    if (left) open.push_back(shard);
  }
  return open;
}

SweepJobs JobsFor(const SweepManifest& manifest, const SubmitFlags& flags) {
  if (!flags.dry_run && MeasuredTasks(manifest.folder()).tasks == 0)
    RunSweepTasks(manifest, {0}, 1);
  const Measured measured = MeasuredTasks(manifest.folder());
  SweepJobs jobs{.program = fs::read_symlink("/proc/self/exe").string(),
                 .manifest = fs::absolute(manifest.file()).lexically_normal().string(),
                 .account = flags.account,
                 .partition = flags.partition,
                 .at_a_time = flags.at_a_time,
                 .memory_mb = measured.memory_mb};
  jobs.shards = ShardsFor(manifest.size(), measured.seconds, flags.shard_minutes);
  jobs.open_shards = OpenShards(manifest, jobs.shards);
  jobs.shard_seconds =
      measured.seconds * static_cast<double>(manifest.size()) / static_cast<double>(jobs.shards);
  return jobs;
}

// The first line that a command says. Throws OutputError when it fails.
std::string FirstLineOf(const std::string& command) {
  std::string text;
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) throw OutputError(command + ": cannot be run");
  std::array<char, 256> part{};
  while (std::fgets(part.data(), static_cast<int>(part.size()), pipe) != nullptr)
    text += part.data();
  if (pclose(pipe) != 0) throw OutputError("sbatch did not take the sweep: " + command);
  return text.substr(0, text.find('\n'));
}

int SubmitToSlurm(const SweepJobs& jobs) {
  const fs::path folder = fs::path(jobs.manifest).parent_path() / "slurm";
  const std::string array = (folder / "array.sbatch").string();
  const std::string merge = (folder / "merge.sbatch").string();
  WriteOneFile(array, ArrayScript(jobs), true);
  WriteOneFile(merge, MergeScript(jobs), true);
  const std::string array_job = FirstLineOf("sbatch --parsable " + ShellQuoted(array));
  const std::string merge_job = FirstLineOf(
      "sbatch --parsable --dependency=afterany:" + array_job.substr(0, array_job.find(';')) + " " +
      ShellQuoted(merge));
  std::cout << "Submitted " << jobs.open_shards.size() << " shards of " << jobs.shards << ", about "
            << DurationText(jobs.shard_seconds) << " each, as job " << array_job
            << "; the merge is job " << merge_job << "\n";
  return kGood;
}

int RunHere(const SweepManifest& manifest) {
  const SweepRunCounts counts = RunSweepTasks(manifest, TasksOfShard(manifest.size(), 0, 1), 0);
  std::cout << counts.done << " tasks done, " << counts.skipped << " were done before, "
            << counts.failed << " failed\n";
  return MergeSweep(manifest.file(), kUsualSweepFigure, false, false);
}

}  // namespace

int RunSweepSubmit(CommandLine& line) {
  SubmitFlags flags;
  line.Add("Flags", flags);
  if (ShowHelp(line, kHelp)) return kGood;
  line.Read();
  RequireGiven(flags.manifest, "manifest");
  RequireValid(flags);
  const SweepManifest manifest(flags.manifest);
  if (flags.engine == "local" && !flags.dry_run) return RunHere(manifest);
  if (flags.engine == "local") {
    std::cout << "brachium sweep run --manifest=" << ShellQuoted(flags.manifest)
              << " && brachium sweep merge --manifest=" << ShellQuoted(flags.manifest) << "\n";
    return kGood;
  }
  const SweepJobs jobs = JobsFor(manifest, flags);
  if (jobs.open_shards.empty()) {
    std::cout << "Nothing is left to run; see brachium sweep merge\n";
    return kGood;
  }
  if (!flags.dry_run) return SubmitToSlurm(jobs);
  std::cout << ArrayScript(jobs) << "\n" << MergeScript(jobs);
  return kGood;
}

}  // namespace brachium
