// One method on one trial, from files to an evaluation.
#pragma once

#include <string>
#include <vector>

#include "bin/lists.h"
#include "problems/comparison.h"
#include "solver/estimators.h"

namespace brachium {

struct PairTask {
  NamedFolder trial;
  std::string method;
  MethodOptions options;
  std::string estimate;  // the estimate folder
  bool overwrite = false;
  std::string command_line;
};

// Reads the trial, runs the method unless its estimate is there already, and judges what it wrote.
// What goes wrong with the trial or the method is said in the answer; only OutputError is thrown.
ComparedPair RunPair(const PairTask& task);

// All of them, several at a time (0 threads: as many as the machine has), with a progress line; in
// their order.
std::vector<ComparedPair> RunPairs(const std::vector<PairTask>& tasks, int threads);

}  // namespace brachium
