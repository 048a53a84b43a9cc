// From the plan of an experiment to its folder.
#pragma once

#include <string>
#include <vector>

#include "bin/experiments/experiment.h"
#include "io/run_info.h"

namespace brachium {

struct ExperimentTask {
  std::string folder;  // to be written
  bool quick = false;
  int threads = 0;
  bool overwrite = false;
  std::string command_line;
  std::vector<NameValue> flags;  // that repeat it
};

// Simulates into trials/, estimates into estimates/TRIAL/NAME what is not there already, writes
// comparison.csv, comparison.json, comparison.md and the figures, and prints the report, in which a
// result that is not to be trusted is named. Exit code 3, without a report, when a method failed.
int RunExperiment(const Experiment& experiment, const ExperimentTask& task);

}  // namespace brachium
