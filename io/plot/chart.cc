#include "io/plot/chart.h"

#include <algorithm>
#include <cmath>

#include "io/plot/layout.h"

namespace brachium {
namespace {

constexpr double kTopMargin = 30.0, kRightMargin = 14.0, kGapBelow = 10.0;  // [pixel]
constexpr double kLegendLine = 18.0, kLegendMark = 22.0;                    // [pixel]

void Append(const std::vector<double>& values, std::vector<double>* all) {
  all->insert(all->end(), values.begin(), values.end());
}

std::vector<double> ValuesAlongX(const Chart& chart) {
  std::vector<double> all;
  for (const Band& band : chart.bands) Append(band.x, &all);
  for (const BoxSeries& series : chart.boxes)
    for (const Box& box : series.boxes)
      Append({box.place - series.width / 2.0, box.place + series.width / 2.0}, &all);
  for (const LineSeries& line : chart.lines) Append(line.x, &all);
  for (const Dots& dots : chart.dots) Append(dots.x, &all);
  for (const Rule& rule : chart.rules)
    if (rule.upright) all.push_back(rule.value);
  return all;
}

std::vector<double> ValuesAlongY(const Chart& chart) {
  std::vector<double> all;
  for (const Band& band : chart.bands) {
    Append(band.low, &all);
    Append(band.high, &all);
  }
  for (const BoxSeries& series : chart.boxes)
    for (const Box& box : series.boxes)
      Append({box.low, box.lower, box.upper, box.high, box.dot.value_or(box.middle)}, &all);
  for (const LineSeries& line : chart.lines) Append(line.y, &all);
  for (const Dots& dots : chart.dots) Append(dots.y, &all);
  for (const Rule& rule : chart.rules)
    if (!rule.upright) all.push_back(rule.value);
  return all;
}

// The runs of points that have a place, several on one column of pixels reduced to the first, the
// least, the greatest and the last of them: nobody sees a difference, but the file is smaller.
class Runs {
 public:
  std::vector<std::vector<Pixel>> runs;

  void Add(const Pixel& point) {
    if (runs.empty() || ended_) runs.emplace_back();
    ended_ = false;
    if (!column_.empty() && std::floor(column_.front().x) != std::floor(point.x)) Flush();
    column_.push_back(point);
  }

  void End() {
    Flush();
    ended_ = true;
  }

 private:
  void Flush() {
    if (column_.size() <= 4) {
      runs.back().insert(runs.back().end(), column_.begin(), column_.end());
    } else {
      auto [least, greatest] = std::minmax_element(
          column_.begin(), column_.end(), [](const Pixel& a, const Pixel& b) { return a.y < b.y; });
      if (greatest < least) std::swap(least, greatest);
      for (const Pixel& kept : {column_.front(), *least, *greatest, column_.back()})
        runs.back().push_back(kept);
    }
    column_.clear();
  }

