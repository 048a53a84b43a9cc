#include "io/elbow_hinge.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "problems/rotation.h"

namespace brachium {
namespace {

using Eigen::Matrix4d, Eigen::Quaterniond, Eigen::Vector3d, Eigen::Vector4d;

constexpr int kHeadings = 48;  // that are tried for each window
constexpr int kRounds = 3;     // of headings and carrying angle in turn

// Sums over a window of w w', where e = w·(cos heading, sin heading, 1, 0) and w_3 = 1.
Matrix4d SumsOf(const CarriedSensor& upper, const CarriedSensor& fore, std::size_t first,
                std::size_t window, std::ptrdiff_t lag) {
  const auto later = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(first) + lag);
  const Quaterniond level_U = upper.Level(first, window);
  const Quaterniond level_F = fore.Level(later, window);
  Matrix4d sums = Matrix4d::Zero();
  for (std::size_t k = 0; k < window; k += kHingeEvery) {
    const Vector3d z_U = level_U * (upper.q_0B(first + k) * Vector3d::UnitZ());
    const Vector3d y_F = level_F * (fore.q_0B(later + k) * Vector3d::UnitY());
    const Vector4d w(z_U.x() * y_F.x() + z_U.y() * y_F.y(), z_U.y() * y_F.x() - z_U.x() * y_F.y(),
                     z_U.z() * y_F.z(), 1.0);
    sums += w * w.transpose();
  }
  return sums;
}

Vector4d Deviation(double heading, double sine) {
  return {std::cos(heading), std::sin(heading), 1.0, -sine};
}

struct Direction {
  double heading, cosine, sine;
};

std::vector<Direction> Directions() {
  std::vector<Direction> directions;
  for (int i = 0; i < kHeadings; ++i) {
    const double heading = 2 * std::numbers::pi * i / kHeadings;
    directions.push_back({heading, std::cos(heading), std::sin(heading)});
  }
  return directions;
}

double BestHeading(const Matrix4d& sums, double sine) {
  static const std::vector<Direction> directions = Directions();
  // Σ e² but for what no heading changes, with c and s its cosine and sine.
  const double by_c = 2 * (sums(0, 2) - sine * sums(0, 3)),
               by_s = 2 * (sums(1, 2) - sine * sums(1, 3));
  const auto squares = [&](const Direction& d) {
    const double c = d.cosine, s = d.sine;
    return c * (c * sums(0, 0) + 2 * s * sums(0, 1) + by_c) + s * (s * sums(1, 1) + by_s);
  };
  const double heading = std::ranges::min_element(directions, {}, squares)->heading;
  const Vector4d v = Deviation(heading, sine);
  const Vector4d slope(-std::sin(heading), std::cos(heading), 0.0, 0.0);
  const double step = slope.dot(sums * v) / std::max(slope.dot(sums * slope), 1e-9);
  constexpr double kMost = std::numbers::pi / kHeadings;
  return heading - std::clamp(step, -kMost, kMost);
}

}  // namespace

CarriedSensor::CarriedSensor(const ElbowSensor& sensor, const Quaterniond& q_BS, double sign)
    : force_sum_{Vector3d::Zero()} {
  Quaterniond q_0S = Quaterniond::Identity();
  for (std::size_t k = 0; k < sensor.gyr_S.size(); ++k) {
    q_0B_.push_back(q_0S * q_BS.conjugate());
    force_sum_.push_back(force_sum_.back() + sign * (q_0S * sensor.acc_S[k]));
    if (k + 1 < sensor.gyr_S.size())
      q_0S = (q_0S * Exp<double>(0.5 * kElbowStep * (sensor.gyr_S[k] + sensor.gyr_S[k + 1])))
                 .normalized();
  }
}

Quaterniond CarriedSensor::Level(std::size_t first, std::size_t count) const {
  return RotationBetween(force_sum_[first + count] - force_sum_[first], Vector3d::UnitZ());
}

HingeFit FitHinge(const CarriedSensor& upper, const CarriedSensor& fore, const ArmModel& arm,
                  std::size_t window, std::ptrdiff_t lag) {
  const double side = Sign(arm.side), told = arm.elbow.carrying_angle;
  const double spread = 2.0 * arm.elbow.carrying_angle_sigma;
  const auto sine_of = [side](double carrying) { return -side * std::sin(carrying); };
  const auto [least, most] = std::minmax({sine_of(told - spread), sine_of(told + spread)});
  HingeFit fit;
  fit.sine = sine_of(told);
  std::vector<Matrix4d> sums;
  const auto begin = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, -lag));
  const auto after = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, lag));
  for (std::size_t first = begin; first + window + after <= upper.size(); first += kHingeStep) {
    fit.windows.push_back({first, 0.0});
    sums.push_back(SumsOf(upper, fore, first, window, lag));
  }
  if (sums.empty()) return fit;
  for (int round = 0; round < kRounds; ++round) {
    double sum = 0.0, squares = 0.0, count = 0.0;
    for (std::size_t i = 0; i < sums.size(); ++i) {
      fit.windows[i].heading = BestHeading(sums[i], fit.sine);
      const Vector4d v = Deviation(fit.windows[i].heading, fit.sine);
      squares += v.dot(sums[i] * v);
      sum += v.dot(sums[i].col(3));
      count += sums[i](3, 3);
    }
    fit.misfit = std::sqrt(squares / count);
    if (round + 1 < kRounds) fit.sine = std::clamp(fit.sine + sum / count, least, most);
  }
  return fit;
}

}  // namespace brachium
