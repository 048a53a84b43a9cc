#include "problems/clock_offset.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "problems/sampling.h"
#include "problems/statistics.h"

namespace brachium {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;

constexpr double kRange = 0.2;        // [s] either way
constexpr double kCoarseStep = 0.01;  // [s]
constexpr double kFineStep = 0.002;   // [s]
constexpr double kHalfWindow = 0.05;  // [s]
constexpr double kLeastCorrelation = 0.5;

// Turned or gone between two samples; NaN where one is missing.
double Motion(const Quaterniond& from, const Quaterniond& to) {
  const Quaterniond step = from.conjugate() * to;
  return 2.0 * std::atan2(step.vec().norm(), std::abs(step.w()));
}

double Motion(const Vector3d& from, const Vector3d& to) { return (to - from).head<2>().norm(); }

struct Speed {
  SampleTimes times;  // the middles of the windows
  std::vector<double> value;
};

enum class Windows {
  kAll,      // one that ends at each sample
  kHalfway,  // each begins in the middle of the one before
};

template <typename Value>
Speed SpeedOf(const SampleTimes& times, const std::vector<Value>& series, Windows windows) {
  const auto half = static_cast<std::size_t>(std::max(1.0, std::round(kHalfWindow / times.step())));
  const std::size_t every = windows == Windows::kAll ? 1 : half;
  std::vector<double> middle, speed;
  std::size_t run = 0;  // steps without a gap up to sample i
  for (std::size_t i = 1; i < times.size(); ++i) {
    const bool gap = times.GapAfter(i - 1) || std::isnan(Motion(series[i - 1], series[i]));
    run = gap ? 0 : run + 1;
    if (i < 2 * half || i % every != 0) continue;
    const double start = times.time()[i - 2 * half], end = times.time()[i];
    middle.push_back(0.5 * (start + end));
    speed.push_back(run < 2 * half ? Statistics::kUnknown
                                   : Motion(series[i - 2 * half], series[i]) / (end - start));
  }
  return {SampleTimes(std::move(middle)), std::move(speed)};
}

struct SpeedPair {
  Speed estimate, reference;
};

template <typename Key, typename Value>
std::vector<SpeedPair> SpeedsOfBoth(const SampleTimes& estimate_times,
                                    const std::map<Key, std::vector<Value>>& estimate,
                                    const SampleTimes& reference_times,
                                    const std::map<Key, std::vector<Value>>& reference,
                                    Windows reference_windows) {
  std::vector<SpeedPair> pairs;
  for (const auto& [key, series] : reference)
    if (const auto found = estimate.find(key); found != estimate.end())
      pairs.push_back({SpeedOf(estimate_times, found->second, Windows::kAll),
                       SpeedOf(reference_times, series, reference_windows)});
  return pairs;
}

std::vector<SpeedPair> SpeedsOf(const Estimate& estimate, const Reference& reference,
                                Windows reference_windows) {
  const SampleTimes estimate_times(estimate.time), reference_times(reference.time);
  std::vector<SpeedPair> pairs = SpeedsOfBoth(estimate_times, estimate.q_WB, reference_times,
                                              reference.q_VB, reference_windows);
  if (pairs.empty())
    pairs = SpeedsOfBoth(estimate_times, estimate.p_W, reference_times, reference.p_V,
                         reference_windows);
  return pairs;
}

// Of all pairs together; -1 where nothing can be compared.
double CorrelationAt(const std::vector<SpeedPair>& pairs, double offset) {
  std::vector<double> estimate, reference;
  for (const SpeedPair& pair : pairs) {
    std::vector<double> at = pair.reference.times.time();
    for (double& t : at) t -= offset;
    const std::vector<double> speed = Interpolate(pair.estimate.times, pair.estimate.value, at);
    estimate.insert(estimate.end(), speed.begin(), speed.end());
    reference.insert(reference.end(), pair.reference.value.begin(), pair.reference.value.end());
  }
  const auto n = static_cast<Eigen::Index>(estimate.size());
  return Correlation(Eigen::Map<const Eigen::RowVectorXd>(estimate.data(), n),
                     Eigen::Map<const Eigen::RowVectorXd>(reference.data(), n))
      .value_or(-1.0);
}

struct Peak {
  double offset = 0.0, correlation = -1.0;
  bool inside = false;  // neither end of the range is the best
};

// The best of offsets centre ± range, the top of a parabola through it and its neighbours.
Peak BestWithin(const std::vector<SpeedPair>& pairs, double centre, double range, double step) {
  const int reach = static_cast<int>(std::lround(range / step));
  std::vector<double> correlation;
  for (int i = -reach; i <= reach; ++i)
    correlation.push_back(CorrelationAt(pairs, centre + i * step));
  const auto best = std::max_element(correlation.begin(), correlation.end());
  Peak peak{.offset = centre + step * static_cast<double>(best - correlation.begin() - reach),
            .correlation = *best};
  peak.inside = best != correlation.begin() && best + 1 != correlation.end();
  if (!peak.inside) return peak;
  const double bend = best[-1] - 2.0 * best[0] + best[1];
  if (bend < 0.0) peak.offset += 0.5 * step * (best[-1] - best[1]) / bend;
  return peak;
}

}  // namespace

ClockOffset ClockOffsetOf(const Estimate& estimate, const Reference& reference) {
  using Source = ClockOffset::Source;
  if (reference.clock_offset)
    return {.seconds = *reference.clock_offset, .source = Source::kGiven, .correlation = {}};
  if (estimate.time.size() < 2 || reference.time.size() < 2) return {};
  const Peak coarse =
      BestWithin(SpeedsOf(estimate, reference, Windows::kHalfway), 0.0, kRange, kCoarseStep);
  if (!coarse.inside || coarse.correlation < kLeastCorrelation) return {};
  const Peak fine = BestWithin(SpeedsOf(estimate, reference, Windows::kAll), coarse.offset,
                               kCoarseStep, kFineStep);
  return {.seconds = fine.offset, .source = Source::kEstimated, .correlation = fine.correlation};
}

}  // namespace brachium
