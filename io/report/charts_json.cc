#include "io/report/charts_json.h"

#include <algorithm>

#include "io/plot/envelope.h"
#include "io/report/packed.h"

namespace brachium {
namespace {

using Json = nlohmann::ordered_json;

// Finer than any chart shows, and as coarse as 16 bits ask for.
Json Values(const std::vector<double>& values) { return Packed(values, 1e-4); }

Json AxisJson(const Axis& axis) {
  Json json = {{"label", axis.label}};
  if (axis.logarithmic) json["logarithmic"] = true;
  return json;
}

// The place of an abscissa among those so far.
std::size_t Shared(const std::vector<double>& x, std::vector<std::vector<double>>* xs) {
  const auto found = std::find(xs->begin(), xs->end(), x);
  const auto place = static_cast<std::size_t>(found - xs->begin());
  if (found == xs->end()) xs->push_back(x);
  return place;
}

Json LineJson(const LineSeries& line, std::size_t most, std::vector<std::vector<double>>* xs) {
  const auto kept = EnvelopeOf(line.y, line.y, most);
  return {{"name", line.name},
          {"x", Shared(At(kept, line.x), xs)},
          {"y", Values(At(kept, line.y))},
          {"colour", line.stroke.colour},
          {"width", line.stroke.width},
          {"dashes", line.stroke.dashes}};
}

Json BandJson(const Band& band, std::size_t most, std::vector<std::vector<double>>* xs) {
  const auto kept = EnvelopeOf(band.low, band.high, most);
  return {{"name", band.name},
          {"x", Shared(At(kept, band.x), xs)},
          {"low", Values(At(kept, band.low))},
          {"high", Values(At(kept, band.high))},
          {"colour", band.fill.colour},
          {"opacity", band.fill.opacity}};
}

Json ChartJson(const Chart& chart, std::size_t most) {
  std::vector<std::vector<double>> xs;
  Json lines = Json::array(), bands = Json::array(), spans = Json::array();
  for (const LineSeries& line : chart.lines) lines.push_back(LineJson(line, most, &xs));
  for (const Band& band : chart.bands) bands.push_back(BandJson(band, most, &xs));
  for (const Span& span : chart.spans) spans.push_back({span.from, span.to});
  Json abscissae = Json::array();
  for (const auto& x : xs) abscissae.push_back(PackedTimes(x));
  return {{"title", chart.title},   {"x", AxisJson(chart.x)},
          {"y", AxisJson(chart.y)}, {"xs", abscissae},
          {"lines", lines},         {"bands", bands},
          {"spans", spans},         {"spans_name", chart.spans_name}};
}

}  // namespace

Json ChartsJson(const std::vector<Chart>& charts, std::size_t most) {
  Json json = Json::array();
  for (const Chart& chart : charts) json.push_back(ChartJson(chart, most));
  return json;
}

}  // namespace brachium
