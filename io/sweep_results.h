// What became of the tasks of a sweep, beside its manifest:
//
// results/000/000123.json   of a task: task, key, outcome ("done", "refused", "failed",
//                           "unreadable"), trusted, reason, figures. The same bytes whoever made it.
// timing/HOST-PID.jsonl     of the program that ran it, a line a task: task, method, seconds, memory_mb
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/sweep_manifest.h"
#include "problems/comparison.h"

namespace brachium {

struct SweepResult {
  using Outcome = ComparedPair::Outcome;
  Outcome outcome = Outcome::kDone;
  bool trusted = true;
  std::string reason{};  // why it failed, was refused, is not trusted
  std::vector<std::pair<std::string, double>> figures{};  // by path in evaluation.json; finite

  // Done, or refused for good. What failed or could not be read is tried again.
  bool IsFinal() const { return outcome == Outcome::kDone || outcome == Outcome::kRefused; }

  const double* Find(const std::string& figure) const;
};

std::string SweepResultFile(const std::string& folder, std::size_t task);

// Whole or not at all. Throws OutputError.
void WriteSweepResult(const std::string& folder, const SweepTask& task, const SweepResult& result);

// None when there is none, it is not whole, or it is of another key.
std::optional<SweepResult> ReadSweepResult(const std::string& folder, const SweepTask& task);

// Every figure `...rmse_deg` and `...rmse_m` of an evaluation that can be gone by, and the figures to
// judge by of the pair's whole angle; as evaluation.json names them.
std::vector<std::pair<std::string, double>> FiguresOf(const Evaluation& evaluation);

struct TaskTiming {
  std::size_t task = 0;
  std::string method{};
  double seconds = 0.0;
  double memory_mb = 0.0;  // the most that the program had held until then
};

// Adds a line to the program's own file; a line lost with the program does no harm.
void AppendTiming(const std::string& folder, const std::string& host, const TaskTiming& timing);

// Calls `visit` for each line of each file, in the order of the files' names.
void ForEachTiming(const std::string& folder, const std::function<void(const TaskTiming&)>& visit);

}  // namespace brachium
