// Charts as data that the page draws live.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <vector>

#include "io/plot/chart.h"

namespace brachium {

// Per chart: title, x and y (label, logarithmic), xs (abscissae, shared by index), lines (name, x, y,
// colour, width, dashes), bands (name, x, low, high, colour, opacity), spans and their name. No more
// than `most` samples of a series, those that stand out among them (plot/envelope.h); times and values
// packed (packed.h). Boxes, dots and rules are left out.
nlohmann::ordered_json ChartsJson(const std::vector<Chart>& charts, std::size_t most);

}  // namespace brachium
