#include "problems/statistics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace brachium {
namespace {

const double kNaN = std::nan("");

TEST(Statistics, AreSignedInBiasAndUnsignedInMedianAndMaximum) {
  const Series error = (Series(1, 4) << -4.0, 1.0, -2.0, 1.0).finished();
  const Statistics statistics = StatisticsOf(error);
  EXPECT_EQ(statistics.used, 4u);
  EXPECT_NEAR(statistics.bias, -1.0, 1e-14);
  EXPECT_NEAR(statistics.rmse, std::sqrt(22.0 / 4.0), 1e-14);
  EXPECT_NEAR(statistics.median, 1.5, 1e-14);
  EXPECT_NEAR(statistics.max, 4.0, 1e-14);
}

TEST(Statistics, SplitTheMeanSquareIntoBiasAndDeviation) {
  for (const int rows : {1, 2, 3}) {
    const Series error = Series::Random(rows, 50).array() + 0.3;
    const Statistics s = StatisticsOf(error);
    EXPECT_NEAR(s.rmse * s.rmse, s.bias * s.bias + s.sd * s.sd, 1e-12);
  }
}

TEST(Statistics, KeepASmallDeviationBesideALargeBias) {
  Series error(1, 1000);
  for (int i = 0; i < 1000; ++i) error(0, i) = 1e6 + (i % 2 == 0 ? 1e-3 : -1e-3);
  EXPECT_NEAR(StatisticsOf(error).sd, 1e-3, 1e-8);
}

TEST(Statistics, TakeNinetyFivePercentBetweenNeighbours) {
  Series error(1, 101);
  for (int i = 0; i <= 100; ++i) error(0, i) = 100 - i;
  EXPECT_NEAR(StatisticsOf(error).p95, 95.0, 1e-12);
  EXPECT_NEAR(StatisticsOf(error.leftCols(2)).p95, 99.95, 1e-12);
}

TEST(Statistics, TakeTheLengthOfAVectorError) {
  const Series error = (Series(2, 2) << 3.0, -3.0, 4.0, 4.0).finished();
  const Statistics statistics = StatisticsOf(error);
  EXPECT_NEAR(statistics.rmse, 5.0, 1e-14);
  EXPECT_NEAR(statistics.bias, 4.0, 1e-14);
  EXPECT_NEAR(statistics.sd, 3.0, 1e-14);
}

TEST(Statistics, CountWhatIsLeftOut) {
  const Series error = (Series(2, 3) << 1.0, kNaN, 1.0, 0.0, 0.0, kNaN).finished();
  const Statistics statistics = StatisticsOf(error);
  EXPECT_EQ(statistics.used, 1u);
  EXPECT_EQ(statistics.left_out, 2u);
  EXPECT_NEAR(statistics.rmse, 1.0, 1e-14);
}

TEST(Statistics, AreUnknownWithoutASample) {
  for (const Series& error : {Series(1, 0), Series(Series::Constant(3, 5, kNaN))}) {
    const Statistics statistics = StatisticsOf(error);
    EXPECT_EQ(statistics.used, 0u);
    EXPECT_TRUE(std::isnan(statistics.rmse));
    EXPECT_TRUE(std::isnan(statistics.max));
  }
}

TEST(Correlation, IsOneForWhatDiffersByFactorAndConstant) {
  const Series x = Series::Random(1, 40);
  EXPECT_NEAR(Correlation(x, 2.0 * x.array() + 3.0).value(), 1.0, 1e-12);
  EXPECT_NEAR(Correlation(x, -x).value(), -1.0, 1e-12);
}

TEST(Correlation, IsTheTextbookFigure) {
  const Series x = (Series(1, 4) << 1, 2, 3, 4).finished();
  const Series y = (Series(1, 4) << 1, 3, 2, 4).finished();
  EXPECT_NEAR(Correlation(x, y).value(), 0.8, 1e-14);
}

TEST(Correlation, SkipsPairsWithAGap) {
  const Series x = (Series(1, 5) << 1, 2, kNaN, 3, 4).finished();
  const Series y = (Series(1, 5) << 1, 3, 9, 2, 4).finished();
  EXPECT_NEAR(Correlation(x, y).value(), 0.8, 1e-14);
}

TEST(Correlation, IsAbsentWhenOneDoesNotVary) {
  const Series x = Series::Random(1, 40);
  EXPECT_FALSE(Correlation(x, Series::Constant(1, 40, 0.1)).has_value());
  EXPECT_FALSE(Correlation(Series::Constant(1, 40, kNaN), x).has_value());
}

}  // namespace
}  // namespace brachium
