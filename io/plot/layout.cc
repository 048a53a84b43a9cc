#include "io/plot/layout.h"

#include <algorithm>
#include <cmath>

namespace brachium {
namespace {

constexpr double kLetter = 6.8;      // mean width of one [pixel]
constexpr double kTickLength = 4.0;  // [pixel]
constexpr double kPixelsPerTickX = 80.0, kPixelsPerTickY = 45.0;
constexpr double kTurn = 30.0;  // of category names too long to stand side by side [deg]
constexpr double kSine = 0.5, kCosine = 0.866;  // of that

const Stroke kGrid{.colour = "#e4e4e4"};
const Stroke kInk{.colour = "#444444"};

double LongestName(const Axis& axis) {
  double longest = 0.0;
  for (const std::string& name : axis.categories) longest = std::max(longest, TextWidth(name));
  return longest;
}

bool NamesTurned(const Axis& axis, double width) {
  return LongestName(axis) * static_cast<double>(axis.categories.size()) > 0.9 * width;
}

bool HasGridLine(const Axis& axis, const Tick& tick) {
  return axis.categories.empty() && !tick.label.empty();
}

std::vector<Tick> HorizontalTicks(const Frame2d& frame) {
  return TicksOf(frame.x_axis, frame.x_range,
                 std::max(2, static_cast<int>(frame.width / kPixelsPerTickX)));
}

std::vector<Tick> VerticalTicks(const Axis& axis, const Range& range, double height) {
  return TicksOf(axis, range, std::max(2, static_cast<int>(height / kPixelsPerTickY)));
}

void DrawHorizontalAxis(const Frame2d& frame, Svg* svg) {
  const double bottom = frame.corner.y + frame.height;
  const bool turned = NamesTurned(frame.x_axis, frame.width);
  for (const Tick& tick : HorizontalTicks(frame)) {
    const double x = frame.At(tick.value, frame.y_range.low).x;
    if (HasGridLine(frame.x_axis, tick)) svg->Line({x, frame.corner.y}, {x, bottom}, kGrid);
    svg->Line({x, bottom}, {x, bottom + kTickLength}, kInk);
    svg->Text({x, bottom + 17.0}, tick.label,
              {.anchor = turned ? TextStyle::Anchor::kEnd : TextStyle::Anchor::kMiddle,
               .size = kTextSize,
               .turned_deg = turned ? -kTurn : 0.0});
  }
  svg->Text(
      {frame.corner.x + frame.width / 2.0, bottom + BottomMargin(frame.x_axis, frame.width) - 8.0},
      frame.x_axis.label, {.anchor = TextStyle::Anchor::kMiddle, .size = kTextSize});
}

void DrawVerticalAxis(const Frame2d& frame, Svg* svg) {
  const double left = frame.corner.x;
  for (const Tick& tick : VerticalTicks(frame.y_axis, frame.y_range, frame.height)) {
    const double y = frame.At(frame.x_range.low, tick.value).y;
    if (HasGridLine(frame.y_axis, tick)) svg->Line({left, y}, {left + frame.width, y}, kGrid);
    svg->Line({left - kTickLength, y}, {left, y}, kInk);
    svg->Text({left - 7.0, y + 4.0}, tick.label,
              {.anchor = TextStyle::Anchor::kEnd, .size = kTextSize});
  }
  svg->Text(
      {left - LeftMargin(frame.y_axis, frame.y_range) + 14.0, frame.corner.y + frame.height / 2.0},
      frame.y_axis.label,
      {.anchor = TextStyle::Anchor::kMiddle, .size = kTextSize, .turned_deg = -90.0});
}

}  // namespace

double TextWidth(const std::string& text) {
  const auto letters = std::count_if(text.begin(), text.end(), [](char letter) {
    return (static_cast<unsigned char>(letter) & 0xc0u) != 0x80u;  // not the rest of a letter
  });
  return kLetter * static_cast<double>(letters);
}

Pixel Frame2d::At(double x, double y) const {
  return {corner.x + width * Fraction(x_axis, x_range, x),
          corner.y + height * (1.0 - Fraction(y_axis, y_range, y))};
}

double LeftMargin(const Axis& axis, const Range& range) {
  double widest = 0.0;
  for (const Tick& tick : VerticalTicks(axis, range, 300.0))
    widest = std::max(widest, TextWidth(tick.label));
  return widest + (axis.label.empty() ? 16.0 : 34.0);
}

double BottomMargin(const Axis& axis, double width) {
  const double names = NamesTurned(axis, width) ? kSine * LongestName(axis) : 0.0;
  return 24.0 + names + (axis.label.empty() ? 0.0 : 20.0);
}

double LeftOfNames(const Axis& axis, double width) {
  if (!NamesTurned(axis, width)) return 0.0;
  const double slot = width / static_cast<double>(axis.categories.size());
  double reach = 0.0, place = slot / 2.0;
  for (const std::string& name : axis.categories) {
    reach = std::max(reach, kCosine * TextWidth(name) - place);
    place += slot;
  }
  return reach;
}

void DrawFrame(const Frame2d& frame, Svg* svg) {
  DrawHorizontalAxis(frame, svg);
  DrawVerticalAxis(frame, svg);
  svg->Rectangle(frame.corner, frame.width, frame.height, {}, kInk);
}

}  // namespace brachium
