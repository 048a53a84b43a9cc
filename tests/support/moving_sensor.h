// Sensors whose motion is known in closed form, and the recordings they make.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

#include "problems/imu.h"
#include "problems/preintegration.h"
#include "problems/rotation.h"
#include "problems/simulation/rigid_motion.h"

namespace brachium {

// One instant of a sensor: its pose, and what an ideal one would read.
struct SensorInstant {
  Eigen::Quaterniond q_WS = Eigen::Quaterniond::Identity();
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero(), v_W = Eigen::Vector3d::Zero();
  Eigen::Vector3d gyr_S = Eigen::Vector3d::Zero(), acc_S = Eigen::Vector3d::Zero();
};

using MovingSensor = std::function<SensorInstant(double)>;
using MovingBody = std::function<BodyMotion(double)>;

inline const Eigen::Vector3d kGravity_W(0.0, 0.0, -kGravity);

inline Moving Sine(double amplitude, double angular_frequency, double phase, double t) {
  const double angle = angular_frequency * t + phase;
  return {amplitude * std::sin(angle), amplitude * angular_frequency * std::cos(angle),
          -amplitude * angular_frequency * angular_frequency * std::sin(angle)};
}

// A segment that turns about all axes at up to about 4 rad/s, its joint swaying by some cm.
inline BodyMotion SwayingBody(double t, double phase) {
  using Eigen::Vector3d;
  return {About(Vector3d::UnitZ(), Sine(1.2, 1.3, phase, t)) *
              About(Vector3d::UnitX(), Sine(0.8, 2.1, 2 * phase + 0.4, t)) *
              About(Vector3d::UnitY(), Sine(0.6, 3.4, 1.1 - phase, t)),
          PointOf(Sine(0.05, 2.0, phase, t), Sine(0.04, 3.0, 1.0, t), Sine(0.03, 4.0, 2.0, t))};
}

inline SensorInstant SensorOn(const BodyMotion& body, const Mounting& mounting) {
  const MovingPoint point = PointOn(body, {.p = mounting.p_BS_B});
  const Eigen::Quaterniond q_WS = body.turning.q_AB * mounting.q_BS;
  return {q_WS, point.p, point.v, mounting.q_BS.conjugate() * body.turning.omega_AB_B,
          q_WS.conjugate() * (point.a - kGravity_W)};
}

inline MovingSensor SwayingSensor(double phase) {
  return [phase](double t) { return SensorOn(SwayingBody(t, phase), {}); };
}

// Samples that are the means over their cells, by five-point Gauss-Legendre quadrature.
inline Recording Recorded(const MovingSensor& sensor, const std::vector<double>& time) {
  constexpr std::array<std::array<double, 2>, 5> kNodes = {
      {{0.0, 128.0 / 225},
       {0.5384693101056831, 0.4786286704993665},
       {-0.5384693101056831, 0.4786286704993665},
       {0.9061798459386640, 0.2369268850561891},
       {-0.9061798459386640, 0.2369268850561891}}};
  Recording recording;
  recording.time = time;
  const double period = SamplingPeriod(recording);
  for (std::size_t i = 0; i < time.size(); ++i) {
    const double begin = i == 0 ? time[0] - period / 2 : (time[i - 1] + time[i]) / 2;
    const double end = i + 1 == time.size() ? time[i] + period / 2 : (time[i] + time[i + 1]) / 2;
    Eigen::Vector3d gyr = Eigen::Vector3d::Zero(), acc = Eigen::Vector3d::Zero();
    for (const auto& [place, weight] : kNodes) {
      const SensorInstant truth = sensor((begin + end) / 2 + place * (end - begin) / 2);
      gyr += weight / 2 * truth.gyr_S;
      acc += weight / 2 * truth.acc_S;
    }
    recording.gyr_S.push_back(gyr);
    recording.acc_S.push_back(acc);
  }
  return recording;
}

// A packet that never arrived.
inline void Lose(Recording& recording, std::size_t first, std::size_t count = 1) {
  const auto erase = [&](auto& samples) {
    const auto begin = samples.begin() + static_cast<std::ptrdiff_t>(first);
    samples.erase(begin, begin + static_cast<std::ptrdiff_t>(count));
  };
  erase(recording.time);
  erase(recording.gyr_S);
  erase(recording.acc_S);
}

// How far a sum is from the motion that was really made: attitude [rad], velocity [m/s], place [m].
struct SumErrors {
  double attitude, velocity, place;
};

inline SumErrors ErrorsOf(const Preintegrated& sum, const MovingSensor& sensor, double start) {
  const SensorInstant a = sensor(start), b = sensor(start + sum.duration);
  const double D = sum.duration;
  const Eigen::Quaterniond q_SW = a.q_WS.conjugate();
  return {Log<double>(sum.dq.conjugate() * q_SW * b.q_WS).norm(),
          (q_SW * (b.v_W - a.v_W - kGravity_W * D) - sum.dv).norm(),
          (q_SW * (b.p_W - a.p_W - a.v_W * D - kGravity_W * D * D / 2) - sum.dp).norm()};
}

}  // namespace brachium
