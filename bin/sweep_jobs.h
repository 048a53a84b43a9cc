// A sweep as batch jobs.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "io/sweep_manifest.h"

namespace brachium {

// What the cluster is told. Seconds and memory are of one task, as measured.
struct SweepJobs {
  std::string program, manifest;       // absolute
  std::string account{}, partition{};  // empty: the cluster's own
  std::size_t shards = 1;
  std::vector<std::size_t> open_shards{};  // those with tasks left
  int at_a_time = 0;                       // 0: as many as the cluster allows
  double shard_seconds = 0.0;              // that a shard is expected to take
  double memory_mb = 0.0;
};

// How many shards of about so many minutes each the tasks make: at least one, and at most as many as
// Slurm takes in an array without being told otherwise, 1000.
std::size_t ShardsFor(std::size_t tasks, double task_seconds, double minutes);

// Scripts for sbatch: an array with a job for each open shard, and the merge. Time is asked for
// threefold and ten minutes, memory one and a half times and 200 MB. SIGTERM comes 30 s before the
// end; what a job did not finish is found missing.
std::string ArrayScript(const SweepJobs& jobs);
std::string MergeScript(const SweepJobs& jobs);

// `text` as one word of a shell.
std::string ShellQuoted(const std::string& text);

}  // namespace brachium
