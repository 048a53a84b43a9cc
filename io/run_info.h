// How an estimate came about: what a result folder says besides the estimate.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "io/trial_folder.h"
#include "problems/estimate.h"

namespace brachium {

using NameValue = std::pair<std::string, std::string>;

struct RunInfo {
  std::string trial;               // its name
  nlohmann::ordered_json options;  // of the method: name -> value
  std::vector<NameValue> flags;    // of the program, for run.flags: name, value
  Findings findings;               // of reading the trial
  std::vector<RecordingFacts> recordings;
  std::vector<InputFile> inputs;
  std::vector<NameValue> versions;  // program and libraries: name, version
  std::vector<StageTime> stages;    // before and after the method's own
  std::string host;
  std::string command_line;
};

}  // namespace brachium
