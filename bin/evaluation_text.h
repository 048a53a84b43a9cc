// What the terminal shows of an evaluation.
#pragma once

#include <string>

#include "problems/evaluation.h"

namespace brachium {

// Tables of the errors in deg and mm, by segment, by pair of segments, by joint angle, by point.
std::string EvaluationText(const Evaluation& evaluation);

}  // namespace brachium
