// What the page replays.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>

#include "io/report/reported.h"

namespace brachium {

// Every k-th sample of the estimate, no more than `most` of them; as arrays of numbers in base64,
// 16 bits each with their unit beside them, the least of them for unknown:
//   name, time (64-bit [s]), joints, bones [from, to, segment], segments, notes
//   estimate, reference  p {unit, data}: frame by joint by axis [m]; q: by segment, w first
//   deviation            joint and its standard deviations along the axes [m]
//   angles               name, value, sd, reference [deg]
// The estimate's angles are those of estimate.csv to 0.005 deg.
nlohmann::ordered_json ReplayJson(const ReportedEstimate& reported, std::size_t most);

}  // namespace brachium
