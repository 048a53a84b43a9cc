#include "io/headings_figure.h"

#include <limits>

#include "io/plot/chart.h"
#include "io/plot/palette.h"
#include "problems/arm_model.h"

namespace brachium {
namespace {

constexpr double kMostDeg = 180.0;  // beyond, a relation tells nothing

std::vector<double> WithinATurn(const std::vector<double>& sd) {
  std::vector<double> degrees;
  for (const double angle : sd)
    degrees.push_back(angle / kDegree <= kMostDeg ? angle / kDegree
                                                  : std::numeric_limits<double>::quiet_NaN());
  return degrees;
}

Chart ChartOf(const HeadingSupport& support) {
  Chart chart{.title = "Heading of the " + std::string(Name(support.segment)) + " against the " +
                       std::string(Name(support.against)),
              .x = {.label = "time [s]"},
              .y = {.label = "standard deviation [deg]", .logarithmic = true}};
  if (!support.sd.empty())
    chart.lines.push_back({.name = "all together",
                           .x = support.time,
                           .y = WithinATurn(support.sd),
                           .stroke = {.width = 2.0}});
  std::size_t colour = 0;
  for (const auto& [kind, sd] : support.sd_by) {
    const std::string stroke = SeriesColour(colour++);
    chart.lines.push_back({.name = kind + " alone, in 5 s",
                           .x = support.time,
                           .y = WithinATurn(sd),
                           .stroke = {.colour = stroke, .width = 1.2, .dashes = "4 3"}});
  }
  return chart;
}

}  // namespace

std::string HeadingsFigure(const std::vector<HeadingSupport>& headings) {
  std::vector<Chart> charts;
  for (const HeadingSupport& support : headings) charts.push_back(ChartOf(support));
  return DrawCharts(charts);
}

}  // namespace brachium
