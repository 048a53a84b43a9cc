#include "io/elbow_sensors.h"

#include <algorithm>

#include "problems/rotation.h"

namespace brachium {
namespace {

constexpr double kSmoothing = 0.06;  // half the width of the mean over the signals [s]

ElbowSensor OnGrid(const Recording& recording, const Eigen::Vector3d& elbow_B, double start,
                   std::size_t size) {
  ElbowSensor sensor;
  sensor.q_BS = recording.mounting->q_BS;
  sensor.elbow_S = recording.mounting->q_BS.conjugate() * (elbow_B - recording.mounting->p_BS_B);
  std::size_t first = 0;
  for (std::size_t k = 0; k < size; ++k) {
    const double t = start + kElbowStep * static_cast<double>(k);
    while (first + 1 < recording.size() && recording.time[first] < t - kSmoothing) ++first;
    Eigen::Vector3d gyr_S = recording.gyr_S[first], acc_S = recording.acc_S[first];
    double count = 1.0;
    for (std::size_t i = first + 1; i < recording.size() && recording.time[i] <= t + kSmoothing;
         ++i, count += 1.0) {
      gyr_S += recording.gyr_S[i];
      acc_S += recording.acc_S[i];
    }
    sensor.gyr_S.push_back(gyr_S / count);
    sensor.acc_S.push_back(acc_S / count);
  }
  return sensor;
}

}  // namespace

Eigen::Matrix3d ElbowSensor::Lever(std::size_t k) const {
  k = std::clamp<std::size_t>(k, 1, gyr_S.size() - 2);
  const Eigen::Matrix3d turning = Skew<double>(gyr_S[k]);
  return Skew<double>((gyr_S[k + 1] - gyr_S[k - 1]) / (2.0 * kElbowStep)) + turning * turning;
}

bool ShowsOnlyGravity(const Eigen::Vector3d& f_S) {
  return std::abs(f_S.norm() - kGravity) < 0.05 * kGravity;
}

const Recording* FindMounted(const Observations& observations, Segment segment) {
  for (const Recording& recording : observations.recordings)
    if (recording.segment == segment && recording.mounting) return &recording;
  return nullptr;
}

std::optional<ElbowSensors> FindElbowSensors(const Observations& observations, double shortest,
                                             double longest) {
  const Recording* const upper = FindMounted(observations, Segment::kUpperArm);
  const Recording* const fore = FindMounted(observations, Segment::kForearm);
  if (upper == nullptr || fore == nullptr) return std::nullopt;
  const double start = std::max(upper->time.front(), fore->time.front());
  const double end = std::min({upper->time.back(), fore->time.back(), start + longest});
  if (end - start < shortest) return std::nullopt;
  const auto size = static_cast<std::size_t>((end - start) / kElbowStep);
  const Eigen::Vector3d elbow_U = observations.arm.segments.at(Segment::kUpperArm).p_distal_B;
  return ElbowSensors{start, OnGrid(*upper, elbow_U, start, size),
                      OnGrid(*fore, Eigen::Vector3d::Zero(), start, size)};
}

}  // namespace brachium
