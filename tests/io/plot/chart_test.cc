#include "io/plot/chart.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "io/plot/figures.h"
#include "io/plot/heat_map.h"
#include "io/plot/palette.h"

namespace brachium {
namespace {

using testing::HasSubstr;
using testing::Not;

std::size_t Count(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}

Chart Example() {
  Chart chart{.title = "a & b", .x = {.label = "time [s]"}, .y = {.label = "error [deg]"}};
  chart.lines.push_back({.name = "line", .x = {0, 1, 2, 3}, .y = {1, 3, 2, 4}});
  chart.bands.push_back({.name = "band", .x = {0, 1}, .low = {1, 1}, .high = {2, 2}});
  chart.dots.push_back({.name = "dots", .x = {0, 1}, .y = {1, std::nan("")}});
  chart.boxes.push_back({.name = "boxes", .boxes = {{1.0, 1.0, 2.0, 2.5, 3.0, 4.0, 2.7}}});
  chart.rules.push_back({.value = 2.0, .label = "limit"});
  return chart;
}

TEST(Chart, IsTheSameBytesForTheSameContents) {
  EXPECT_EQ(DrawCharts({Example()}), DrawCharts({Example()}));
}

TEST(Chart, ShowsTitleLabelsAndLegend) {
  const std::string svg = DrawCharts({Example()});
  for (const char* text :
       {"a &amp; b", "time [s]", "error [deg]", ">line<", ">band<", ">dots<", ">boxes<", ">limit<"})
    EXPECT_THAT(svg, HasSubstr(text));
}

TEST(Chart, HoldsNoNumberThatIsNotFinite) {
  Chart chart = Example();
  chart.y.logarithmic = true;
  chart.lines[0].y = {0.0, std::nan(""), -1.0, INFINITY};
  const std::string svg = DrawCharts({chart});
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  EXPECT_THAT(svg, Not(HasSubstr("inf")));
  EXPECT_EQ(Count(svg, "<polyline"), 0u);
}

TEST(Chart, LeavesOutDotsWithoutAPlace) {
  EXPECT_EQ(Count(DrawCharts({Example()}), "r=\"2\""), 1u);
}

TEST(Chart, BreaksALineAtAGap) {
  Chart chart;
  chart.lines.push_back({.x = {0, 1, 2, 3, 4}, .y = {1, 2, std::nan(""), 2, 1}});
  EXPECT_EQ(Count(DrawCharts({chart}), "<polyline"), 2u);
}

TEST(Chart, KeepsTheExtremesOfALongLine) {
  Chart chart{.y = {.limits = Range{0.0, 100.0}}};
  LineSeries line;
  for (int i = 0; i < 100000; ++i) {
    line.x.push_back(i);
    line.y.push_back(i == 54321 ? 100.0 : 1.0 + 0.1 * (i % 7));
  }
  chart.lines.push_back(line);
  const std::string svg = DrawCharts({chart});
  EXPECT_LT(svg.size(), 100000u);
  EXPECT_THAT(svg, HasSubstr(",30 "));  // the frame's upper edge
}

TEST(Chart, KeepsALongBandShort) {
  Chart chart{.y = {.limits = Range{0.0, 100.0}}};
  Band band;
  for (int i = 0; i < 100000; ++i) {
    band.x.push_back(i);
    band.low.push_back(40.0);
    band.high.push_back(i == 54321 ? 100.0 : 60.0);
  }
  chart.bands.push_back(band);
  const std::string svg = DrawCharts({chart});
  EXPECT_LT(svg.size(), 60000u);
  EXPECT_THAT(svg, HasSubstr(",30 "));  // the frame's upper edge
}

TEST(Chart, ShadesSpansAndNamesThemOnce) {
  Chart chart = Example();
  chart.spans_name = "at rest";
  const std::size_t without = Count(DrawCharts({chart}), "fill=\"#999999\"");
  chart.spans = {{0.5, 1.0}, {2.0, 2.5}};
  const std::string svg = DrawCharts({chart});
  EXPECT_EQ(Count(svg, "fill=\"#999999\""), without + 3);  // two, and their mark in the legend
  EXPECT_EQ(Count(svg, ">at rest<"), 1u);
}

TEST(Chart, LeavesRoomForLongNamesOfCategories) {
  Chart chart{.y = {.limits = Range{0.0, 1.0}}};
  const auto frame_left = [&] {
    const std::string svg = DrawCharts({chart});
    const std::string mark = "<svg x=\"";
    return std::stod(svg.substr(svg.find(mark) + mark.size()));
  };
  chart.x.categories = {"a", "b"};
  const double narrow = frame_left();
  chart.x.categories.assign(20, "accelerometer/upper_arm");
  EXPECT_GT(frame_left(), narrow + 50.0);
}

TEST(Chart, DrawsEachAsInTheStack) {
  Chart wide = Example();
  wide.y.label.clear();
  const auto each = DrawEach({Example(), wide}, {.width = 600, .height = 200});
  ASSERT_EQ(each.size(), 2u);
  EXPECT_THAT(each[1], HasSubstr("height=\"200\""));
  const auto left = [](const std::string& svg) {
    return svg.substr(svg.find("<text x=\""), 20);  // of the title, at the frame's left
  };
  EXPECT_EQ(left(each[0]), left(each[1]));
}

TEST(Chart, StacksChartsBelowEachOther) {
  EXPECT_THAT(DrawCharts({Example(), Example()}, {.width = 600, .height = 200}),
              HasSubstr("height=\"400\""));
}

TEST(Figures, DrawTheMedianOfManyLines) {
  Chart chart;
  const Eigen::MatrixXd lines = (Eigen::MatrixXd(3, 2) << 1, 5, 2, 6, 9, 7).finished();
  AddWithQuartiles({0.1, 10.0}, lines, "all", "#0072b2", &chart);
  ASSERT_EQ(chart.lines.size(), 4u);
  EXPECT_EQ(chart.lines.back().y, (std::vector<double>{2.0, 6.0}));
  EXPECT_EQ(chart.bands.back().low, (std::vector<double>{1.5, 5.5}));
  EXPECT_EQ(chart.bands.back().high, (std::vector<double>{5.5, 6.5}));
}

TEST(Figures, DrawTheLimitsOfAgreement) {
  const Chart chart = BlandAltmanChart(
      {.unit = "deg", .mean = {1, 2}, .difference = {0.5, -0.5}, .lower = -1.4, .upper = 1.4});
  ASSERT_EQ(chart.rules.size(), 3u);
  EXPECT_EQ(chart.rules[1].label, "lower -1.40 deg");
}

TEST(HeatMap, ColoursFromDarkToLightAndLeavesHolesWhite) {
  const HeatMap map{.title = "map",
                    .x = {.categories = {"1", "2"}},
                    .y = {.categories = {"a", "b"}},
                    .values = (Eigen::MatrixXd(2, 2) << 1, 10, 100, std::nan("")).finished(),
                    .value_label = "rmse",
                    .logarithmic = true};
  const std::string svg = DrawHeatMap(map);
  EXPECT_EQ(Count(svg, "stroke-width=\"0.5\""), 3u);
  EXPECT_THAT(svg, HasSubstr(">100<"));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
}

TEST(Palette, DiffersFromSeriesToSeries) {
  for (std::size_t i = 0; i < 16; ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_NE(SeriesColour(i) + SeriesDashes(i), SeriesColour(j) + SeriesDashes(j));
  EXPECT_EQ(ScaleColour(0.0), "#440154");
  EXPECT_EQ(ScaleColour(1.0), "#fde725");
}

}  // namespace
}  // namespace brachium
