// The `arm` of trial.json: side, segments, elbow, shoulder.
#pragma once

#include <set>

#include "io/findings.h"
#include "io/json_input.h"
#include "problems/arm_model.h"

namespace brachium {

// The segment that a text names. Throws InputError with the known names.
Segment ParseSegment(const JsonNode& name);
Segment ParseSegment(const JsonNode& node, const std::string& name);

Side ParseSide(const JsonNode& name);  // "right" or "left"

// Every recorded segment has a geometry afterwards. Defaults that no method can see (a length where
// one sensor is alone, an elbow without two sensors beside it) are taken without a report.
ArmModel ParseArm(const JsonNode& arm, const std::set<Segment>& recorded, Findings* findings);

}  // namespace brachium
