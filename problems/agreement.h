// How well two measurements of the same thing agree. Pairs with a NaN are left out; what the rest
// does not tell is absent.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

namespace brachium {

// Lin's concordance: 2 s_xy/(s_x² + s_y² + (mean x - mean y)²), variances divided by n. 1 only where
// every x is its y. Absent below two pairs, or when neither varies and they do not differ.
// Source: Lin, Biometrics 45 (1989).
std::optional<double> Concordance(const std::vector<double>& x, const std::vector<double>& y);

// Between which differences x - y nineteen of twenty lie if they are normal and independent:
// bias ± 1.96 sd, sd divided by n - 1; and the half widths of 95 % intervals of the bias (Student's
// t) and of each limit (its variance taken as 3 sd²/n). Samples of one movement are not independent:
// then the half widths claim too much. Source: Bland & Altman, Lancet 327 (1986).
struct LimitsOfAgreement {
  std::size_t used = 0;
  double bias = 0.0, sd = 0.0, lower = 0.0, upper = 0.0;
  double bias_half_width = 0.0, limit_half_width = 0.0;
};
std::optional<LimitsOfAgreement> LimitsOf(const std::vector<double>& x,
                                          const std::vector<double>& y);

// Whether paired differences are symmetric about zero: Wilcoxon's signed-rank test, two-sided.
// Differences of zero are dropped, equal ones share their mean rank. Up to 200 differences p is
// exact, counted over all signs of the ranks at hand; above, normal with the variance of the ranks at
// hand and a continuity correction of one half. Source: Hollander, Wolfe & Chicken, Nonparametric
// Statistical Methods (2014), section 3.1.
struct SignedRankTest {
  std::size_t used = 0;       // differences that are not zero
  double positive_sum = 0.0;  // of the ranks of the positive ones
  double p = 1.0;
  bool exact = true;
};
SignedRankTest WilcoxonSignedRank(const std::vector<double>& differences);

// Reliability of a single measurement: a row per subject, a column per repetition, all complete.
struct IntraclassCorrelation {
  struct Value {
    double value = 0.0, lower = 0.0, upper = 0.0;  // with its 95 % interval
  };
  Value agreement;    // ICC(2,1): repetitions drawn at random, their differences count
  Value consistency;  // ICC(3,1): repetitions as given, constant differences do not count
  double sd = 0.0;    // of all measurements about their mean, divided by their number less one
};

// Absent below two subjects or repetitions, with a NaN, and where nothing varies. Sources: Shrout &
// Fleiss, Psychol. Bull. 86 (1979); McGraw & Wong, Psychol. Methods 1 (1996).
std::optional<IntraclassCorrelation> IntraclassCorrelationOf(const Eigen::MatrixXd& measurements);

// The least change of a subject that is no measurement error in nineteen of twenty cases:
// 1.96 sqrt(2) sd sqrt(1 - icc), in the unit of sd. Source: Weir, J. Strength Cond. Res. 19 (2005).
double MinimalDetectableChange(double sd, double icc);

}  // namespace brachium
