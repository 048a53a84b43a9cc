// Where the parts of a chart stand in its picture.
#pragma once

#include <string>
#include <vector>

#include "io/plot/axis.h"
#include "io/plot/svg.h"

namespace brachium {

inline constexpr double kTextSize = 12.0;   // [pixel]
inline constexpr double kTitleSize = 14.0;  // [pixel]

// About how wide a text is drawn [pixel]; what a reader's fonts make of it is not known.
double TextWidth(const std::string& text);

// Two axes fitted into a frame in the picture.
struct Frame2d {
  Axis x_axis{}, y_axis{};
  Range x_range{}, y_range{};
  Pixel corner{};  // the upper left one
  double width = 0.0, height = 0.0;

  Pixel At(double x, double y) const;
};

// Room for the ticks of the y axis and its label, to the left of a frame [pixel].
double LeftMargin(const Axis& axis, const Range& range);

// Room for the ticks of the x axis and its label, below a frame of that width [pixel].
double BottomMargin(const Axis& axis, double width);

// How far names of categories reach out to the left of a frame of that width [pixel].
double LeftOfNames(const Axis& axis, double width);

// The frame with its grid, ticks and labels.
void DrawFrame(const Frame2d& frame, Svg* svg);

}  // namespace brachium
