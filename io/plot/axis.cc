#include "io/plot/axis.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/text.h"

namespace brachium {
namespace {

constexpr double kMargin = 0.04;       // of the span, beyond the outermost values
constexpr double kOnTick = 1e-9;       // of the span
constexpr double kCategoryEdge = 0.6;  // beyond the outermost category

Range Extent(const Axis& axis, const std::vector<double>& values) {
  Range range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const double value : values) {
    if (!Shown(axis, value)) continue;
    range.low = std::min(range.low, value);
    range.high = std::max(range.high, value);
  }
  return range.low <= range.high ? range : axis.logarithmic ? Range{0.1, 10.0} : Range{0.0, 1.0};
}

Range Widened(Range range, double margin) {
  const double span = range.high - range.low;
  const double pad = span > 0.0 ? margin * span : 0.5 * std::max(1.0, std::abs(range.low));
  return {range.low - pad, range.high + pad};
}

// 1, 2 or 5 times a power of ten, the span divided by at most `wanted`.
double NiceStep(double span, int wanted) {
  const double least = span / std::max(1, wanted);
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= least * (1.0 - kOnTick)) return factor * power;
  return 10.0 * power;
}

std::vector<Tick> LinearTicks(const Range& range, int wanted) {
  const double span = range.high - range.low, step = NiceStep(span, wanted);
  const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + kOnTick)));
  std::vector<Tick> ticks;
  const double first = std::ceil(range.low / step - kOnTick * span / step);
  for (double i = first; i * step <= range.high + kOnTick * span; i += 1.0) {
    const double value = i * step;
    ticks.push_back({value, Fixed(i == 0.0 ? 0.0 : value, decimals)});
  }
  return ticks;
}

void AddDecade(double power, const Range& range, bool labelled_between, std::vector<Tick>* ticks) {
  for (int factor = 1; factor < 10; ++factor) {
    const double value = factor * power;
    if (value < range.low * (1.0 - kOnTick) || value > range.high * (1.0 + kOnTick)) continue;
    const bool labelled = factor == 1 || (labelled_between && (factor == 2 || factor == 5));
    ticks->push_back({value, labelled ? (value < 1.0 ? Shortest(value) : Fixed(value, 0)) : ""});
  }
}

std::vector<Tick> LogarithmicTicks(const Range& range, int wanted) {
  const double low = std::log10(range.low), high = std::log10(range.high);
  if (high - low < 0.7) return LinearTicks(range, wanted);
  std::vector<Tick> ticks;
  for (double exponent = std::floor(low); exponent <= high; exponent += 1.0)
    AddDecade(std::pow(10.0, exponent), range, 2.0 * (high - low) < wanted, &ticks);
  return ticks;
}

}  // namespace

bool Shown(const Axis& axis, double value) {
  return std::isfinite(value) && (!axis.logarithmic || value > 0.0);
}

Range RangeOf(const Axis& axis, const std::vector<double>& values) {
  if (axis.limits) return *axis.limits;
  if (!axis.categories.empty())
    return {-kCategoryEdge, static_cast<double>(axis.categories.size()) - 1.0 + kCategoryEdge};
  Range range = Extent(axis, values);
  if (axis.logarithmic) {
    range = Widened({std::log10(range.low), std::log10(range.high)}, kMargin);
    return {std::pow(10.0, range.low), std::pow(10.0, range.high)};
  }
  if (!axis.from_zero) return Widened(range, kMargin);
  const bool above = range.low >= 0.0, below = range.high <= 0.0;
  range = Widened({std::min(0.0, range.low), std::max(0.0, range.high)}, kMargin);
  if (above) range.low = 0.0;
  if (below && !above) range.high = 0.0;
  return range;
}

std::vector<Tick> TicksOf(const Axis& axis, const Range& range, int wanted) {
  if (axis.categories.empty())
    return axis.logarithmic ? LogarithmicTicks(range, wanted) : LinearTicks(range, wanted);
  std::vector<Tick> ticks;
  for (std::size_t i = 0; i < axis.categories.size(); ++i)
    ticks.push_back({static_cast<double>(i), axis.categories[i]});
  return ticks;
}

double Fraction(const Axis& axis, const Range& range, double value) {
  if (!axis.logarithmic) return (value - range.low) / (range.high - range.low);
  return std::log(value / range.low) / std::log(range.high / range.low);
}

}  // namespace brachium
