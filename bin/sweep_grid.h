// Which parameter points a sweep has: --vary="NAME=1:30:15:log;NAME=0.01,0.03,0.1".
#pragma once

#include <string>
#include <vector>

#include "bin/flags.h"
#include "solver/estimators.h"

namespace brachium {

struct VariedOption {
  std::string name;
  std::vector<FlagValue> values;  // each once, all of the option's type
};

// Parts between semicolons: an option of any of the methods, and its values: a list with commas, or
// from:to:count:spacing with spacing `lin` or `log`, its points rounded to six digits, its ends kept.
// Throws UsageError for a name that no method has, naming the nearest, for one given twice, and for
// values that are not what the option takes.
std::vector<VariedOption> ParseVary(const std::string& vary,
                                    const std::vector<MethodOptions>& methods);

// A method's options at one point, and which of the varied ones it has, with their values.
struct SweepPoint {
  MethodOptions options;
  std::vector<std::pair<std::string, FlagValue>> varied;
};

// Every combination of the varied options that the method has, the last one running fastest; without
// any, the method as it is. Throws UsageError for options that contradict themselves, and for more
// than ten million points.
std::vector<SweepPoint> PointsOf(const MethodOptions& method,
                                 const std::vector<VariedOption>& varied);

}  // namespace brachium
