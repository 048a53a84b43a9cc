// The pictures of a sweep.
#pragma once

#include <map>
#include <string>

#include "problems/sweep_table.h"

namespace brachium {

// File name -> SVG:
//   sweep_lines.svg               method by method beside each other, on the same scales: the rms of
//                                 the elbow's adduction and the error over the method's first varied
//                                 number, a thin line per trial, median and quartiles; the other
//                                 options as in the best point. After Luinge et al. 2007, fig. 6.
//   sweep_map_METHOD_A_B.svg      the median error over two varied numbers, the others as in the
//                                 best point
std::map<std::string, std::string> SweepFigures(const SweepTable& table);

}  // namespace brachium
