#include "problems/joint_angle_series.h"

#include <limits>
#include <optional>

#include "problems/joint_angles.h"

namespace brachium {
namespace {

using Eigen::Quaterniond;
using Rotations = std::vector<Quaterniond>;

constexpr double kAbsent = std::numeric_limits<double>::quiet_NaN();

template <typename Angle>
std::vector<double> SeriesOf(const Rotations& rotations, const Angle& angle) {
  std::vector<double> series;
  series.reserve(rotations.size());
  for (const Quaterniond& q : rotations)
    series.push_back(q.coeffs().allFinite() ? angle(q) : kAbsent);
  return series;
}

Rotations Relative(const Rotations& proximal, const Rotations& distal) {
  Rotations relative;
  relative.reserve(distal.size());
  for (std::size_t i = 0; i < distal.size(); ++i)
    relative.push_back(proximal[i].conjugate() * distal[i]);
  return relative;
}

}  // namespace

std::map<std::string, std::vector<double>> JointAngleSeries(
    const std::map<Segment, Rotations>& q_WB, Side side) {
  std::map<std::string, std::vector<double>> angles;
  const auto has = [&](Segment segment) { return q_WB.contains(segment); };
  if (has(Segment::kUpperArm) && has(Segment::kForearm)) {
    const Rotations elbow = Relative(q_WB.at(Segment::kUpperArm), q_WB.at(Segment::kForearm));
    const auto of = [&](double ElbowAngles::*angle) {
      return SeriesOf(elbow,
                      [&](const Quaterniond& q_UF) { return ElbowAnglesFrom(q_UF, side).*angle; });
    };
    angles["elbow_flexion"] = of(&ElbowAngles::flexion);
    angles["elbow_carrying"] = of(&ElbowAngles::carrying);
    angles["forearm_pronation"] = of(&ElbowAngles::pronation);
  }
  if (has(Segment::kForearm) && has(Segment::kHand)) {
    const Rotations wrist = Relative(q_WB.at(Segment::kForearm), q_WB.at(Segment::kHand));
    const auto of = [&](double WristAngles::*angle) {
      return SeriesOf(wrist,
                      [&](const Quaterniond& q_FH) { return WristAnglesFrom(q_FH, side).*angle; });
    };
    angles["wrist_flexion"] = of(&WristAngles::flexion);
    angles["wrist_deviation"] = of(&WristAngles::deviation);
  }
  if (has(Segment::kThorax) && has(Segment::kUpperArm)) {
    const Rotations shoulder = Relative(q_WB.at(Segment::kThorax), q_WB.at(Segment::kUpperArm));
    const auto of = [&](std::optional<double> ShoulderAngles::*angle) {
      return SeriesOf(shoulder, [&](const Quaterniond& q_TU) {
        return (ShoulderAnglesFrom(q_TU, side).*angle).value_or(kAbsent);
      });
    };
    angles["shoulder_plane"] = of(&ShoulderAngles::plane);
    angles["shoulder_rotation"] = of(&ShoulderAngles::rotation);
    angles["shoulder_elevation"] = SeriesOf(shoulder, [&](const Quaterniond& q_TU) {
      return ShoulderAnglesFrom(q_TU, side).elevation;
    });
  } else if (has(Segment::kUpperArm)) {
    angles["shoulder_elevation"] = SeriesOf(q_WB.at(Segment::kUpperArm), ShoulderElevation);
  }
  return angles;
}

}  // namespace brachium
