// Charts of a usual kind.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "io/plot/chart.h"

namespace brachium {

// Adds many lines over one x as thin ones, and over them the band of their quartiles and their
// median; at each x from those that have a value there. `lines`: a row each, a column per x.
void AddWithQuartiles(const std::vector<double>& x, const Eigen::MatrixXd& lines,
                      const std::string& name, const std::string& colour, Chart* chart);

// Differences of two measurements over their means, with the bias and the limits of agreement.
// After Bland & Altman, Lancet 327 (1986).
struct DifferencesOverMeans {
  std::string title{}, unit{};
  std::vector<double> mean{}, difference{};  // of one length
  double bias = 0.0, lower = 0.0, upper = 0.0;
};
Chart BlandAltmanChart(const DifferencesOverMeans& differences);

}  // namespace brachium
