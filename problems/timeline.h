// The instants with unknowns: knots, and among them the nodes of the gyro biases.
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "problems/preintegration.h"

namespace brachium {

struct Timeline {
  std::vector<double> knots;  // [s], increasing, on cell edges of the first recording
  std::vector<int> nodes;     // indices of knots, the first and the last among them

  int Intervals() const { return static_cast<int>(knots.size()) - 1; }
  double NodeTime(int node) const {
    return knots[static_cast<std::size_t>(nodes[static_cast<std::size_t>(node)])];
  }

  // The node at or before a time, so that the time lies between it and the next one.
  int NodeBefore(double time) const;

  // Where a time lies between NodeBefore(time) and the next node, 0 to 1.
  double NodeFraction(double time) const;

  // The last knot at or before a time; the first where there is none.
  int KnotBefore(double time) const;

  int KnotNearest(double time) const;
};

// A part of a longer trial, whose recordings reach somewhat beyond it.
struct Stretch {
  // Its first knot, where the stretch before it ends; else all recordings' first common instant [s].
  std::optional<double> start;
  double end = HUGE_VAL;  // no knot is later [s]
  // By sensor, what its samples are summed about; empty: clocks that agree, biases as rests tell.
  std::vector<double> clock_offset;        // true time less its own [s]
  std::vector<Eigen::Vector3d> gyro_bias;  // [rad/s]

  double ClockOffset(std::size_t sensor) const {
    return clock_offset.empty() ? 0.0 : clock_offset[sensor];
  }
};

// Knots at least `knot_spacing` apart (0: at every cell edge) over the span that all recordings
// share, bias nodes at least `node_spacing` apart [s]. The span must not be empty.
Timeline MakeTimeline(const std::vector<Preintegrator>& recordings, double knot_spacing,
                      double node_spacing, const Stretch& stretch = {});

}  // namespace brachium
