#include "problems/cycles.h"

#include <algorithm>
#include <cmath>

namespace brachium {
namespace {

constexpr double kHysteresis = 0.25;  // of the standard deviation

struct Part {
  Eigen::Index first = 0, count = 0;
};

Part PartIn(const std::vector<double>& time, const Interval& cycle) {
  const auto first = std::lower_bound(time.begin(), time.end(), cycle.start);
  const auto end = std::lower_bound(first, time.end(), cycle.end);
  return {first - time.begin(), end - first};
}

CycleErrors ErrorsOf(const Interval& cycle, const Series& estimate, const Series& reference) {
  CycleErrors errors{.cycle = cycle, .whole = StatisticsOf(estimate - reference), .axis = {}};
  errors.whole.correlation = Correlation(estimate, reference);
  for (Eigen::Index row = 0; row < estimate.rows(); ++row) {
    errors.axis.push_back(StatisticsOf(estimate.row(row) - reference.row(row)));
    errors.axis.back().correlation = Correlation(estimate.row(row), reference.row(row));
  }
  return errors;
}

double Mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return values.empty() ? Statistics::kUnknown : sum / static_cast<double>(values.size());
}

double MeanP(const std::vector<CycleErrors>& cycles, std::size_t components) {
  std::vector<double> p;
  for (std::size_t i = 0; i < components; ++i) {
    std::vector<double> biases;
    for (const CycleErrors& errors : cycles) biases.push_back(errors.axis[i].bias);
    p.push_back(WilcoxonSignedRank(biases).p);
  }
  return Mean(p);
}

}  // namespace

std::vector<Interval> FindCycles(const std::vector<double>& time,
                                 const std::vector<double>& signal) {
  const Statistics statistics = StatisticsOf(Eigen::Map<const Eigen::RowVectorXd>(
      signal.data(), static_cast<Eigen::Index>(signal.size())));
  const double far = kHysteresis * statistics.sd;
  std::vector<double> crossings;
  bool was_below = false;
  double crossing = Statistics::kUnknown;  // the last upward one since it was below
  double before = Statistics::kUnknown;
  for (std::size_t i = 0; i < signal.size(); ++i) {
    const double height = signal[i] - statistics.bias;
    if (std::isnan(height)) continue;
    if (height < -far) {
      was_below = true;
      crossing = Statistics::kUnknown;
    }
    if (was_below && before < 0.0 && height >= 0.0) crossing = time[i];
    if (was_below && !std::isnan(crossing) && height > far) {
      crossings.push_back(crossing);
      was_below = false;
    }
    before = height;
  }
  std::vector<Interval> cycles;
  for (std::size_t i = 1; i < crossings.size(); ++i)
    cycles.push_back({.label = "cycle", .start = crossings[i - 1], .end = crossings[i]});
  return cycles;
}

CycleAnalysis AnalyseCycles(const std::vector<double>& time, const Series& estimate,
                            const Series& reference, const std::vector<Interval>& cycles) {
  CycleAnalysis analysis;
  std::vector<double> bias, sd, rmse, whole, correlation;
  for (const Interval& cycle : cycles) {
    const Part part = PartIn(time, cycle);
    CycleErrors errors = ErrorsOf(cycle, estimate.middleCols(part.first, part.count),
                                  reference.middleCols(part.first, part.count));
    if (errors.whole.used < 2) continue;
    for (const Statistics& axis : errors.axis) {
      bias.push_back(axis.bias);
      sd.push_back(axis.sd);
      rmse.push_back(axis.rmse);
      if (axis.correlation) correlation.push_back(*axis.correlation);
    }
    whole.push_back(errors.whole.rmse);
    analysis.cycles.push_back(std::move(errors));
  }
  if (analysis.cycles.empty()) return analysis;
  analysis.mean_bias = Mean(bias);
  analysis.mean_sd = Mean(sd);
  analysis.mean_rmse = Mean(rmse);
  analysis.mean_rmse_whole = Mean(whole);
  if (!correlation.empty()) analysis.mean_correlation = Mean(correlation);
  analysis.p = MeanP(analysis.cycles, static_cast<std::size_t>(estimate.rows()));
  return analysis;
}

}  // namespace brachium
