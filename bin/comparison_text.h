// What the terminal and a page of markdown show of a comparison.
#pragma once

#include <string>

#include "problems/comparison.h"

namespace brachium {

// Trials down, methods across: rmse of the relative orientations by the figure to go by [deg], and
// of positions after one heading and shift [mm]; `-` where the method refused, `*` where the result
// is not to be trusted; below, why.
std::string ComparisonText(const Comparison& comparison);

// The same as markdown, the least of each row in bold.
std::string ComparisonMarkdown(const Comparison& comparison);

}  // namespace brachium
