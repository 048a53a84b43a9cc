// What held the headings of a trial, as a picture.
#pragma once

#include <string>
#include <vector>

#include "problems/estimate.h"

namespace brachium {

// For each joint a chart over time: the heading's standard deviation, and dashed what each relation
// alone would hold it to by what happens in a span [deg, logarithmic].
std::string HeadingsFigure(const std::vector<HeadingSupport>& headings);

}  // namespace brachium
