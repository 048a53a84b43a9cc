// Axes: which values they span, where their ticks stand, and where a value lies along them.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace brachium {

struct Range {
  double low = 0.0, high = 1.0;
};

struct Axis {
  std::string label{};
  bool logarithmic = false;               // values that are not positive are left out
  bool from_zero = false;                 // a linear range takes 0 in
  std::optional<Range> limits{};          // absent: from what is drawn
  std::vector<std::string> categories{};  // names in place of ticks, at 0, 1, 2, ...
};

struct Tick {
  double value = 0.0;
  std::string label;  // may be empty
};

// Whether an axis of that kind has a place for the value.
bool Shown(const Axis& axis, double value);

// The range of an axis: its own, or that of the finite values, a little wider so that nothing lies
// on the frame, never of no width.
Range RangeOf(const Axis& axis, const std::vector<double>& values);

// Ticks within the range: multiples of 1, 2 or 5 times a power of ten, about `wanted` of them; on a
// logarithmic axis powers of ten, with 2 and 5 times those where that leaves few; categories at
// their places. Labels carry as many decimals as tell neighbours apart.
std::vector<Tick> TicksOf(const Axis& axis, const Range& range, int wanted);

// 0 at the low end of the range, 1 at the high one.
double Fraction(const Axis& axis, const Range& range, double value);

}  // namespace brachium
