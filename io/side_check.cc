#include "io/side_check.h"

#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/elbow_sensors.h"
#include "io/text.h"
#include "problems/statistics.h"

namespace brachium {
namespace {

using Eigen::Vector3d;

constexpr double kLeastFlexion = -10 * kDegree, kMostFlexion = 160 * kDegree;
constexpr double kUpright = 0.5;    // of gravity in the plane of bending, to tell the flexion
constexpr double kBent = 0.5;       // of gravity across the forearm, to tell its pronation
constexpr double kLeastTime = 1.5;  // [s]
constexpr double kClear = 0.5;      // median sine of pronation; sound trials: 0.6 and more

// The one flexion at which gravity stands as far along the forearm as it does; none where there is
// another, or none that an elbow reaches.
std::optional<double> Flexion(const Vector3d& up_U, const Vector3d& up_F) {
  const double length = std::hypot(up_U.x(), up_U.y());
  if (length < kUpright || std::abs(up_F.y()) > length) return std::nullopt;
  const double tilt = std::atan2(up_U.x(), up_U.y()), bend = std::acos(up_F.y() / length);
  const auto is_reached = [](double a) { return a > kLeastFlexion && a < kMostFlexion; };
  const double flexed = std::remainder(bend - tilt, 2 * std::numbers::pi),
               extended = std::remainder(-bend - tilt, 2 * std::numbers::pi);
  if (is_reached(flexed) == is_reached(extended)) return std::nullopt;
  return is_reached(flexed) ? flexed : extended;
}

std::optional<double> SineOfPronation(const Vector3d& up_U, const Vector3d& up_F) {
  const auto flexion = Flexion(up_U, up_F);
  if (!flexion) return std::nullopt;
  const double x = up_U.x() * std::cos(*flexion) + up_U.y() * std::sin(*flexion), z = up_U.z();
  const double across = x * x + z * z;
  if (across < kBent * kBent) return std::nullopt;
  return (x * up_F.z() - z * up_F.x()) / across;
}

}  // namespace

void CheckSide(const Observations& observations, Findings* findings) {
  const Recording* const upper = FindMounted(observations, Segment::kUpperArm);
  const Recording* const fore = FindMounted(observations, Segment::kForearm);
  if (upper == nullptr || fore == nullptr || !observations.arm.elbow.adduction_constraint) return;
  const double sign = Sign(observations.arm.side);
  std::vector<double> sines;
  for (std::size_t i = 0, j = 0; i < fore->size(); ++i) {
    while (j + 1 < upper->size() && upper->time[j] < fore->time[i]) ++j;
    if (!ShowsOnlyGravity(fore->acc_S[i]) || !ShowsOnlyGravity(upper->acc_S[j])) continue;
    const auto sine = SineOfPronation(upper->mounting->q_BS * upper->acc_S[j].normalized(),
                                      fore->mounting->q_BS * fore->acc_S[i].normalized());
    if (sine) sines.push_back(sign * *sine);
  }
  if (static_cast<double>(sines.size()) * SamplingPeriod(*fore) < kLeastTime) return;
  const double median = Quantile(std::move(sines), 0.5);
  if (median > -kClear) return;
  findings->warnings.push_back("the forearm is turned against the upper arm as no " +
                               std::string(Name(observations.arm.side)) +
                               " forearm can be (sine of pronation " + Fixed(median, 2) +
                               "); check arm.side and the mountings [side]");
}

}  // namespace brachium
