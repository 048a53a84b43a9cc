// The meeting of an estimate and the reference of its trial.
#pragma once

#include <string>

#include "io/run_info.h"
#include "io/trial_folder.h"
#include "problems/evaluation.h"

namespace brachium {

// The reference of the trial in `path`. Throws InputError when it has none.
const Reference& RequireReference(const TrialFolder& folder, const std::string& path);

// Throws InputError where `run`, of the estimate in a folder, names other recordings than those of the
// trial in `path`; its trial.json and its reference may have changed since.
void RequireMadeFrom(const RunInfo& run, const std::string& estimate, const TrialFolder& folder,
                     const std::string& path);

// Evaluate(), but throws InputError where the two have nothing in common.
Evaluation Judge(const Estimate& estimate, const Reference& reference, const std::string& path);

}  // namespace brachium
