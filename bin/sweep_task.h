// One task of a sweep, from its line in the manifest to its result.
#pragma once

#include "io/sweep_manifest.h"
#include "io/sweep_results.h"
#include "solver/estimators.h"

namespace brachium {

// The method with the options that the manifest holds. Throws InputError where they are not all
// there, or there is no such method.
MethodOptions OptionsOf(const SweepTask& task, const std::string& manifest);

// Estimates and judges; nothing is thrown, the result says what went wrong. Besides the figures of
// FiguresOf() it holds adduction.rms_deg, the rms of the estimate's elbow_carrying (about zero),
// and adduction.sd_deg (about its mean), where there is an elbow.
SweepResult RunSweepTask(const MethodOptions& options, const TrialFolder& folder);

}  // namespace brachium
