// What the build puts into the program for the page of a report.
#pragma once

#include <string_view>

namespace brachium {

// Of uPlot nothing where the build had none: charts are then pictures.
struct PageFiles {
  std::string_view style{}, packed{}, charts{}, scene{}, replay{};
  std::string_view plot_style{}, plot_script{}, plot_licence{};
};

// Made from io/report and uPlot by embed.cmake.
PageFiles EmbeddedPageFiles();

}  // namespace brachium
