// Numbers and names as messages and files spell them, whatever the locale.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace brachium {

// The shortest text that reads back as the same double: 0.1, not 0.10000000000000001.
std::string Shortest(double value);

// With that many digits after the point, for messages.
std::string Fixed(double value, int digits);

// The name that takes the fewest edits to reach, or an empty view when none is near.
std::string_view NearestName(std::string_view name, std::span<const std::string_view> known);

// "; did you mean 'length_m'?", or nothing when no known name is near.
std::string DidYouMean(std::string_view name, std::span<const std::string_view> known);

// "a, b, c"
std::string Listed(std::span<const std::string_view> names);

}  // namespace brachium
