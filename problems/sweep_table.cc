#include "problems/sweep_table.h"

namespace brachium {

std::vector<std::size_t> PointsAlong(const SweptMethod& method, std::size_t option,
                                     std::size_t base) {
  std::vector<std::size_t> along;
  std::vector<std::string> wanted = method.points[base];
  for (std::size_t p = 0; p < method.points.size(); ++p) {
    wanted[option] = method.points[p][option];
    if (method.points[p] == wanted) along.push_back(p);
  }
  return along;
}

}  // namespace brachium
