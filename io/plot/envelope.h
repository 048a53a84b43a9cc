// Which samples of a long series to draw so that nothing that stands out is lost.
#pragma once

#include <cstddef>
#include <vector>

namespace brachium {

// Of two series of one length, low <= high (the same twice for a line): all indices up to `most` of
// them, else in each of equal runs that of the least `low`, that of the greatest `high`, and the
// first at which either is NaN, so that peaks and gaps stay. Rising; the first and the last are
// among them. Requires most >= 6.
std::vector<std::size_t> EnvelopeOf(const std::vector<double>& low, const std::vector<double>& high,
                                    std::size_t most);

// The values at these indices.
std::vector<double> At(const std::vector<std::size_t>& indices, const std::vector<double>& values);

}  // namespace brachium
