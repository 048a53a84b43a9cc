// What the person was asked to do: `intervals` and `start_pose` of trial.json.
#pragma once

#include <optional>
#include <vector>

#include "io/findings.h"
#include "io/json_input.h"
#include "problems/observations.h"

namespace brachium {

// The labelled intervals; a label that no method knows, and an interval outside of `covered`, is a
// warning.
// Gravity where the trial was recorded [m/s^2].
double ParseGravity(const JsonNode& trial, Findings* findings);

std::vector<Interval> ParseIntervals(const JsonNode& trial, const Interval& covered,
                                     Findings* findings);

// The pose by its label, by its angles, or by both (an angle given replaces the label's). It must
// lie within `covered`, the first recording's time.
std::optional<StartPose> ParseStartPose(const JsonNode& trial, const Interval& covered,
                                        Findings* findings);

}  // namespace brachium
