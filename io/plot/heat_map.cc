#include "io/plot/heat_map.h"

#include <array>
#include <charconv>

#include "io/plot/layout.h"
#include "io/plot/palette.h"

namespace brachium {
namespace {

constexpr double kTopMargin = 30.0, kBarWidth = 16.0, kBarMargin = 86.0;  // [pixel]
constexpr double kLeastWritten = 36.0;  // width of a cell that its value is written into [pixel]
constexpr int kBarSteps = 64;
constexpr double kLight = 0.6;  // of the scale: dark text from here

// Three figures.
std::string Brief(double value) {
  std::array<char, 32> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 3)
          .ptr;
  return std::string(text.data(), end);
}

struct ValueScale {
  Axis axis;
  Range range;
};

ValueScale ScaleOf(const HeatMap& map) {
  ValueScale scale{.axis = {.label = map.value_label, .logarithmic = map.logarithmic}, .range = {}};
  const auto flat = map.values.reshaped();
  scale.range = RangeOf(scale.axis, {flat.begin(), flat.end()});
  return scale;
}

void DrawCells(const HeatMap& map, const ValueScale& scale, const Frame2d& frame, Svg* svg) {
  for (Eigen::Index row = 0; row < map.values.rows(); ++row)
    for (Eigen::Index column = 0; column < map.values.cols(); ++column) {
      const double value = map.values(row, column);
      if (!Shown(scale.axis, value)) continue;
      const auto x = static_cast<double>(column), y = static_cast<double>(row);
      const Pixel corner = frame.At(x - 0.5, y + 0.5), opposite = frame.At(x + 0.5, y - 0.5);
      const double fraction = Fraction(scale.axis, scale.range, value);
      svg->Rectangle(corner, opposite.x - corner.x, opposite.y - corner.y,
                     {.colour = ScaleColour(fraction)}, {.colour = "#ffffff", .width = 0.5});
      if (opposite.x - corner.x < kLeastWritten) continue;
      svg->Text({(corner.x + opposite.x) / 2.0, (corner.y + opposite.y) / 2.0 + 4.0}, Brief(value),
                {.anchor = TextStyle::Anchor::kMiddle,
                 .size = kTextSize,
                 .colour = fraction < kLight ? "#ffffff" : "#222222"});
    }
}

void DrawScale(const ValueScale& scale, const Frame2d& frame, Svg* svg) {
  const double left = frame.corner.x + frame.width + 14.0, step = frame.height / kBarSteps;
  for (int i = 0; i < kBarSteps; ++i)
    svg->Rectangle({left, frame.corner.y + frame.height - (i + 1) * step}, kBarWidth, step + 0.5,
                   {.colour = ScaleColour((i + 0.5) / kBarSteps)}, {.width = 0.0});
  for (const Tick& tick : TicksOf(scale.axis, scale.range, 6)) {
    const double fraction = Fraction(scale.axis, scale.range, tick.value);
    svg->Text({left + kBarWidth + 5.0, frame.corner.y + frame.height * (1.0 - fraction) + 4.0},
              tick.label, {.size = kTextSize});
  }
  svg->Text({left + kBarMargin - 20.0, frame.corner.y + frame.height / 2.0}, scale.axis.label,
            {.anchor = TextStyle::Anchor::kMiddle, .size = kTextSize, .turned_deg = -90.0});
}

Range CellsOf(Eigen::Index count) { return {-0.5, static_cast<double>(count) - 0.5}; }

}  // namespace

std::string DrawHeatMap(const HeatMap& map, const ChartSize& size) {
  Svg svg(size.width, size.height);
  Frame2d frame{.x_axis = map.x,
                .y_axis = map.y,
                .x_range = CellsOf(map.values.cols()),
                .y_range = CellsOf(map.values.rows())};
  const double left = LeftMargin(map.y, frame.y_range);
  frame.corner = {left, kTopMargin};
  frame.width = size.width - left - kBarMargin;
  frame.height = size.height - kTopMargin - BottomMargin(map.x, frame.width);
  const ValueScale scale = ScaleOf(map);
  svg.Text({left, 19.0}, map.title, {.size = kTitleSize, .bold = true});
  DrawCells(map, scale, frame, &svg);
  DrawFrame(frame, &svg);
  DrawScale(scale, frame, &svg);
  return svg.Document();
}

}  // namespace brachium
