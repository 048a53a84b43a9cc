#include "bin/sweep_jobs.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "bin/sweep_text.h"

namespace brachium {
namespace {

constexpr std::size_t kMostShards = 1000;

std::string Minutes(double seconds) {
  return std::to_string(static_cast<long>(std::ceil(seconds / 60.0)));
}

std::string Directive(const std::string& name, const std::string& value) {
  return value.empty() ? "" : "#SBATCH --" + name + "=" + value + "\n";
}

std::string Head(const SweepJobs& jobs, const std::string& name, double seconds) {
  const auto memory = static_cast<long>(std::ceil(1.5 * jobs.memory_mb + 200.0));
  const std::string log =
      (std::filesystem::path(jobs.manifest).parent_path() / "slurm" / "%x-%j.log").string();
  return "#!/bin/sh\n" + Directive("job-name", name) + Directive("account", jobs.account) +
         Directive("partition", jobs.partition) + Directive("cpus-per-task", "1") +
         Directive("time", Minutes(seconds)) + Directive("mem", std::to_string(memory) + "M") +
         Directive("output", ShellQuoted(log)) + Directive("open-mode", "append");
}

}  // namespace

std::size_t ShardsFor(std::size_t tasks, double task_seconds, double minutes) {
  const double wanted = std::ceil(static_cast<double>(tasks) * task_seconds / (60.0 * minutes));
  return static_cast<std::size_t>(
      std::clamp(wanted, 1.0, static_cast<double>(std::min(tasks, kMostShards))));
}

std::string ShellQuoted(const std::string& text) {
  std::string quoted = "'";
  for (const char letter : text) quoted += letter == '\'' ? "'\\''" : std::string(1, letter);
  return quoted + "'";
}

std::string ArrayScript(const SweepJobs& jobs) {
  std::string array = ArraySpecification(jobs.open_shards);
  if (jobs.at_a_time > 0) array.append("%").append(std::to_string(jobs.at_a_time));
  return Head(jobs, "brachium_sweep", 3.0 * jobs.shard_seconds + 600.0) +
         Directive("array", array) + "#SBATCH --requeue\n" + Directive("signal", "B:TERM@30") +
         "exec " + ShellQuoted(jobs.program) +
         " sweep run --manifest=" + ShellQuoted(jobs.manifest) +
         " --shard=\"$SLURM_ARRAY_TASK_ID\"/" + std::to_string(jobs.shards) + "\n";
}

std::string MergeScript(const SweepJobs& jobs) {
  return Head(jobs, "brachium_merge", 3600.0) + "exec " + ShellQuoted(jobs.program) +
         " sweep merge --manifest=" + ShellQuoted(jobs.manifest) + "\n";
}

}  // namespace brachium
