#include "io/clock.h"

#include <algorithm>
#include <cmath>

#include "io/input_error.h"
#include "io/text.h"

namespace brachium {
namespace {

constexpr double kGapFactor = 1.8;
constexpr double kLongestStep = 0.5;    // [s]: no movement can be followed below 2 Hz
constexpr double kShortestStep = 1e-5;  // [s]
constexpr double kLongGap = 60.0;       // [s]
constexpr double kLeap = 10.0;          // times the step that the next row makes of it
constexpr double kMostLost = 1e15;

std::string Count(std::size_t n, const std::string& what) {
  return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
}

}  // namespace

UsableRows FindUsableRows(const CsvTable& table,
                          const std::function<bool(std::size_t)>& is_finite) {
  const std::vector<double>& time = table.Column("time_s");
  UsableRows usable;
  std::vector<std::size_t>& rows = usable.rows;
  rows.reserve(table.rows);
  std::size_t first_not_later = 0;
  for (std::size_t row = 0; row < table.rows; ++row) {
    if (!std::isfinite(time[row]) || !is_finite(row)) {
      ++usable.not_finite;
      continue;
    }
    const double last = rows.empty() ? -HUGE_VAL : time[rows.back()];
    if (time[row] > last) {
      rows.push_back(row);
      continue;
    }
    if (usable.not_later++ == 0) first_not_later = row;
    if (rows.size() < 2) continue;
    const double before = time[rows[rows.size() - 2]];
    const bool last_leapt = time[row] > before && last - before > kLeap * (time[row] - before);
    if (last_leapt) rows.back() = row;
  }
  if (2 * usable.not_later > table.rows)
    throw InputError(table.file, table.Line(first_not_later),
                     "time_s repeats itself or runs back here and in most of the rows; expected "
                     "an increasing time");
  if (rows.size() < 2)
    throw InputError(table.file, 0,
                     "has " + Count(rows.size(), "usable sample") +
                         "; expected two or more rows of finite numbers");
  return usable;
}

Steps MeasureSteps(const std::vector<double>& time) {
  std::vector<double> lengths(time.size() - 1);
  for (std::size_t i = 0; i + 1 < time.size(); ++i) lengths[i] = time[i + 1] - time[i];
  Steps steps;
  const auto longest = std::ranges::max_element(lengths);
  steps.longest = *longest;
  steps.longest_at = time[static_cast<std::size_t>(longest - lengths.begin())];
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::ranges::nth_element(lengths, middle);
  steps.median = *middle;
  for (const double length : lengths) {
    if (!(length > kGapFactor * steps.median)) continue;
    ++steps.gaps;
    steps.lost +=
        static_cast<std::size_t>(std::min(std::round(length / steps.median) - 1.0, kMostLost));
  }
  return steps;
}

void CheckStepUnit(const Steps& steps, const std::string& file) {
  if (steps.median >= kShortestStep && steps.median <= kLongestStep) return;
  const char* const hint = steps.median > kLongestStep
                               ? " (this looks like milliseconds or microseconds)"
                               : " (this looks like minutes, hours or days)";
  throw InputError(file, 0,
                   "time_s has a median step of " + Shortest(steps.median) +
                       "; expected seconds, at 2 Hz to 100 kHz" + hint);
}

void ReportRows(const CsvTable& table, const UsableRows& usable, const Steps& steps,
                const std::string& name, Findings* findings) {
  if (table.cut_off)
    findings->repairs.push_back(name + ":" + std::to_string(table.Line(table.rows)) +
                                ": the last row is cut off and was left out");
  if (usable.not_finite > 0)
    findings->repairs.push_back(name + ": " + Count(usable.not_finite, "row") +
                                " with NaN or infinite numbers left out");
  if (usable.not_later > 0)
    findings->repairs.push_back(name + ": " + Count(usable.not_later, "row") +
                                " left out where time_s repeats itself or runs back");
  if (steps.gaps > 0)
    findings->repairs.push_back(name + ": " + Count(steps.gaps, "gap") + " bridged, " +
                                Count(steps.lost, "sample") + " lost, the longest step " +
                                Fixed(steps.longest, 3) + " s");
  if (steps.longest > kLongGap)
    findings->warnings.push_back(name + ": time_s leaps by " + Fixed(steps.longest, 1) +
                                 " s after " + Shortest(steps.longest_at) +
                                 " s; is it one recording, on one clock?");
}

}  // namespace brachium
