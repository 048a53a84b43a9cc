#include "problems/parameter_choice.h"

#include <cmath>
#include <limits>

namespace brachium {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

ParameterChoice::Point Least(const Eigen::RowVectorXd& errors) {
  ParameterChoice::Point least;
  for (Eigen::Index point = 0; point < errors.size(); ++point)
    if (!std::isnan(errors(point)) && (!least || errors(point) < errors(*least))) least = point;
  return least;
}

// NaN at a point that one of the trials lacks.
Eigen::RowVectorXd MeanOf(const Eigen::MatrixXd& errors, const std::vector<Eigen::Index>& trials) {
  Eigen::RowVectorXd mean = Eigen::RowVectorXd::Zero(errors.cols());
  for (const Eigen::Index trial : trials) mean += errors.row(trial);
  return mean / static_cast<double>(trials.size());
}

std::vector<Eigen::Index> Without(Eigen::Index one, std::vector<Eigen::Index> trials) {
  std::erase(trials, one);
  return trials;
}

}  // namespace

ParameterChoice ChooseParameters(const Eigen::MatrixXd& errors) {
  ParameterChoice choice{.overall_error = kUnknown, .others_error = kUnknown};
  std::vector<Eigen::Index> judged;
  for (Eigen::Index trial = 0; trial < errors.rows(); ++trial) {
    choice.best.push_back(Least(errors.row(trial)));
    if (choice.best.back()) judged.push_back(trial);
  }
  choice.by_others.resize(choice.best.size());
  if (judged.empty()) return choice;
  const Eigen::RowVectorXd mean = MeanOf(errors, judged);
  choice.overall = Least(mean);
  if (choice.overall) choice.overall_error = mean(*choice.overall);
  if (judged.size() < 2) return choice;
  double sum = 0.0;
  for (const Eigen::Index trial : judged) {
    auto& point = choice.by_others[static_cast<std::size_t>(trial)];
    point = Least(MeanOf(errors, Without(trial, judged)));
    sum += point ? errors(trial, *point) : kUnknown;
  }
  choice.others_error = sum / static_cast<double>(judged.size());
  return choice;
}

}  // namespace brachium
