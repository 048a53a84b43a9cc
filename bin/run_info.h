// What a result folder says of the run that made it.
#pragma once

#include <string>
#include <vector>

#include "io/run_info.h"
#include "io/trial_folder.h"
#include "solver/estimators.h"

namespace brachium {

// `flags` repeat the run by `brachium reconstruct`.
RunInfo RunInfoOf(const TrialFolder& folder, const MethodOptions& method,
                  std::vector<NameValue> flags, const std::string& command_line,
                  double reading_seconds);

}  // namespace brachium
