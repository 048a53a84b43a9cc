#include "problems/statistics.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace brachium {
namespace {

// Requires a value and no NaN; reorders the values.
double KnownQuantile(std::vector<double>* values, double part) {
  const double place = part * static_cast<double>(values->size() - 1);
  const auto below = values->begin() + static_cast<std::ptrdiff_t>(place);
  std::nth_element(values->begin(), below, values->end());
  if (below + 1 == values->end()) return *below;
  const double above = *std::min_element(below + 1, values->end());
  return *below + (place - std::floor(place)) * (above - *below);
}

// Rounding alone gives a constant of size `level` this much variance.
double NegligibleVariance(double level) { return 1e-24 * (1.0 + level * level); }

}  // namespace

double Quantile(std::vector<double> values, double part) {
  std::erase_if(values, [](double value) { return std::isnan(value); });
  return values.empty() ? Statistics::kUnknown : KnownQuantile(&values, part);
}

Statistics StatisticsOf(const Series& error) {
  Statistics statistics;
  std::vector<double> magnitude;
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(error.rows());
  double square = 0.0;
  for (const auto& e : error.colwise()) {
    if (!e.allFinite()) continue;
    mean += e;
    square += e.squaredNorm();
    magnitude.push_back(e.norm());
  }
  statistics.used = magnitude.size();
  statistics.left_out = static_cast<std::size_t>(error.cols()) - magnitude.size();
  if (magnitude.empty()) return statistics;

  const auto n = static_cast<double>(magnitude.size());
  mean /= n;
  double spread = 0.0;
  for (const auto& e : error.colwise())
    if (e.allFinite()) spread += (e - mean).squaredNorm();
  statistics.bias = error.rows() == 1 ? mean(0) : mean.norm();
  statistics.sd = std::sqrt(spread / n);
  statistics.rmse = std::sqrt(square / n);
  statistics.median = KnownQuantile(&magnitude, 0.5);
  statistics.p95 = KnownQuantile(&magnitude, 0.95);
  statistics.max = *std::max_element(magnitude.begin(), magnitude.end());
  return statistics;
}

std::optional<double> Correlation(const Series& estimate, const Series& reference) {
  Eigen::VectorXd mean_e = Eigen::VectorXd::Zero(estimate.rows()), mean_r = mean_e;
  double n = 0.0;
  const auto usable = [&](Eigen::Index i) {
    return estimate.col(i).allFinite() && reference.col(i).allFinite();
  };
  for (Eigen::Index i = 0; i < estimate.cols(); ++i) {
    if (!usable(i)) continue;
    mean_e += estimate.col(i);
    mean_r += reference.col(i);
    n += 1.0;
  }
  if (n < 2.0) return std::nullopt;
  mean_e /= n;
  mean_r /= n;
  double ee = 0.0, er = 0.0, rr = 0.0;
  for (Eigen::Index i = 0; i < estimate.cols(); ++i) {
    if (!usable(i)) continue;
    ee += (estimate.col(i) - mean_e).squaredNorm();
    er += (estimate.col(i) - mean_e).dot(reference.col(i) - mean_r);
    rr += (reference.col(i) - mean_r).squaredNorm();
  }
  if (ee <= n * NegligibleVariance(mean_e.norm()) || rr <= n * NegligibleVariance(mean_r.norm()))
    return std::nullopt;
  return er / std::sqrt(ee * rr);
}

}  // namespace brachium