  std::vector<Pixel> column_;
  bool ended_ = false;
};

void Draw(const LineSeries& line, const Frame2d& frame, Svg* svg) {
  Runs runs;
  for (std::size_t i = 0; i < line.x.size(); ++i) {
    if (Shown(frame.x_axis, line.x[i]) && Shown(frame.y_axis, line.y[i]))
      runs.Add(frame.At(line.x[i], line.y[i]));
    else if (!runs.runs.empty())
      runs.End();
  }
  if (!runs.runs.empty()) runs.End();
  for (const auto& run : runs.runs) svg->Polyline(run, line.stroke);
}

void Draw(const Band& band, const Frame2d& frame, Svg* svg) {
  std::vector<Pixel> edge, back;
  const auto finish = [&] {
    edge.insert(edge.end(), back.rbegin(), back.rend());
    svg->Polygon(edge, band.fill);
    edge.clear();
    back.clear();
  };
  for (std::size_t i = 0; i < band.x.size(); ++i) {
    if (Shown(frame.x_axis, band.x[i]) && Shown(frame.y_axis, band.low[i]) &&
        Shown(frame.y_axis, band.high[i])) {
      edge.push_back(frame.At(band.x[i], band.high[i]));
      back.push_back(frame.At(band.x[i], band.low[i]));
    } else {
      finish();
    }
  }
  finish();
}

void Draw(const Dots& dots, const Frame2d& frame, Svg* svg) {
  for (std::size_t i = 0; i < dots.x.size(); ++i)
    if (Shown(frame.x_axis, dots.x[i]) && Shown(frame.y_axis, dots.y[i]))
      svg->Circle(frame.At(dots.x[i], dots.y[i]), dots.radius, dots.fill);
}

void Draw(const Box& box, const BoxSeries& series, const Frame2d& frame, Svg* svg) {
  if (!Shown(frame.y_axis, box.low) || !Shown(frame.y_axis, box.high)) return;
  const auto at = [&](double offset, double value) { return frame.At(box.place + offset, value); };
  const double half = series.width / 2.0;
  const Stroke ink{.colour = series.colour, .width = 1.5};
  svg->Line(at(0.0, box.low), at(0.0, box.lower), ink);
  svg->Line(at(0.0, box.upper), at(0.0, box.high), ink);
  for (const double end : {box.low, box.high})
    svg->Line(at(-half / 2.0, end), at(half / 2.0, end), ink);
  const Pixel corner = at(-half, box.upper), opposite = at(half, box.lower);
  svg->Rectangle(corner, opposite.x - corner.x, opposite.y - corner.y,
                 {.colour = series.colour, .opacity = 0.25}, ink);
  svg->Line(at(-half, box.middle), at(half, box.middle), {.colour = series.colour, .width = 2.5});
  if (box.dot && Shown(frame.y_axis, *box.dot))
    svg->Circle(at(0.0, *box.dot), 3.0, {.colour = series.colour});
}

void Draw(const Rule& rule, const Frame2d& frame, Svg* svg) {
  const Axis& axis = rule.upright ? frame.x_axis : frame.y_axis;
  if (!Shown(axis, rule.value)) return;
  if (rule.upright) {
    const double x = frame.At(rule.value, frame.y_range.low).x;
    svg->Line({x, frame.corner.y}, {x, frame.corner.y + frame.height}, rule.stroke);
    svg->Text({x + 4.0, frame.corner.y + 13.0}, rule.label, {.size = 11.0});
  } else {
    const double y = frame.At(frame.x_range.low, rule.value).y, left = frame.corner.x;
    svg->Line({left, y}, {left + frame.width, y}, rule.stroke);
    const bool room_above = y - frame.corner.y > kLegendLine;
    svg->Text({left + frame.width - 4.0, room_above ? y - 4.0 : y + 13.0}, rule.label,
              {.anchor = TextStyle::Anchor::kEnd, .size = 11.0});
  }
}

struct LegendEntry {
  std::string name;
  Stroke stroke;  // of no width: none
  Fill fill;      // of no colour: none
};

std::vector<LegendEntry> LegendOf(const Chart& chart) {
  std::vector<LegendEntry> entries;
  const Stroke none{.width = 0.0};
  for (const BoxSeries& series : chart.boxes)
    if (!series.boxes.empty())
      entries.push_back({series.name, none, {.colour = series.colour, .opacity = 0.6}});
  for (const LineSeries& line : chart.lines) entries.push_back({line.name, line.stroke, {}});
  for (const Band& band : chart.bands) entries.push_back({band.name, none, band.fill});
  for (const Dots& dots : chart.dots) entries.push_back({dots.name, none, dots.fill});
  std::erase_if(entries, [](const LegendEntry& entry) { return entry.name.empty(); });
  return entries;
}

double LegendWidth(const std::vector<Chart>& charts) {
  double width = 0.0;
  for (const Chart& chart : charts)
    for (const LegendEntry& entry : LegendOf(chart))
      width = std::max(width, kLegendMark + TextWidth(entry.name) + 18.0);
  return width;
}

void DrawLegend(const Chart& chart, const Pixel& corner, Svg* svg) {
  double y = corner.y + kLegendLine / 2.0;
  for (const LegendEntry& entry : LegendOf(chart)) {
    if (entry.stroke.width > 0.0)
      svg->Line({corner.x, y}, {corner.x + kLegendMark - 4.0, y}, entry.stroke);
    else
      svg->Rectangle({corner.x + 2.0, y - 6.0}, 12.0, 12.0, entry.fill, {.width = 0.0});
    svg->Text({corner.x + kLegendMark, y + 4.0}, entry.name, {.size = kTextSize});
    y += kLegendLine;
  }
}

void DrawContents(const Chart& chart, const Frame2d& frame, Svg* svg) {
  svg->BeginClip(frame.corner, frame.width, frame.height);
  for (const Band& band : chart.bands) Draw(band, frame, svg);
  for (const BoxSeries& series : chart.boxes)
    for (const Box& box : series.boxes) Draw(box, series, frame, svg);
  for (const LineSeries& line : chart.lines) Draw(line, frame, svg);
  for (const Dots& dots : chart.dots) Draw(dots, frame, svg);
  for (const Rule& rule : chart.rules) Draw(rule, frame, svg);
  svg->EndClip();
}

Frame2d FrameOf(const Chart& chart) {
  return {.x_axis = chart.x,
          .y_axis = chart.y,
          .x_range = RangeOf(chart.x, ValuesAlongX(chart)),
          .y_range = RangeOf(chart.y, ValuesAlongY(chart))};
}

}  // namespace

std::string DrawCharts(const std::vector<Chart>& charts, const ChartSize& size) {
  Svg svg(size.width, size.height * static_cast<double>(charts.size()));
  std::vector<Frame2d> frames;
  double left = 0.0;
  for (const Chart& chart : charts) {
    frames.push_back(FrameOf(chart));
    left = std::max(left, LeftMargin(chart.y, frames.back().y_range));
  }
  const double width = size.width - left - kRightMargin - LegendWidth(charts);
  for (std::size_t i = 0; i < charts.size(); ++i) {
    Frame2d& frame = frames[i];
    const double top = size.height * static_cast<double>(i);
    frame.corner = {left, top + kTopMargin};
    frame.width = width;
    frame.height = size.height - kTopMargin - BottomMargin(charts[i].x, width) - kGapBelow;
    svg.Text({left, top + 19.0}, charts[i].title, {.size = kTitleSize, .bold = true});
    DrawFrame(frame, &svg);
    DrawContents(charts[i], frame, &svg);
    DrawLegend(charts[i], {left + width + 14.0, frame.corner.y}, &svg);
  }
  return svg.Document();
}

std::string DrawColumns(const std::vector<std::vector<Chart>>& columns, const ChartSize& size) {
  std::size_t most = 0;
  for (const auto& charts : columns) most = std::max(most, charts.size());
  Svg svg(size.width * static_cast<double>(columns.size()),
          size.height * static_cast<double>(most));
  for (std::size_t i = 0; i < columns.size(); ++i)
    svg.Picture({size.width * static_cast<double>(i), 0.0}, DrawCharts(columns[i], size));
  return svg.Document();
}

}  // namespace brachium
