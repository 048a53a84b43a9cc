// The time column of a table: which rows can be used, and how regular they are.
#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "io/csv.h"
#include "io/findings.h"

namespace brachium {

// Judges times one after another: which are later than all before that are used. A single time that
// leaps ahead is left out instead of all that follow it.
class LaterTimes {
 public:
  enum class Use { kNot, kNext, kInsteadOfLast };

  // `line`: of its file.
  Use Judge(double time, std::size_t line);

  std::size_t used() const { return used_; }
  std::size_t not_later() const { return not_later_; }

  // Throws InputError when fewer than two times are used, or when time runs back in most of `rows`.
  void Check(std::size_t rows, const std::string& file) const;

 private:
  double last_ = -HUGE_VAL, before_ = -HUGE_VAL;
  std::size_t used_ = 0, not_later_ = 0, first_not_later_ = 0;
};

struct UsableRows {
  std::vector<std::size_t> rows;  // their times strictly increase
  std::size_t not_finite = 0;     // rows left out for a number that is not finite
  std::size_t not_later = 0;      // rows left out because time repeats itself or runs back
};

// The rows of `table` with a finite time_s that is later than the row before, and for which
// `is_finite` holds. A single time that leaps ahead is left out instead of all that follow it.
// Throws InputError when fewer than two rows remain, or when time runs back in most of them.
UsableRows FindUsableRows(const CsvTable& table, const std::function<bool(std::size_t)>& is_finite);

struct Steps {
  double median = 0.0;      // [s]
  std::size_t gaps = 0;     // steps longer than 1.8 times the median
  std::size_t lost = 0;     // samples that would have filled them
  double longest = 0.0;     // [s]
  double longest_at = 0.0;  // time_s before it [s]
};

// Of two times or more that increase.
Steps MeasureSteps(const std::vector<double>& time);

// The same of times that come one after another; their median is that of the first kJudged steps.
class RunningSteps {
 public:
  static constexpr std::size_t kJudged = 100000;

  void Add(double time);
  Steps Measured() const;

 private:
  std::vector<double> first_;  // times, until there are enough
  double last_ = 0.0;
  Steps steps_;  // once there are enough
};

// Throws InputError when the usual step is that of another unit (milliseconds, microseconds).
void CheckStepUnit(const Steps& steps, const std::string& file);

// What was left out and bridged, as sentences that begin with `name`.
void ReportRows(const CsvTable& table, const UsableRows& usable, const Steps& steps,
                const std::string& name, Findings* findings);

}  // namespace brachium
