// The folder that puts methods side by side.
//
// comparison.csv   a row per trial and method: trial, method, outcome ("done", "refused", "failed",
//                  "unreadable"), trusted (1, 0), reason, then every figure of evaluation.json by its
//                  path there ("relative.forearm_in_upper_arm.rmse_deg"), but not its blocks `raw`,
//                  `aligned` and `removed`; empty where unknown. Text in quotes where it has commas.
// comparison.json  version 1: trials, methods with their options, versions, and pairs with outcome,
//                  trusted, reason and the whole evaluation.json of each
// comparison.md    the tables of the terminal in markdown
// errors.svg, error_over_time_TRIAL.svg, position_error_over_time_TRIAL.svg
// timing.json      seconds of each pair, host, command line: may differ between equal runs
// run.flags        all options but the output
// estimates/TRIAL/METHOD/  estimate folders
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/run_info.h"
#include "problems/comparison.h"

namespace brachium {

// What a comparison says besides its figures.
struct ComparisonInfo {
  nlohmann::ordered_json options;  // by method: name -> value
  std::vector<NameValue> flags;    // of the program, for run.flags
  std::vector<NameValue> versions;
  std::string markdown{};
  std::string host{}, command_line{};
};

std::string ComparisonCsv(const Comparison& comparison);
std::string ComparisonJson(const Comparison& comparison, const ComparisonInfo& info);

// Throws OutputExists when the folder holds something else than a comparison, or one by other flags
// that may not be overwritten: for a check before long work.
void CheckComparable(const std::string& folder, const std::vector<NameValue>& flags,
                     bool overwrite);

// All files but the estimates, `figures` by file name among them; each reaches its place in one step, and the same bytes again are no
// overwrite. Throws OutputExists and OutputError.
void WriteComparison(const std::string& folder, const Comparison& comparison,
                     const ComparisonInfo& info, const std::map<std::string, std::string>& figures,
                     bool overwrite);

}  // namespace brachium
