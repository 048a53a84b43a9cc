#include "problems/agreement.h"

#include <algorithm>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <numeric>

namespace brachium {
namespace {

constexpr double kTail = 0.025;  // on either side of 95 %
constexpr std::size_t kMostExact = 200;

double NormalQuantile() {
  return boost::math::quantile(boost::math::complement(boost::math::normal(), kTail));
}

double FQuantile(double numerator, double denominator) {
  return boost::math::quantile(
      boost::math::complement(boost::math::fisher_f(numerator, denominator), kTail));
}

struct Pairs {
  Eigen::VectorXd x, y;
};

Pairs CompletePairs(const std::vector<double>& x, const std::vector<double>& y) {
  std::vector<double> known_x, known_y;
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
    if (std::isnan(x[i]) || std::isnan(y[i])) continue;
    known_x.push_back(x[i]);
    known_y.push_back(y[i]);
  }
  const auto n = static_cast<Eigen::Index>(known_x.size());
  return {Eigen::Map<Eigen::VectorXd>(known_x.data(), n),
          Eigen::Map<Eigen::VectorXd>(known_y.data(), n)};
}

// Twice the mean rank of each size of the differences, so that it is a whole number.
std::vector<std::size_t> DoubledRanks(const std::vector<double>& differences) {
  std::vector<std::size_t> order(differences.size()), ranks(differences.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto size = [&](std::size_t i) { return std::abs(differences[i]); };
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return size(a) < size(b); });
  for (std::size_t first = 0, end = 0; first < order.size(); first = end) {
    while (end < order.size() && size(order[end]) == size(order[first])) ++end;
    for (std::size_t i = first; i < end; ++i) ranks[order[i]] = first + 1 + end;
  }
  return ranks;
}

// P(sum <= at most) of ranks that each count or do not, with equal chances.
double ExactTail(const std::vector<std::size_t>& ranks, std::size_t at_most) {
  const std::size_t total = std::accumulate(ranks.begin(), ranks.end(), std::size_t{0});
  std::vector<double> chance(total + 1, 0.0);
  chance[0] = 1.0;
  std::size_t reached = 0;
  for (const std::size_t rank : ranks) {
    reached += rank;
    for (std::size_t sum = reached + 1; sum-- > 0;)
      chance[sum] = 0.5 * (chance[sum] + (sum >= rank ? chance[sum - rank] : 0.0));
  }
  return std::accumulate(chance.begin(), chance.begin() + static_cast<std::ptrdiff_t>(at_most) + 1,
                         0.0);
}

double NormalTail(const std::vector<std::size_t>& doubled, double least_sum) {
  double mean = 0.0, variance = 0.0;
  for (const std::size_t rank : doubled) {
    mean += static_cast<double>(rank) / 4.0;
    variance += static_cast<double>(rank * rank) / 16.0;
  }
  const double z = (least_sum - mean + 0.5) / std::sqrt(variance);
  return boost::math::cdf(boost::math::normal(), std::min(z, 0.0));
}

struct MeanSquares {
  double rows = 0.0, columns = 0.0, error = 0.0;
};

MeanSquares MeanSquaresOf(const Eigen::MatrixXd& x) {
  const auto n = static_cast<double>(x.rows()), k = static_cast<double>(x.cols());
  const double mean = x.mean();
  const Eigen::VectorXd rows = x.rowwise().mean(), columns = x.colwise().mean().transpose();
  const Eigen::MatrixXd rest =
      ((x.colwise() - rows).rowwise() - columns.transpose()).array() + mean;
  return {.rows = k * (rows.array() - mean).square().sum() / (n - 1.0),
          .columns = n * (columns.array() - mean).square().sum() / (k - 1.0),
          .error = rest.squaredNorm() / ((n - 1.0) * (k - 1.0))};
}

IntraclassCorrelation::Value ConsistencyOf(const MeanSquares& mean, double n, double k) {
  const double f = mean.rows / mean.error, df = n - 1.0, df_error = df * (k - 1.0);
  const double low = f / FQuantile(df, df_error), high = f * FQuantile(df_error, df);
  const auto icc = [k](double ratio) { return (ratio - 1.0) / (ratio + k - 1.0); };
  return {icc(f), icc(low), icc(high)};
}

