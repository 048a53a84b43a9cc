// What is said about a series of errors.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace brachium {

// A column per sample, a row per component. A column with a NaN is a sample left out.
using Series = Eigen::MatrixXd;

// In the unit of the error; NaN when no sample was used. rmse² = bias² + sd².
struct Statistics {
  static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  std::size_t used = 0;
  std::size_t left_out = 0;
  double bias = kUnknown;    // mean, signed; of a vector error: the length of the mean vector
  double sd = kUnknown;      // about the mean, divided by n; of a vector error: over all components
  double rmse = kUnknown;    // of the magnitude
  double median = kUnknown;  // of the magnitude, like the two below
  double p95 = kUnknown;
  double max = kUnknown;
  std::optional<double> correlation;  // of estimate with reference; absent where none is defined
};

Statistics StatisticsOf(const Series& error);

// Linear between neighbours in order; part 0 is the least value, 1 the greatest. NaNs are left out;
// without another value the quantile is NaN.
double Quantile(std::vector<double> values, double part);

// Pearson's correlation coefficient; of vectors, covariances and variances are summed over the
// components. Absent below two samples or when one of the two does not vary.
std::optional<double> Correlation(const Series& estimate, const Series& reference);

}  // namespace brachium
