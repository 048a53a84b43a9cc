// The two sensors beside the elbow, made comparable.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <vector>

#include "problems/observations.h"

namespace brachium {

inline constexpr double kElbowStep = 0.02;  // of the common grid [s]

// One of them on the grid: each value is the mean of the samples within 0.06 s.
struct ElbowSensor {
  std::vector<Eigen::Vector3d> gyr_S, acc_S;
  Eigen::Vector3d elbow_S = Eigen::Vector3d::Zero();  // from the sensor to the elbow, as told [m]
  Eigen::Quaterniond q_BS = Eigen::Quaterniond::Identity();  // of its mounting, as told

  // K of the specific force f_S = acc + K r that a point at r_S from the sensor feels,
  //   K = [α]x + [ω]x²,   α = dω_S/dt. At the ends of the grid, K of the neighbour.
  Eigen::Matrix3d Lever(std::size_t k) const;
};

struct ElbowSensors {
  double start = 0.0;  // of the grid [s]
  ElbowSensor upper, fore;

  std::size_t size() const { return upper.gyr_S.size(); }
};

// Whether a specific force is as long as gravity, to 5 %.
bool ShowsOnlyGravity(const Eigen::Vector3d& f_S);

// The recording of a segment whose mounting is known, or nullptr.
const Recording* FindMounted(const Observations& observations, Segment segment);

// Over what both recordings cover, `longest` seconds at most; nothing where one of them or its
// mounting is missing, or where that is less than `shortest`.
std::optional<ElbowSensors> FindElbowSensors(const Observations& observations, double shortest,
                                             double longest);

}  // namespace brachium
