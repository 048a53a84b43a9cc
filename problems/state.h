// The unknowns of a trial: values only, in one piece of memory, addressed by knot, node and sensor.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

namespace brachium {

// What an unknown is; its block holds 4 numbers for an attitude, 2 for the carrying angle, 1 for a
// deviation, a clock and a height, else 3.
enum class UnknownKind {
  kAttitude,        // q_WC of a segment, were its sensor mounted as told [x y z w]
  kRoot,            // root joint of the arm, or of the thorax, in W [m]
  kVelocity,        // of a sensor in W [m/s]
  kPlace,           // of a sensor in W [m]
  kSkin,            // what skin adds to a sensor's mounting at the moment, segment axes [rad]
  kAdduction,       // slow deviation of the elbow from its carrying angle [rad]
  kGyroBias,        // at a node, sensor axes [rad/s]
  kGyroScale,       // per sensor axis [1]
  kAccelBias,       // sensor axes [m/s²]
  kAccelScale,      // per sensor axis [1]
  kSensorPosition,  // p_BS, segment axes [m]
  kJointVector,     // proximal to distal joint, segment axes [m]
  kMounting,        // of a sensor: its turn against how it was told to sit, segment axes [rad]
  kClockOffset,     // of a sensor: true time less its own [s]
  kShoulderMean,    // mean of the root joint, W [m]
  kCarryingAngle,   // k0, k1 [rad]
  kContactPlace,    // where a point of the arm touches, W [m]
  kContactHeight,   // its z alone [m]
};

// Sizes: sensors (one a segment, proximal to distal), roots (free translations), knots, bias nodes,
// contacts.
struct StateSize {
  int sensors = 0, roots = 0, knots = 0, nodes = 0, contacts = 0;
};

class State {
 public:
  State() = default;
  explicit State(const StateSize& size);

  const StateSize& size() const { return size_; }

  double* Attitude(int knot, int sensor) { return &x_[KnotOffset(knot) + 4 * U(sensor)]; }
  double* Root(int knot, int root) {
    return &x_[KnotOffset(knot) + 4 * U(size_.sensors) + 3 * U(root)];
  }
  double* Velocity(int knot, int sensor) {
    return &x_[KnotOffset(knot) + 4 * U(size_.sensors) + 3 * U(size_.roots) + 3 * U(sensor)];
  }
  double* Place(int knot, int sensor) { return Velocity(knot, size_.sensors) + 3 * U(sensor); }
  double* Skin(int knot, int sensor) { return Place(knot, size_.sensors) + 3 * U(sensor); }
  double* Adduction(int knot) { return &x_[KnotOffset(knot + 1) - 1]; }
  double* GyroBias(int node, int sensor) {
    return &x_[nodes_begin_ + 3 * (U(node) * U(size_.sensors) + U(sensor))];
  }
  double* Constant(UnknownKind kind, int sensor);  // or contact

  const double* Attitude(int knot, int sensor) const { return Mutable().Attitude(knot, sensor); }
  const double* Root(int knot, int root) const { return Mutable().Root(knot, root); }
  const double* Velocity(int knot, int sensor) const { return Mutable().Velocity(knot, sensor); }
  const double* Place(int knot, int sensor) const { return Mutable().Place(knot, sensor); }
  const double* Skin(int knot, int sensor) const { return Mutable().Skin(knot, sensor); }
  const double* GyroBias(int node, int sensor) const { return Mutable().GyroBias(node, sensor); }
  const double* Constant(UnknownKind kind, int sensor) const {
    return Mutable().Constant(kind, sensor);
  }

 private:
  static std::size_t U(int i) { return static_cast<std::size_t>(i); }
  std::size_t KnotOffset(int knot) const { return U(knot) * knot_stride_; }
  State& Mutable() const { return const_cast<State&>(*this); }

  StateSize size_;
  std::size_t knot_stride_ = 0, nodes_begin_ = 0, constants_begin_ = 0;
  std::vector<double> x_;
};

}  // namespace brachium
