// Words that the commands of a sweep share.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace brachium {

// "45 s", "12 min", "3.5 h"
std::string DurationText(double seconds);

// Numbers in increasing order as Slurm's --array takes them: "0-3,7". Empty for none.
std::string ArraySpecification(const std::vector<std::size_t>& numbers);

}  // namespace brachium
