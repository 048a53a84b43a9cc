// Charts with two axes. What has a name enters the legend; what has no place on an axis (NaN, or not
// positive on a logarithmic one) is left out, and a line breaks there.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/plot/axis.h"
#include "io/plot/svg.h"

namespace brachium {

struct LineSeries {
  std::string name{};
  std::vector<double> x{}, y{};  // of one length, x not decreasing
  Stroke stroke{.width = 1.5};
};

// Between two lines.
struct Band {
  std::string name{};
  std::vector<double> x{}, low{}, high{};  // of one length
  Fill fill{.opacity = 0.2};
};

struct Dots {
  std::string name{};
  std::vector<double> x{}, y{};  // of one length
  Fill fill{.colour = "#000000", .opacity = 0.6};
  double radius = 2.0;  // [pixel]
};

// Whiskers from low to high, a box from lower to upper, a line across at the middle, and a dot.
struct Box {
  double place = 0.0;  // along x
  double low = 0.0, lower = 0.0, middle = 0.0, upper = 0.0, high = 0.0;
  std::optional<double> dot{};
};

struct BoxSeries {
  std::string name{};
  std::vector<Box> boxes{};
  std::string colour = "#000000";
  double width = 0.6;  // along x
};

// A straight line across the whole chart.
struct Rule {
  double value = 0.0;
  bool upright = false;  // at a value of x
  std::string label{};   // written at its end
  Stroke stroke{.colour = "#666666", .dashes = "4 3"};
};

// Drawn in the order of its members.
struct Chart {
  std::string title{};
  Axis x{}, y{};
  std::vector<Band> bands{};
  std::vector<BoxSeries> boxes{};
  std::vector<LineSeries> lines{};
  std::vector<Dots> dots{};
  std::vector<Rule> rules{};
};

struct ChartSize {
  double width = 860.0;
  double height = 320.0;  // of each chart
};

// Charts below one another, as wide as each other, as one SVG document.
std::string DrawCharts(const std::vector<Chart>& charts, const ChartSize& size = {});

// Several such columns beside one another, each as wide as `size` says.
std::string DrawColumns(const std::vector<std::vector<Chart>>& columns, const ChartSize& size);

}  // namespace brachium
