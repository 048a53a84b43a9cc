#include "problems/arm_angles.h"

#include <limits>

namespace brachium {
namespace {

using Eigen::Quaterniond;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

}  // namespace

std::vector<ArmAngle> ArmAngles(const std::set<Segment>& known, Side side) {
  std::vector<ArmAngle> angles;
  const auto add = [&](const char* name, std::optional<Segment> proximal, Segment distal, auto of) {
    if (known.contains(distal) && (!proximal || known.contains(*proximal)))
      angles.push_back(
          {name, proximal, distal, [of, side](const Quaterniond& q_AB) { return of(q_AB, side); }});
  };
  const auto elbow = [&](const char* name, double ElbowAngles::*angle) {
    add(name, Segment::kUpperArm, Segment::kForearm,
        [angle](const auto& q, Side s) { return ElbowAnglesFrom(q, s).*angle; });
  };
  elbow("elbow_flexion", &ElbowAngles::flexion);
  elbow("elbow_carrying", &ElbowAngles::carrying);
  elbow("forearm_pronation", &ElbowAngles::pronation);
  if (known.contains(Segment::kThorax)) {
    const auto shoulder = [&](const char* name, auto of) {
      add(name, Segment::kThorax, Segment::kUpperArm, of);
    };
    shoulder("shoulder_plane",
             [](const auto& q, Side s) { return ShoulderAnglesFrom(q, s).plane.value_or(kNaN); });
    shoulder("shoulder_elevation",
             [](const auto& q, Side s) { return ShoulderAnglesFrom(q, s).elevation; });
    shoulder("shoulder_rotation", [](const auto& q, Side s) {
      return ShoulderAnglesFrom(q, s).rotation.value_or(kNaN);
    });
  } else {
    add("shoulder_elevation", std::nullopt, Segment::kUpperArm,
        [](const auto& q, Side) { return ShoulderElevation(q); });
  }
  const auto wrist = [&](const char* name, double WristAngles::*angle) {
    add(name, Segment::kForearm, Segment::kHand,
        [angle](const auto& q, Side s) { return WristAnglesFrom(q, s).*angle; });
  };
  wrist("wrist_flexion", &WristAngles::flexion);
  wrist("wrist_deviation", &WristAngles::deviation);
  return angles;
}

std::vector<double> SeriesOf(const ArmAngle& angle, const Attitudes& q_WB) {
  const std::vector<Quaterniond>& distal = q_WB.at(angle.distal);
  std::vector<double> series;
  series.reserve(distal.size());
  for (std::size_t i = 0; i < distal.size(); ++i) {
    const Quaterniond q_AB =
        angle.proximal ? q_WB.at(*angle.proximal)[i].conjugate() * distal[i] : distal[i];
    series.push_back(q_AB.coeffs().allFinite() ? angle.of(q_AB) : kNaN);
  }
  return series;
}

std::map<std::string, std::vector<double>> JointAngleSeries(const Attitudes& q_WB, Side side) {
  std::set<Segment> known;
  for (const auto& [segment, attitudes] : q_WB) known.insert(segment);
  std::map<std::string, std::vector<double>> series;
  for (const ArmAngle& angle : ArmAngles(known, side)) series[angle.name] = SeriesOf(angle, q_WB);
  return series;
}

}  // namespace brachium
