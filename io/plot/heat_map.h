// Values over two axes by colour.
#pragma once

#include <Eigen/Core>
#include <string>

#include "io/plot/chart.h"

namespace brachium {

struct HeatMap {
  std::string title{};
  Axis x{}, y{};  // categories: a name per column and per row, the first row at the bottom
  Eigen::MatrixXd values{};   // one that the scale has no place for stays white
  std::string value_label{};  // beside the scale
  bool logarithmic = false;   // colours by the logarithm
};

// As one SVG document. Requires as many categories as columns and rows.
std::string DrawHeatMap(const HeatMap& map, const ChartSize& size = {});

}  // namespace brachium
