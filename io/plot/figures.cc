#include "io/plot/figures.h"

#include <cmath>

#include "io/text.h"
#include "problems/statistics.h"

namespace brachium {

void AddWithQuartiles(const std::vector<double>& x, const Eigen::MatrixXd& lines,
                      const std::string& name, const std::string& colour, Chart* chart) {
  for (Eigen::Index row = 0; row < lines.rows(); ++row) {
    LineSeries thin{.x = x, .stroke = {.colour = colour, .width = 0.6, .opacity = 0.35}};
    for (Eigen::Index i = 0; i < lines.cols(); ++i) thin.y.push_back(lines(row, i));
    chart->lines.push_back(std::move(thin));
  }
  Band quartiles{.x = x, .fill = {.colour = colour, .opacity = 0.2}};
  LineSeries median{.name = name, .x = x, .stroke = {.colour = colour, .width = 2.5}};
  for (Eigen::Index i = 0; i < lines.cols(); ++i) {
    const Eigen::VectorXd column = lines.col(i);
    const std::vector<double> values(column.begin(), column.end());
    quartiles.low.push_back(Quantile(values, 0.25));
    quartiles.high.push_back(Quantile(values, 0.75));
    median.y.push_back(Quantile(values, 0.5));
  }
  chart->bands.push_back(std::move(quartiles));
  chart->lines.push_back(std::move(median));
}

Chart BlandAltmanChart(const DifferencesOverMeans& differences) {
  const std::string& unit = differences.unit;
  const auto rule = [&](double value, const std::string& name, const std::string& dashes) {
    return Rule{.value = value,
                .label = name + " " + Fixed(value, 2) + " " + unit,
                .stroke = {.colour = "#d55e00", .dashes = dashes}};
  };
  Chart chart{.title = differences.title,
              .x = {.label = "mean [" + unit + "]"},
              .y = {.label = "difference [" + unit + "]"}};
  chart.dots.push_back({.x = differences.mean,
                        .y = differences.difference,
                        .fill = {.colour = "#0072b2", .opacity = 0.5}});
  chart.rules = {rule(differences.bias, "bias", ""), rule(differences.lower, "lower", "4 3"),
                 rule(differences.upper, "upper", "4 3")};
  return chart;
}

}  // namespace brachium
