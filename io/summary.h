// What an estimate folder says in JSON: summary.json and timing.json.
#pragma once

#include <nlohmann/json.hpp>

#include "io/run_info.h"
#include "problems/estimate.h"

namespace brachium {

// Everything about the run that is the same for the same input. Numbers that are not finite are
// null. Schema 1: see io/README.md.
nlohmann::ordered_json SummaryOf(const Estimate& estimate, const RunInfo& run);

// What may differ between two runs of the same thing.
nlohmann::ordered_json TimingOf(const Estimate& estimate, const RunInfo& run);

}  // namespace brachium
