#include "problems/cycles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace brachium {
namespace {

struct Swing {
  std::vector<double> time, signal;
};

// Ten swings of 2 s, with ripples.
Swing Example() {
  Swing swing;
  for (int i = 0; i < 2000; ++i) {
    const double t = 0.01 * i;
    swing.time.push_back(t);
    swing.signal.push_back(3.0 - std::cos(std::numbers::pi * t) + 0.05 * std::sin(60.0 * t));
  }
  return swing;
}

TEST(Cycles, AreFoundOncePerSwing) {
  const Swing swing = Example();
  const auto cycles = FindCycles(swing.time, swing.signal);
  ASSERT_EQ(cycles.size(), 9u);
  for (const Interval& cycle : cycles) EXPECT_NEAR(cycle.end - cycle.start, 2.0, 0.06);
  EXPECT_NEAR(cycles.front().start, 0.5, 0.03);
}

TEST(Cycles, AreNotFoundInAConstant) {
  EXPECT_TRUE(FindCycles({0, 1, 2, 3}, {5, 5, 5, 5}).empty());
}

TEST(CycleAnalysis, AveragesOverCyclesAndAxes) {
  const Swing swing = Example();
  Series reference(2, 2000), estimate(2, 2000);
  for (int i = 0; i < 2000; ++i) {
    reference(0, i) = swing.signal[static_cast<std::size_t>(i)];
    reference(1, i) = -2.0 * reference(0, i);
  }
  estimate.row(0) = reference.row(0).array() + 0.1;
  estimate.row(1) = reference.row(1).array() + 0.3;
  const CycleAnalysis analysis =
      AnalyseCycles(swing.time, estimate, reference, FindCycles(swing.time, swing.signal));
  ASSERT_EQ(analysis.cycles.size(), 9u);
  EXPECT_NEAR(analysis.mean_bias, 0.2, 1e-12);
  EXPECT_NEAR(analysis.mean_sd, 0.0, 1e-12);
  EXPECT_NEAR(analysis.mean_rmse, 0.2, 1e-12);
  EXPECT_NEAR(analysis.mean_rmse_whole, std::sqrt(0.1), 1e-12);
  EXPECT_NEAR(analysis.mean_correlation.value(), 1.0, 1e-12);
  EXPECT_NEAR(analysis.p.value(), 2.0 / 512.0, 1e-12);
}

TEST(CycleAnalysis, IsUnknownWithoutACycle) {
  const CycleAnalysis analysis = AnalyseCycles({0, 1}, Series::Ones(1, 2), Series::Ones(1, 2), {});
  EXPECT_TRUE(std::isnan(analysis.mean_rmse));
  EXPECT_FALSE(analysis.p.has_value());
}

}  // namespace
}  // namespace brachium
