// Expected values come from tables and examples in print, named at each test, or from counting all
// cases one by one.
#include "problems/agreement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace brachium {
namespace {

const double kNaN = std::nan("");

// All signs of the ranks 1 to n (or of given ones): the share with a sum at most that far out, on
// both sides.
double CountedP(const std::vector<double>& ranks, double positive_sum) {
  double total = 0.0;
  for (const double rank : ranks) total += rank;
  const double lesser = std::min(positive_sum, total - positive_sum);
  const std::size_t cases = std::size_t{1} << ranks.size();
  std::size_t far_out = 0;
  for (std::size_t signs = 0; signs < cases; ++signs) {
    double sum = 0.0;
    for (std::size_t i = 0; i < ranks.size(); ++i)
      if ((signs >> i) & 1u) sum += ranks[i];
    far_out += std::min(sum, total - sum) <= lesser + 1e-9;
  }
  return std::min(1.0, static_cast<double>(far_out) / static_cast<double>(cases));
}

TEST(Wilcoxon, MeetsTheTabledTwoSidedProbabilities) {
  const auto all_positive = WilcoxonSignedRank({1.1, 2.2, 0.3, 4.0, 5.0});
  EXPECT_NEAR(all_positive.p, 2.0 / 32.0, 1e-15);
  EXPECT_TRUE(all_positive.exact);
  // Wilcoxon's table for 10 pairs: a sum of 8 is the 5 % point, p = 0.0488.
  const auto ten = WilcoxonSignedRank({-1, 2, 3, 4, 5, 6, -7, 8, 9, 10});
  EXPECT_NEAR(ten.positive_sum, 47.0, 1e-12);
  EXPECT_NEAR(ten.p, 0.048828125, 1e-12);
}

TEST(Wilcoxon, SharesTheRanksOfTiesAndDropsZeros) {
  const auto test = WilcoxonSignedRank({1, -1, 0, 2, 2, 2, kNaN, -3, 5});
  const std::vector<double> ranks = {1.5, 1.5, 4, 4, 4, 6, 7};
  EXPECT_EQ(test.used, 7u);
  EXPECT_NEAR(test.positive_sum, 1.5 + 12.0 + 7.0, 1e-12);
  EXPECT_NEAR(test.p, CountedP(ranks, test.positive_sum), 1e-12);
}

TEST(Wilcoxon, IsExactForSmallNumbers) {
  for (const double shift : {0.2, 2.5, 6.5}) {
    std::vector<double> differences, ranks;
    for (int i = 1; i <= 12; ++i) {
      differences.push_back(i % 2 == 0 || i < shift ? -i : i);
      ranks.push_back(i);
    }
    const auto test = WilcoxonSignedRank(differences);
    EXPECT_NEAR(test.p, CountedP(ranks, test.positive_sum), 1e-12);
  }
}

TEST(Wilcoxon, GoesOverToTheNormalDistributionWithoutALeap) {
  std::vector<double> differences;
  for (int i = 1; i <= 200; ++i) differences.push_back(i % 7 < 4 ? i : -i);
  const auto exact = WilcoxonSignedRank(differences);
  differences.push_back(0.5);
  const auto normal = WilcoxonSignedRank(differences);
  EXPECT_TRUE(exact.exact);
  EXPECT_FALSE(normal.exact);
  EXPECT_NEAR(normal.p, exact.p, 0.03 * exact.p);
}

TEST(Wilcoxon, SaysNothingWithoutDifferences) {
  EXPECT_EQ(WilcoxonSignedRank({0.0, 0.0}).p, 1.0);
  EXPECT_EQ(WilcoxonSignedRank({}).used, 0u);
}

// Six subjects and four judges: Shrout & Fleiss (1979), table 2; ICC of table 4, intervals of the
// R package psych for the same table, two digits in print.
TEST(IntraclassCorrelation, MeetsShroutAndFleissExample) {
  const Eigen::MatrixXd ratings = (Eigen::MatrixXd(6, 4) << 9, 2, 5, 8,  //
                                   6, 1, 3, 2,                           //
                                   8, 4, 6, 8,                           //
                                   7, 1, 2, 6,                           //
                                   10, 5, 6, 9,                          //
                                   6, 2, 4, 7)
                                      .finished();
  const auto icc = IntraclassCorrelationOf(ratings).value();
  EXPECT_NEAR(icc.agreement.value, 0.29, 0.005);
  EXPECT_NEAR(icc.agreement.lower, 0.02, 0.005);
  EXPECT_NEAR(icc.agreement.upper, 0.76, 0.005);
  EXPECT_NEAR(icc.consistency.value, 0.71, 0.005);
  EXPECT_NEAR(icc.consistency.lower, 0.34, 0.005);
  EXPECT_NEAR(icc.consistency.upper, 0.95, 0.005);
}

TEST(IntraclassCorrelation, CountsAConstantDifferenceOnlyInAgreement) {
  Eigen::MatrixXd twice(5, 2);
  twice.col(0) << 1, 2, 3, 4, 5.5;
  twice.col(1) = twice.col(0).array() + 1.0;
  twice(2, 1) += 1e-3;
  const auto icc = IntraclassCorrelationOf(twice).value();
  EXPECT_GT(icc.consistency.value, 0.999);
  EXPECT_LT(icc.agreement.value, 0.9);
}

TEST(IntraclassCorrelation, IsAbsentWithoutEnoughData) {
  EXPECT_FALSE(IntraclassCorrelationOf(Eigen::MatrixXd::Ones(1, 3)).has_value());
  EXPECT_FALSE(IntraclassCorrelationOf(Eigen::MatrixXd::Ones(4, 3)).has_value());
  EXPECT_FALSE(IntraclassCorrelationOf(Eigen::MatrixXd::Constant(4, 3, kNaN)).has_value());
}

// Weir (2005): sd 10, ICC 0.9: SEM 3.16, and 2.77 times that.
TEST(MinimalDetectableChange, IsTheTextbookFigure) {
  EXPECT_NEAR(MinimalDetectableChange(10.0, 0.9), 2.772 * 3.162, 0.01);
  EXPECT_EQ(MinimalDetectableChange(10.0, 1.0), 0.0);
}

TEST(Concordance, IsOneOnlyOnTheLineOfIdentity) {
  const std::vector<double> x = {1, 2, 3, 4, 5};
  EXPECT_NEAR(Concordance(x, x).value(), 1.0, 1e-14);
  // Shifted by 1: 2 * 2 / (2 + 2 + 1).
  EXPECT_NEAR(Concordance(x, {2, 3, 4, 5, 6}).value(), 0.8, 1e-14);
  // Twice as large: 2 * 4 / (2 + 8 + 9).
  EXPECT_NEAR(Concordance(x, {2, 4, 6, 8, 10}).value(), 8.0 / 19.0, 1e-14);
  EXPECT_NEAR(Concordance({1, kNaN, 2, 3, 4, 5}, {2, 9, 3, 4, 5, 6}).value(), 0.8, 1e-14);
  EXPECT_FALSE(Concordance({1, 1}, {1, 1}).has_value());
}

// Differences -2, -1, 0, 1, 2, 3: mean 0.5, sum of squares 17.5, Student's t of 5 degrees of freedom
// 2.5706 (any table).
TEST(LimitsOfAgreement, AreMeanAndDeviationByHand) {
  const auto limits = LimitsOf({8, 9, 10, 11, 12, 13, kNaN}, {10, 10, 10, 10, 10, 10, 1}).value();
  const double sd = std::sqrt(17.5 / 5.0);
  EXPECT_EQ(limits.used, 6u);
  EXPECT_NEAR(limits.bias, 0.5, 1e-14);
  EXPECT_NEAR(limits.sd, sd, 1e-14);
  EXPECT_NEAR(limits.upper, 0.5 + 1.959964 * sd, 1e-6);
  EXPECT_NEAR(limits.lower, 0.5 - 1.959964 * sd, 1e-6);
  EXPECT_NEAR(limits.bias_half_width, 2.5706 * sd / std::sqrt(6.0), 1e-4);
  EXPECT_NEAR(limits.limit_half_width, 2.5706 * sd * std::sqrt(3.0 / 6.0), 1e-4);
}

}  // namespace
}  // namespace brachium