// The interval after McGraw & Wong, table 7, case 2A.
IntraclassCorrelation::Value AgreementOf(const MeanSquares& mean, double n, double k) {
  const double icc = (mean.rows - mean.error) /
                     (mean.rows + (k - 1.0) * mean.error + k * (mean.columns - mean.error) / n);
  const double a = k * icc / (n * (1.0 - icc));
  const double b = 1.0 + k * icc * (n - 1.0) / (n * (1.0 - icc));
  const double columns = a * mean.columns, error = b * mean.error;
  const double df = std::pow(columns + error, 2) /
                    (columns * columns / (k - 1.0) + error * error / ((n - 1.0) * (k - 1.0)));
  const double f_low = FQuantile(n - 1.0, df), f_high = FQuantile(df, n - 1.0);
  const double within = k * mean.columns + (k * n - k - n) * mean.error;
  return {icc, n * (mean.rows - f_low * mean.error) / (f_low * within + n * mean.rows),
          n * (f_high * mean.rows - mean.error) / (within + n * f_high * mean.rows)};
}

}  // namespace

std::optional<double> Concordance(const std::vector<double>& x, const std::vector<double>& y) {
  const Pairs pairs = CompletePairs(x, y);
  if (pairs.x.size() < 2) return std::nullopt;
  const double mean_x = pairs.x.mean(), mean_y = pairs.y.mean();
  const auto n = static_cast<double>(pairs.x.size());
  const Eigen::ArrayXd dx = pairs.x.array() - mean_x, dy = pairs.y.array() - mean_y;
  const double spread = (dx.square().sum() + dy.square().sum()) / n + std::pow(mean_x - mean_y, 2);
  if (spread <= 0.0) return std::nullopt;
  return 2.0 * (dx * dy).sum() / n / spread;
}

std::optional<LimitsOfAgreement> LimitsOf(const std::vector<double>& x,
                                          const std::vector<double>& y) {
  const Pairs pairs = CompletePairs(x, y);
  if (pairs.x.size() < 2) return std::nullopt;
  const auto n = static_cast<double>(pairs.x.size());
  const Eigen::ArrayXd difference = pairs.x - pairs.y;
  LimitsOfAgreement limits{.used = static_cast<std::size_t>(pairs.x.size())};
  limits.bias = difference.mean();
  limits.sd = std::sqrt((difference - limits.bias).square().sum() / (n - 1.0));
  limits.lower = limits.bias - NormalQuantile() * limits.sd;
  limits.upper = limits.bias + NormalQuantile() * limits.sd;
  const double t =
      boost::math::quantile(boost::math::complement(boost::math::students_t(n - 1.0), kTail));
  limits.bias_half_width = t * limits.sd / std::sqrt(n);
  limits.limit_half_width = t * limits.sd * std::sqrt(3.0 / n);
  return limits;
}

SignedRankTest WilcoxonSignedRank(const std::vector<double>& differences) {
  std::vector<double> kept = differences;
  std::erase_if(kept, [](double d) { return std::isnan(d) || d == 0.0; });
  SignedRankTest test{.used = kept.size()};
  if (kept.empty()) return test;
  const std::vector<std::size_t> doubled = DoubledRanks(kept);
  std::size_t positive = 0, total = 0;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    total += doubled[i];
    if (kept[i] > 0.0) positive += doubled[i];
  }
  const std::size_t lesser = std::min(positive, total - positive);
  test.positive_sum = static_cast<double>(positive) / 2.0;
  test.exact = kept.size() <= kMostExact;
  const double tail = test.exact ? ExactTail(doubled, lesser)
                                 : NormalTail(doubled, static_cast<double>(lesser) / 2.0);
  test.p = std::min(1.0, 2.0 * tail);
  return test;
}

std::optional<IntraclassCorrelation> IntraclassCorrelationOf(const Eigen::MatrixXd& measurements) {
  const auto n = static_cast<double>(measurements.rows());
  const auto k = static_cast<double>(measurements.cols());
  if (n < 2.0 || k < 2.0 || !measurements.allFinite()) return std::nullopt;
  const MeanSquares mean = MeanSquaresOf(measurements);
  if (mean.error <= 0.0) return std::nullopt;
  const double spread = (measurements.array() - measurements.mean()).square().sum();
  return IntraclassCorrelation{.agreement = AgreementOf(mean, n, k),
                               .consistency = ConsistencyOf(mean, n, k),
                               .sd = std::sqrt(spread / (n * k - 1.0))};
}

double MinimalDetectableChange(double sd, double icc) {
  return NormalQuantile() * std::sqrt(2.0) * sd * std::sqrt(std::max(0.0, 1.0 - icc));
}

}  // namespace brachium
