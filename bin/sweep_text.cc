#include "bin/sweep_text.h"

#include "io/text.h"

namespace brachium {

std::string DurationText(double seconds) {
  if (seconds < 120.0) return Fixed(seconds, seconds < 10.0 ? 1 : 0) + " s";
  if (seconds < 7200.0) return Fixed(seconds / 60.0, 0) + " min";
  return Fixed(seconds / 3600.0, 1) + " h";
}

std::string ArraySpecification(const std::vector<std::size_t>& numbers) {
  std::string text;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t last = i;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    if (!text.empty()) text += ',';
    text += std::to_string(numbers[i]);
    if (last > i) text.append("-").append(std::to_string(numbers[last]));
    i = last + 1;
  }
  return text;
}

}  // namespace brachium
