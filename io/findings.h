// What a reader did beyond reading, one sentence each. Files are named as trial.json names them.
#pragma once

#include <string>
#include <vector>

namespace brachium {

struct Findings {
  std::vector<std::string> defaults;  // what nobody said, and the value taken for it
  std::vector<std::string> repairs;   // what was wrong and could be mended
  std::vector<std::string> warnings;  // what looks wrong and was left as it is
};

}  // namespace brachium
