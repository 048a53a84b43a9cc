// Periodic movements, cycle by cycle. After the statistics of Zhou et al., Med. Eng. Phys. 30 (2008).
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "problems/agreement.h"
#include "problems/observations.h"
#include "problems/statistics.h"

namespace brachium {

// From one upward crossing of the mean to the next; a crossing counts only once the signal has been
// a quarter of its standard deviation below before and above after. NaNs are passed over.
std::vector<Interval> FindCycles(const std::vector<double>& time,
                                 const std::vector<double>& signal);

struct CycleErrors {
  Interval cycle;
  Statistics whole;              // of the vector error
  std::vector<Statistics> axis;  // of each component, with its correlation
};

// A column per instant, a row per component. Means over cycles and components; p of the signed-rank
// test over the cycles' mean errors, its mean over components.
struct CycleAnalysis {
  std::vector<CycleErrors> cycles;  // with two samples or more
  double mean_bias = Statistics::kUnknown;
  double mean_sd = Statistics::kUnknown;
  double mean_rmse = Statistics::kUnknown;
  double mean_rmse_whole = Statistics::kUnknown;  // of the vector error
  std::optional<double> mean_correlation;         // over those that have one
  std::optional<double> p;
};

CycleAnalysis AnalyseCycles(const std::vector<double>& time, const Series& estimate,
                            const Series& reference, const std::vector<Interval>& cycles);

}  // namespace brachium
