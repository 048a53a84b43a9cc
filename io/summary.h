// What an estimate folder says in JSON: summary.json and timing.json.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "io/run_info.h"
#include "problems/estimate.h"

namespace brachium {

// Everything about the run that is the same for the same input. Numbers that are not finite are
// null. Schema 1: see io/README.md.
nlohmann::ordered_json SummaryOf(const Estimate& estimate, const RunInfo& run);

// Whether a summary tells of a run that would say the same again: the same method, options, versions
// and inputs.
bool TellsOfTheSame(const nlohmann::ordered_json& summary, const std::string& method,
                    const RunInfo& run);

// What may differ between two runs of the same thing.
nlohmann::ordered_json TimingOf(const Estimate& estimate, const RunInfo& run);

}  // namespace brachium
