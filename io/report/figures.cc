#include "io/report/figures.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "io/headings_figure.h"
#include "io/plot/palette.h"
#include "io/report/series.h"

namespace brachium {
namespace {

constexpr ChartSize kOverTime{.width = 860.0, .height = 250.0};

Stroke EstimateStroke() { return {.colour = SeriesColour(0), .width = 1.5}; }
Stroke ReferenceStroke() { return {.colour = SeriesColour(1), .width = 1.2, .dashes = "5 3"}; }

ReportFigure OverTime(std::string name, std::string caption, std::vector<Chart> charts) {
  ReportFigure figure{.name = std::move(name), .caption = std::move(caption), .size = kOverTime};
  if (!charts.empty()) figure.svg = DrawCharts(charts, kOverTime);
  figure.charts = std::move(charts);
  return figure;
}

std::string MoverOf(const Estimate& estimate) {
  for (const char* point : {"hand", "wrist", "elbow"})
    if (estimate.p_W.contains(point)) return point;
  return estimate.p_W.empty() ? "" : estimate.p_W.begin()->first;
}

}  // namespace

ReportFigure AnglesFigure(const ReportedEstimate& reported, std::size_t most) {
  const std::vector<Span> rests = CommonRests(reported.estimate);
  std::vector<Chart> charts;
  for (const auto& [name, series] : ShownAngles(reported.estimate)) {
    Chart chart = ChartOverTime(Spoken(name), "angle [deg]", rests);
    AddWithBand(series, "estimate", "95 % of the estimate", EstimateStroke(), kNineteenOfTwenty,
                most, &chart);
    if (const ShownSeries reference = ReferenceAngle(reported, name); !reference.time.empty())
      AddWithBand(reference, "reference", "", ReferenceStroke(), 0.0, most, &chart);
    charts.push_back(std::move(chart));
  }
  return OverTime("joint_angles",
                  "Angles over time. The band holds 95 % by the estimate's own standard deviation "
                  "(±1.96 sd), grey are rests of all sensors, the reference is dashed.",
                  std::move(charts));
}

ReportFigure PointFigure(const ReportedEstimate& reported, std::size_t most) {
  const std::string point = MoverOf(reported.estimate);
  if (point.empty()) return {};
  const auto& p_W = reported.estimate.p_W.at(point);
  const auto sd_W = reported.estimate.sd_W.find(point);
  std::vector<Chart> charts;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    ShownSeries series{.time = reported.estimate.time};
    for (const Eigen::Vector3d& p : p_W) series.value.push_back(p[axis]);
    if (sd_W != reported.estimate.sd_W.end())
      for (const Eigen::Vector3d& sd : sd_W->second) series.sd.push_back(sd[axis]);
    constexpr std::array kAxes = {"x", "y", "z, upward"};
    Chart chart = ChartOverTime(Spoken(point) + " " + kAxes[static_cast<std::size_t>(axis)],
                                "place [m]", CommonRests(reported.estimate));
    AddWithBand(series, "estimate", "95 % of the estimate", EstimateStroke(), kNineteenOfTwenty,
                most, &chart);
    charts.push_back(std::move(chart));
  }
  return OverTime("place",
                  "Where the " + Spoken(point) +
                      " is, in the estimate's world: its origin and the heading of its x axis are "
                      "free, z is up. The band holds 95 %, grey are rests.",
                  std::move(charts));
}

ReportFigure ObservabilityFigure(const ReportedEstimate& reported) {
  const auto& headings = reported.estimate.diagnostics.headings;
  return OverTime(
      "observability",
      "What held the heading of a segment against the one before it: the standard "
      "deviation over the trial, and dashed what each kind of residual alone would hold "
      "it to by what happens in 5 s. Less is better held.",
      HeadingsCharts(headings));
}

ReportFigure ResidualsFigure(const ReportedEstimate& reported) {
  const auto& residuals = reported.estimate.diagnostics.residuals;
  Chart chart{.title = "Rms of whitened residuals",
              .y = {.label = "rms", .logarithmic = true},
              .rules = {{.value = 1.0, .label = "1: the model holds"}}};
  BoxSeries bounds{.name = "1 ± 3 sd of its count", .colour = "#666666", .width = 0.5};
  Dots within{
      .name = "within the bounds or below", .fill = {.colour = SeriesColour(0)}, .radius = 4.5};
  Dots above{.name = "above: claims too much", .fill = {.colour = SeriesColour(1)}, .radius = 4.5};
  for (const ResidualStatistics& residual : residuals) {
    if (residual.count == 0 || !(residual.rms > 1e-4)) continue;
    const auto place = static_cast<double>(chart.x.categories.size());
    const double reach = 3.0 / std::sqrt(2.0 * static_cast<double>(residual.count));
    const double low = std::max(1.0 - reach, 0.1), high = 1.0 + reach;
    chart.x.categories.push_back(residual.kind);
    bounds.boxes.push_back({place, low, low, 1.0, high, high});
    Dots& dots = residual.rms > high ? above : within;
    dots.x.push_back(place);
    dots.y.push_back(residual.rms);
  }
  if (chart.x.categories.empty()) return {};
  chart.boxes.push_back(std::move(bounds));
  for (Dots* dots : {&within, &above})
    if (!dots->x.empty()) chart.dots.push_back(std::move(*dots));
  return {.name = "residuals",
          .caption =
              "Residuals by kind, divided by their standard deviations. Where the model of a "
              "kind holds, its rms is 1 to within the box (±3 standard deviations of an rms of "
              "so many normal numbers). Well below: the weights allow for more error than "
              "there was. Above: that model claims too much.",
          .svg = DrawCharts({chart}, {.width = 860.0, .height = 440.0})};
}

ReportFigure OverlaidAnglesFigure(const std::vector<const ReportedEstimate*>& estimates,
                                  std::size_t most) {
  std::vector<Chart> charts;
  for (std::size_t e = 0; e < estimates.size(); ++e)
    for (const auto& [name, series] : ShownAngles(estimates[e]->estimate)) {
      const std::string title = Spoken(name);
      auto chart = std::find_if(charts.begin(), charts.end(),
                                [&](const Chart& other) { return other.title == title; });
      if (chart == charts.end())
        chart = charts.insert(charts.end(), ChartOverTime(title, "angle [deg]", {}));
      const Stroke stroke{
          .colour = SeriesColour(e), .width = 1.2, .dashes = e == 0 ? "" : SeriesDashes(e + 8)};
      AddWithBand({.time = series.time, .value = series.value}, estimates[e]->label, "", stroke,
                  0.0, most, &*chart);
    }
  return OverTime("overlaid_angles", "The angles of all methods over one another.",
                  std::move(charts));
}

}  // namespace brachium
