// Movement outcomes as JSON, in deg, m and s.
#pragma once

#include <nlohmann/json.hpp>

#include "problems/movement_outcomes.h"

namespace brachium {

//   movement  what was looked at ("wrist", "forearm"), its epochs and medians over them
//   ranges    by joint angle: least, greatest, range (1 % and 99 % quantiles)
//   compensation  shoulder_range_m, trunk_tilt_deg
// Absent outcomes are null.
nlohmann::ordered_json ToJson(const MovementOutcomes& outcomes);

}  // namespace brachium
