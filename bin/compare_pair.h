// One method on one trial, from files to an evaluation.
#pragma once

#include <string>

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

}  // namespace brachium
