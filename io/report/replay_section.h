// The part of the page that replays the arm, and its controls.
#pragma once

#include <string>

#include "io/report/reported.h"

namespace brachium {

// Nothing without an estimate. Shown by the page's script alone.
std::string ReplaySection(const Report& report);

}  // namespace brachium
