#include "problems/timeline.h"

#include <algorithm>

namespace brachium {
namespace {

// A step that is shorter than the spacing by rounding alone counts as full.
constexpr double kRounding = 1e-6;

}  // namespace

int Timeline::NodeBefore(double time) const {
  int low = 0, high = static_cast<int>(nodes.size()) - 1;
  while (high - low > 1) {
    const int middle = (low + high) / 2;
    (NodeTime(middle) <= time ? low : high) = middle;
  }
  return low;
}

double Timeline::NodeFraction(double time) const {
  const int node = NodeBefore(time);
  const double begin = NodeTime(node), end = NodeTime(node + 1);
  return std::clamp((time - begin) / (end - begin), 0.0, 1.0);
}

int Timeline::KnotBefore(double time) const {
  const auto after = std::upper_bound(knots.begin(), knots.end(), time);
  return std::max(0, static_cast<int>(after - knots.begin()) - 1);
}

int Timeline::KnotNearest(double time) const {
  const int before = KnotBefore(time), after = std::min(before + 1, Intervals());
  const auto at = [&](int knot) { return knots[static_cast<std::size_t>(knot)]; };
  return at(after) - time < time - at(before) ? after : before;
}

Timeline MakeTimeline(const std::vector<Preintegrator>& recordings, double knot_spacing,
                      double node_spacing, const Stretch& stretch) {
  double begin = -HUGE_VAL, end = stretch.end;
  for (std::size_t i = 0; i < recordings.size(); ++i) {
    begin = std::max(begin, recordings[i].Begin() + stretch.ClockOffset(i));
    end = std::min(end, recordings[i].End() + stretch.ClockOffset(i));
  }
  begin = stretch.start.value_or(begin);
  Timeline timeline;
  timeline.knots.push_back(begin);
  const double step = std::max(knot_spacing, 0.0) * (1 - kRounding);
  const double least = 0.5 * recordings[0].Period();  // no sliver of an interval at the ends
  for (const double own : recordings[0].edges()) {
    const double edge = own + stretch.ClockOffset(0);
    if (edge > timeline.knots.back() + std::max(step, least) && edge < end - least)
      timeline.knots.push_back(edge);
  }
  timeline.knots.push_back(end);

  timeline.nodes.push_back(0);
  for (int knot = 1; knot < timeline.Intervals(); ++knot) {
    const double time = timeline.knots[static_cast<std::size_t>(knot)];
    const double node = timeline.NodeTime(static_cast<int>(timeline.nodes.size()) - 1);
    if (time - node >= node_spacing * (1 - kRounding) && end - time >= 0.5 * node_spacing)
      timeline.nodes.push_back(knot);
  }
  timeline.nodes.push_back(timeline.Intervals());
  return timeline;
}

}  // namespace brachium
