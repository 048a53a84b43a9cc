// The names that the tables and the figures of zhou2008 share.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "bin/experiments/experiment.h"

namespace brachium {

// The rows of every table: as printed, without the high-pass, and the smoother.
inline const std::vector<std::string> kZhouMethods = {"zhou", "zhou_no_highpass", "smoother"};

// The trials that a figure needs are there in both versions, the quick one too.
std::map<std::string, std::string> ZhouFigures(const ExperimentResults& results, bool quick);

}  // namespace brachium
