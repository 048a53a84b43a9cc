// Running some of a sweep's tasks in this process.
#pragma once

#include <cstddef>
#include <vector>

#include "io/sweep_manifest.h"

namespace brachium {

struct SweepRunCounts {
  std::size_t done = 0;     // now
  std::size_t skipped = 0;  // had a valid result
  std::size_t failed = 0;   // left a record that says why
};

// Runs those of the tasks that have no valid result, several at a time, one thread each; jobs 0: as
// many as the machine has cores. Throws InputError when another version of the program made the plan.
SweepRunCounts RunSweepTasks(const SweepManifest& manifest, const std::vector<std::size_t>& tasks,
                             int jobs);

// The tasks of shard k of n: a contiguous part, so that few shards read the same trial.
std::vector<std::size_t> TasksOfShard(std::size_t tasks, std::size_t shard, std::size_t shards);

}  // namespace brachium
