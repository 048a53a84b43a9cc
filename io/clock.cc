#include "io/clock.h"

#include <algorithm>
#include <cmath>

#include "io/input_error.h"
#include "io/text.h"
#include "problems/sampling.h"

namespace brachium {
namespace {

constexpr double kLongestStep = 0.5;    // [s]: no movement can be followed below 2 Hz
constexpr double kShortestStep = 1e-5;  // [s]
constexpr double kLongGap = 60.0;       // [s]
constexpr double kLeap = 10.0;          // times the step that the next row makes of it
constexpr double kMostLost = 1e15;

std::string Count(std::size_t n, const std::string& what) {
  return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
}

void CountGap(double length, Steps& steps) {
  if (!(length > kGapFactor * steps.median)) return;
  ++steps.gaps;
  steps.lost +=
      static_cast<std::size_t>(std::min(std::round(length / steps.median) - 1.0, kMostLost));
}

}  // namespace

LaterTimes::Use LaterTimes::Judge(double time, std::size_t line) {
  if (time > last_) {
    before_ = last_;
    last_ = time;
    ++used_;
    return Use::kNext;
  }
  if (not_later_++ == 0) first_not_later_ = line;
  const bool last_leapt =
      used_ >= 2 && time > before_ && last_ - before_ > kLeap * (time - before_);
  if (!last_leapt) return Use::kNot;
  last_ = time;
  return Use::kInsteadOfLast;
}

void LaterTimes::Check(std::size_t rows, const std::string& file) const {
  if (2 * not_later_ > rows)
    throw InputError(file, first_not_later_,
                     "time_s repeats itself or runs back here and in most of the rows; expected "
                     "an increasing time");
  if (used_ < 2)
    throw InputError(
        file, 0,
        "has " + Count(used_, "usable sample") + "; expected two or more rows of finite numbers");
}

UsableRows FindUsableRows(const CsvTable& table,
                          const std::function<bool(std::size_t)>& is_finite) {
  const std::vector<double>& time = table.Column("time_s");
  UsableRows usable;
  usable.rows.reserve(table.rows);
  LaterTimes times;
  for (std::size_t row = 0; row < table.rows; ++row) {
    if (!std::isfinite(time[row]) || !is_finite(row)) {
      ++usable.not_finite;
      continue;
    }
    const LaterTimes::Use use = times.Judge(time[row], table.Line(row));
    if (use == LaterTimes::Use::kNext) usable.rows.push_back(row);
    if (use == LaterTimes::Use::kInsteadOfLast) usable.rows.back() = row;
  }
  times.Check(table.rows, table.file);
  usable.not_later = times.not_later();
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
  for (const double length : lengths) CountGap(length, steps);
  return steps;
}

void RunningSteps::Add(double time) {
  if (steps_.median > 0.0) {
    const double length = time - last_;
    if (length > steps_.longest) {
      steps_.longest = length;
      steps_.longest_at = last_;
    }
    CountGap(length, steps_);
  } else {
    first_.push_back(time);
    if (first_.size() > kJudged) {
      steps_ = MeasureSteps(first_);
      first_ = {};
    }
  }
  last_ = time;
}

Steps RunningSteps::Measured() const { return steps_.median > 0.0 ? steps_ : MeasureSteps(first_); }

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
