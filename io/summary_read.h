// What summary.json says, read back.
#pragma once

#include "io/json_input.h"
#include "io/run_info.h"
#include "problems/estimate.h"

namespace brachium {

// All that a summary tells of the finding; numbers that are null there are NaN, of what holds a
// heading infinite. Throws InputError.
Diagnostics DiagnosticsFrom(const JsonNode& summary);

// The trial's name, findings, inputs and versions. Throws InputError.
RunInfo RunFrom(const JsonNode& summary);

}  // namespace brachium
