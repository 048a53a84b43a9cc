#include "io/plot/axis.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace brachium {
namespace {

using testing::ElementsAre;

std::vector<std::string> LabelsOf(const std::vector<Tick>& ticks) {
  std::vector<std::string> labels;
  for (const Tick& tick : ticks)
    if (!tick.label.empty()) labels.push_back(tick.label);
  return labels;
}

TEST(Axis, HasTicksAtMultiplesOfOneTwoOrFive) {
  EXPECT_THAT(LabelsOf(TicksOf({}, {0.0, 1.0}, 5)),
              ElementsAre("0.0", "0.2", "0.4", "0.6", "0.8", "1.0"));
  EXPECT_THAT(LabelsOf(TicksOf({}, {-7.0, 13.0}, 5)), ElementsAre("-5", "0", "5", "10"));
  EXPECT_THAT(LabelsOf(TicksOf({}, {0.0, 60.0}, 7)),
              ElementsAre("0", "10", "20", "30", "40", "50", "60"));
}

TEST(Axis, TellsCloseTicksApart) {
  EXPECT_THAT(LabelsOf(TicksOf({}, {1.001, 1.004}, 4)),
              ElementsAre("1.001", "1.002", "1.003", "1.004"));
}

TEST(Axis, HasPowersOfTenOnALogarithmicScale) {
  const Axis axis{.logarithmic = true};
  EXPECT_THAT(LabelsOf(TicksOf(axis, {0.05, 300.0}, 4)), ElementsAre("0.1", "1", "10", "100"));
  EXPECT_THAT(LabelsOf(TicksOf(axis, {0.9, 21.0}, 6)), ElementsAre("1", "2", "5", "10", "20"));
}

TEST(Axis, NamesItsCategories) {
  const Axis axis{.categories = {"a", "b"}};
  const Range range = RangeOf(axis, {});
  const auto ticks = TicksOf(axis, range, 5);
  EXPECT_THAT(LabelsOf(ticks), ElementsAre("a", "b"));
  EXPECT_LT(range.low, ticks.front().value);
  EXPECT_GT(range.high, ticks.back().value);
}

TEST(Axis, SpansWhatCanBeShown) {
  const double nan = std::nan("");
  const Range linear = RangeOf({}, {nan, 3.0, -1.0});
  EXPECT_NEAR(linear.low, -1.16, 1e-12);
  EXPECT_NEAR(linear.high, 3.16, 1e-12);
  const Range logarithmic = RangeOf({.logarithmic = true}, {0.0, -4.0, 1.0, 100.0, nan});
  EXPECT_GT(logarithmic.low, 0.5);
  EXPECT_LT(logarithmic.high, 150.0);
  EXPECT_EQ(RangeOf({.from_zero = true}, {2.0, 5.0}).low, 0.0);
}

TEST(Axis, HasAWidthWhateverItShows) {
  for (const bool logarithmic : {false, true})
    for (const std::vector<double>& values :
         {std::vector<double>{}, std::vector<double>{3.0}, std::vector<double>{3.0, 3.0}}) {
      const Range range = RangeOf({.logarithmic = logarithmic}, values);
      EXPECT_LT(range.low, range.high);
      EXPECT_FALSE(TicksOf({.logarithmic = logarithmic}, range, 5).empty());
    }
}

TEST(Axis, PlacesValuesByTheirLogarithm) {
  EXPECT_NEAR(Fraction({.logarithmic = true}, {1.0, 100.0}, 10.0), 0.5, 1e-12);
  EXPECT_NEAR(Fraction({}, {-1.0, 3.0}, 0.0), 0.25, 1e-12);
}

}  // namespace
}  // namespace brachium
