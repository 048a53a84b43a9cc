// What the person was asked to do: `intervals`, `start_pose` and `end_pose` of trial.json.
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

// A pose by its label, by its angles, or by both (an angle given replaces the label's). It must lie
// within `covered`, the recordings' common time; told without a time it is at the start or the end.
std::optional<HeldPose> ParseStartPose(const JsonNode& trial, const Interval& covered,
                                       Findings* findings);
std::optional<HeldPose> ParseEndPose(const JsonNode& trial, const Interval& covered,
                                     Findings* findings);

// The time at `node`, moved into `covered` where it is off by rounding; further outside it is refused.
double TimeWithin(const Interval& covered, const JsonNode& node, double time);

}  // namespace brachium
