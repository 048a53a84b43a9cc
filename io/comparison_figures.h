// The pictures of a comparison.
#pragma once

#include <map>
#include <string>

#include "problems/comparison.h"

namespace brachium {

// SVG documents by file name:
//   errors.svg                         boxes of the errors by trial, the methods beside each other:
//                                      relative orientations, and positions where there are any
//   error_over_time_TRIAL.svg          the angle of the relative orientation's error
//   position_error_over_time_TRIAL.svg the distance of a point from its reference
// What a trial has none of has no picture.
std::map<std::string, std::string> ComparisonFigures(const Comparison& comparison);

}  // namespace brachium
