// Long series in few bytes, for scripts to unpack.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace brachium {

// unit, offset, data: whole numbers of 16 bits in base64, the least of them for what is not finite;
// a value is offset + unit * number. The unit is `finest`, or as coarse as the spread of the values
// asks for: then half of it is the greatest error.
nlohmann::ordered_json Packed(const std::vector<double>& values, double finest);

// Doubles in base64, the first byte the least.
std::string PackedExactly(const std::vector<double>& values);

// Rising times: the same in 32 bits, the offset the first of them, the unit 10 µs or the 2^31st part
// of their span.
nlohmann::ordered_json PackedTimes(const std::vector<double>& time);

}  // namespace brachium
