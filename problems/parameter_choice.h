// Which of several parameter points to recommend, judged on trials that did not help to choose it.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace brachium {

// Points are columns.
struct ParameterChoice {
  using Point = std::optional<Eigen::Index>;
  Point overall{};                 // least mean error over the trials
  std::vector<Point> best{};       // of each trial alone
  std::vector<Point> by_others{};  // of each trial: least mean error over all other trials
  double overall_error = 0.0;      // mean over the trials, all of which took part in the choice
  double others_error = 0.0;       // mean of each trial's error at the point that the others chose:
                                   // what a new trial may expect; NaN with less than two trials
};

// `errors`: a row per trial, a column per point; NaN where there is no result. A point enters a
// mean only if all trials of that mean have it; trials without any result count for nothing. Of
// points equally good the first is taken. Leave-one-out: Stone, J. R. Stat. Soc. B 36 (1974).
ParameterChoice ChooseParameters(const Eigen::MatrixXd& errors);

}  // namespace brachium
