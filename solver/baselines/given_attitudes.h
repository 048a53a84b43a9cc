// The attitudes that the trackers of Bai et al. (2015) take as given. Theirs were the sensor maker's,
// by a filter inside; here the maker's where every recording carries them (columns q_*), else those of
// the 2005 filter (inclination_filter.h).
#pragma once

#include <string>

#include "solver/baselines/luinge.h"

namespace brachium {

// An estimate of attitudes, on the first recording's clock, with the note whose they are. The
// maker's worlds are taken to be one, with z up. Requires IsWholeChain().
Estimate GivenAttitudes(const std::string& method, const Observations& observations,
                        const LuingeUnconstrainedOptions& options);

}  // namespace brachium
