// Colours that people with any kind of colour vision tell apart.
#pragma once

#include <cstddef>
#include <string>

namespace brachium {

// The i-th of eight, from the first again after the last. Okabe & Ito, Color Universal Design
// (2008), black last.
std::string SeriesColour(std::size_t i);

// Dashes that go with it from the second round on, "" in the first.
std::string SeriesDashes(std::size_t i);

// From dark (0) to light (1), of even steps in lightness. Viridis of Smith & van der Walt (2015), at
// five of its colours, linear between.
std::string ScaleColour(double fraction);

}  // namespace brachium
