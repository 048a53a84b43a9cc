#include "problems/state.h"

namespace brachium {
namespace {

// Constants of a sensor or of its segment, three numbers each, in the order of UnknownKind.
constexpr int kConstantsPerSensor = 5;

}  // namespace

State::State(const StateSize& size) : size_(size) {
  const std::size_t sensors = U(size.sensors);
  knot_stride_ = 10 * sensors + 3 * U(size.roots) + 1;
  nodes_begin_ = knot_stride_ * U(size.knots);
  constants_begin_ = nodes_begin_ + 3 * sensors * U(size.nodes);
  x_.assign(constants_begin_ + 3 * kConstantsPerSensor * sensors + 5, 0.0);
  for (int knot = 0; knot < size.knots; ++knot)
    for (int sensor = 0; sensor < size.sensors; ++sensor) Attitude(knot, sensor)[3] = 1.0;
}

double* State::Constant(UnknownKind kind, int sensor) {
  const std::size_t end_of_sensors = constants_begin_ + 3 * kConstantsPerSensor * U(size_.sensors);
  if (kind == UnknownKind::kShoulderMean) return &x_[end_of_sensors];
  if (kind == UnknownKind::kCarryingAngle) return &x_[end_of_sensors + 3];
  const int place = static_cast<int>(kind) - static_cast<int>(UnknownKind::kGyroScale);
  return &x_[constants_begin_ + 3 * (kConstantsPerSensor * U(sensor) + U(place))];
}

}  // namespace brachium
