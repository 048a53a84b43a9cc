// Optional members of a JSON object: the value, or a default that is reported.
#pragma once

#include <string>

#include "io/findings.h"
#include "io/json_input.h"

namespace brachium {

// Notes "path.key = value unit".
void NoteDefault(const JsonNode& node, const std::string& key, const std::string& value,
                 Findings* findings);

double NumberOr(const JsonNode& node, const std::string& key, double absent,
                const std::string& unit, Findings* findings);
double PositiveNumberOr(const JsonNode& node, const std::string& key, double absent,
                        const std::string& unit, Findings* findings);

}  // namespace brachium
