#include "io/plot/envelope.h"

#include <cmath>
#include <numeric>
#include <optional>
#include <set>

namespace brachium {
namespace {

using Indices = std::vector<std::size_t>;

// What of a run of samples stands out.
std::set<std::size_t> Outstanding(const std::vector<double>& low, const std::vector<double>& high,
                                  std::size_t begin, std::size_t end) {
  std::optional<std::size_t> least, greatest, unknown;
  for (std::size_t i = begin; i < end; ++i) {
    if (std::isnan(low[i]) || std::isnan(high[i])) {
      if (!unknown) unknown = i;
      continue;
    }
    if (!least || low[i] < low[*least]) least = i;
    if (!greatest || high[i] > high[*greatest]) greatest = i;
  }
  std::set<std::size_t> indices;
  for (const auto& index : {least, greatest, unknown})
    if (index) indices.insert(*index);
  return indices;
}

}  // namespace

Indices EnvelopeOf(const std::vector<double>& low, const std::vector<double>& high,
                   std::size_t most) {
  const std::size_t size = low.size();
  if (size <= most) {
    Indices all(size);
    std::iota(all.begin(), all.end(), std::size_t{0});
    return all;
  }
  const std::size_t runs = (most - 2) / 3;
  std::set<std::size_t> kept = {0, size - 1};
  for (std::size_t run = 0; run < runs; ++run)
    kept.merge(Outstanding(low, high, run * size / runs, (run + 1) * size / runs));
  return {kept.begin(), kept.end()};
}

std::vector<double> At(const Indices& indices, const std::vector<double>& values) {
  std::vector<double> chosen;
  chosen.reserve(indices.size());
  for (const std::size_t index : indices) chosen.push_back(values[index]);
  return chosen;
}

}  // namespace brachium
