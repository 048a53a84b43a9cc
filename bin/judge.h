// The meeting of an estimate and the reference of its trial.
#pragma once

#include <string>

#include "io/trial_folder.h"
#include "problems/evaluation.h"

namespace brachium {

// The reference of the trial in `path`. Throws InputError when it has none.
const Reference& RequireReference(const TrialFolder& folder, const std::string& path);

// Evaluate(), but throws InputError where the two have nothing in common.
Evaluation Judge(const Estimate& estimate, const Reference& reference, const std::string& path);

}  // namespace brachium
