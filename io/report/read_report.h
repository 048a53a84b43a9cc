// Gathers what a report shows from result folders.
#pragma once

#include <string>
#include <vector>

#include "io/report/reported.h"

namespace brachium {

// `folders` are estimates, comparisons (with comparison.json) or merged sweeps (with sweep.json).
// References come from `trials`; where none are told, from the trial that an estimate's run.flags
// name, provided that it is there and unchanged. Throws InputError for a folder that is none of
// these, and for an estimate that was made from none of the trials told.
Report ReadReport(const std::vector<std::string>& folders, const std::vector<std::string>& trials);

}  // namespace brachium
