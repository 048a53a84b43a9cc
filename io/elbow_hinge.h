// What an elbow can do, of the two sensors beside it: flexion and pronation, and a carrying angle that
// stays.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

#include "io/elbow_sensors.h"
#include "problems/arm_model.h"

namespace brachium {

// A sensor carried over the grid by its own gyroscope, worn as `q_BS` says; `sign` times its
// accelerometer is what it felt.
class CarriedSensor {
 public:
  CarriedSensor(const ElbowSensor& sensor, const Eigen::Quaterniond& q_BS, double sign = 1.0);

  std::size_t size() const { return q_0B_.size(); }

  // From the axes of instant 0 to level ones, z along the mean specific force over `count` instants
  // from `first` on. A velocity stays bounded, so that this is up but for a degree or two over 6 s.
  Eigen::Quaterniond Level(std::size_t first, std::size_t count) const;

  // The segment in the axes of instant 0.
  const Eigen::Quaterniond& q_0B(std::size_t k) const { return q_0B_[k]; }

 private:
  std::vector<Eigen::Quaterniond> q_0B_;
  std::vector<Eigen::Vector3d> force_sum_;  // over the instants before k, axes of instant 0
};

inline constexpr std::size_t kHingeStep = 150;  // instants from one window to the next: 3 s
inline constexpr std::size_t kHingeEvery = 5;   // instants from one that is looked at to the next

// One window: where it begins, and the heading of the forearm's level axes in the upper arm's that
// fits it best [rad].
struct HingeWindow {
  std::size_t first = 0;
  double heading = 0.0;
};

// With z_U the flexion axis and y_F the forearm's long one, e = z_U·y_F is -s sin(carrying angle),
// whatever flexion and pronation (elbow_adduction.h).
struct HingeFit {
  double sine = 0.0;    // e at the carrying angle that fits best, two sds from the told one at most
  double misfit = 0.0;  // rms of e - sine over all windows
  std::vector<HingeWindow> windows;
};

// Over windows of `window` instants, the forearm read `lag` instants later than the upper arm. Each
// window has a heading of its own, which takes up what gyroscopes drift. No windows where the two
// overlap by less than one.
HingeFit FitHinge(const CarriedSensor& upper, const CarriedSensor& fore, const ArmModel& arm,
                  std::size_t window, std::ptrdiff_t lag = 0);

}  // namespace brachium
