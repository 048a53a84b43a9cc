#include "problems/state.h"

namespace brachium {
namespace {

// Numbers of the constants of a sensor and of its segment, in the order of UnknownKind: three each,
// and the clock's one, which is the last.
constexpr std::size_t kNumbersPerSensor = 3 * 6 + 1;

}  // namespace

State::State(const StateSize& size) : size_(size) {
  const std::size_t sensors = U(size.sensors);
  knot_stride_ = 13 * sensors + 3 * U(size.roots) + 1;
  nodes_begin_ = knot_stride_ * U(size.knots);
  constants_begin_ = nodes_begin_ + 3 * sensors * U(size.nodes);
  x_.assign(constants_begin_ + kNumbersPerSensor * sensors + 5 + 3 * U(size.contacts), 0.0);
  for (int knot = 0; knot < size.knots; ++knot)
    for (int sensor = 0; sensor < size.sensors; ++sensor) Attitude(knot, sensor)[3] = 1.0;
}

double* State::Constant(UnknownKind kind, int sensor) {
  const std::size_t end_of_sensors = constants_begin_ + kNumbersPerSensor * U(size_.sensors);
  if (kind == UnknownKind::kShoulderMean) return &x_[end_of_sensors];
  if (kind == UnknownKind::kCarryingAngle) return &x_[end_of_sensors + 3];
  if (kind == UnknownKind::kContactPlace || kind == UnknownKind::kContactHeight)
    return &x_[end_of_sensors + 5 + 3 * U(sensor)];
  const int place = static_cast<int>(kind) - static_cast<int>(UnknownKind::kGyroScale);
  return &x_[constants_begin_ + kNumbersPerSensor * U(sensor) + 3 * U(place)];
}

}  // namespace brachium
