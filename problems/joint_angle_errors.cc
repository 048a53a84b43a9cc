#include "problems/joint_angle_errors.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "problems/joint_angles.h"

namespace brachium {
namespace {

using Eigen::Quaterniond;

constexpr double kAbsent = Statistics::kUnknown;

// The reference's angle and the one a turn away from it that is nearest to the estimate's, so that
// no correlation is lost where an angle passes ±π.
template <typename Angle>
Statistics AngleStatistics(const RotationPairs& pairs, const Angle& angle) {
  const auto n = static_cast<Eigen::Index>(pairs.size());
  Series error = Series::Constant(1, n, kAbsent), reference = error;
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (!pairs.Known(k)) continue;
    reference(0, i) = angle(pairs.reference[k]);
    error(0, i) =
        std::remainder(angle(pairs.estimate[k]) - reference(0, i), 2.0 * std::numbers::pi);
  }
  Statistics statistics = StatisticsOf(error);
  statistics.correlation = Correlation(reference + error, reference);
  return statistics;
}

}  // namespace

std::map<std::string, Statistics> JointAngleErrors(const std::map<Segment, RotationPairs>& segments,
                                                   Side side) {
  std::map<std::string, Statistics> errors;
  const auto has = [&](Segment segment) { return segments.count(segment) > 0; };
  const auto joint = [&](Segment proximal, Segment distal) {
    return RelativeOf(segments.at(proximal), segments.at(distal));
  };
  if (has(Segment::kUpperArm) && has(Segment::kForearm)) {
    const RotationPairs elbow = joint(Segment::kUpperArm, Segment::kForearm);
    const auto of = [&](double ElbowAngles::*angle) {
      return AngleStatistics(
          elbow, [&](const Quaterniond& q_UF) { return ElbowAnglesFrom(q_UF, side).*angle; });
    };
    errors["elbow_flexion"] = of(&ElbowAngles::flexion);
    errors["elbow_carrying"] = of(&ElbowAngles::carrying);
    errors["forearm_pronation"] = of(&ElbowAngles::pronation);
  }
  if (has(Segment::kForearm) && has(Segment::kHand)) {
    const RotationPairs wrist = joint(Segment::kForearm, Segment::kHand);
    const auto of = [&](double WristAngles::*angle) {
      return AngleStatistics(
          wrist, [&](const Quaterniond& q_FH) { return WristAnglesFrom(q_FH, side).*angle; });
    };
    errors["wrist_flexion"] = of(&WristAngles::flexion);
    errors["wrist_deviation"] = of(&WristAngles::deviation);
  }
  if (has(Segment::kThorax) && has(Segment::kUpperArm)) {
    const RotationPairs shoulder = joint(Segment::kThorax, Segment::kUpperArm);
    const auto of = [&](std::optional<double> ShoulderAngles::*angle) {
      return AngleStatistics(shoulder, [&](const Quaterniond& q_TU) {
        return (ShoulderAnglesFrom(q_TU, side).*angle).value_or(kAbsent);
      });
    };
    errors["shoulder_plane"] = of(&ShoulderAngles::plane);
    errors["shoulder_rotation"] = of(&ShoulderAngles::rotation);
    errors["shoulder_elevation"] = AngleStatistics(shoulder, [&](const Quaterniond& q_TU) {
      return ShoulderAnglesFrom(q_TU, side).elevation;
    });
  } else if (has(Segment::kUpperArm)) {
    errors["shoulder_elevation"] =
        AngleStatistics(segments.at(Segment::kUpperArm), ShoulderElevation);
  }
  return errors;
}

}  // namespace brachium
