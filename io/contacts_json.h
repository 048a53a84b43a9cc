// Places that were touched: `contacts` of trial.json.
#pragma once

#include <set>
#include <vector>

#include "io/findings.h"
#include "io/json_input.h"
#include "problems/observations.h"

namespace brachium {

// Each touches with a point of a recorded segment, at times within `covered`, a place of its own
// name. Throws InputError for others, and where a recording is alone: the arm is then not known.
std::vector<Contact> ParseContacts(const JsonNode& trial, const std::set<Segment>& recorded,
                                   const Interval& covered, Findings* findings);

}  // namespace brachium
