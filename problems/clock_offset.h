// How a reference's clock stands against the recordings'.
#pragma once

#include <optional>

#include "problems/estimate.h"
#include "problems/trial.h"

namespace brachium {

// Reference time = recording time + seconds.
struct ClockOffset {
  enum class Source {
    kGiven,      // with the reference
    kEstimated,  // from the two motions
    kUnknown,    // neither: the motions do not tell, and 0 is taken
  };
  double seconds = 0.0;
  Source source = Source::kUnknown;
  std::optional<double> correlation;  // of the two speeds at that offset, where estimated
};

// The given offset, or the one within ±0.2 s at which the speeds of estimate and reference
// correlate best: angular speeds of all segments, or horizontal speeds of all points where the
// reference knows no rotation. Speeds are means over about 0.1 s, never across a gap; they depend
// on no alignment and little on drift. Unknown when the best correlation is below 0.5 or lies at
// the range's end.
ClockOffset ClockOffsetOf(const Estimate& estimate, const Reference& reference);

}  // namespace brachium
