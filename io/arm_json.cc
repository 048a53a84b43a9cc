#include "io/arm_json.h"

#include <array>
#include <cmath>
#include <string_view>

#include "io/json_defaults.h"
#include "io/text.h"

namespace brachium {
namespace {

constexpr double kLongestSegment = 3.0;  // [m]; beyond it the unit is wrong
constexpr std::array<std::string_view, 4> kArmKeys = {"side", "segments", "elbow", "shoulder"};
constexpr std::array<std::string_view, 3> kSegmentKeys = {"length_m", "length_sigma_m",
                                                          "distal_joint_m"};
constexpr std::array<std::string_view, 4> kElbowKeys = {
    "constraint", "carrying_angle_deg", "carrying_angle_sigma_deg", "carrying_slope_sigma_deg"};
constexpr std::array<std::string_view, 2> kShoulderKeys = {"sigma_m", "correlation_s"};
constexpr std::array<std::string_view, 2> kSides = {"right", "left"};
constexpr std::array<std::string_view, 2> kConstraints = {"adduction", "none"};

void CheckLength(const JsonNode& node, double length) {
  if (length > kLongestSegment)
    node.Fail("is " + Shortest(length) +
              " m long; expected metres, and this looks like centimetres or millimetres");
}

Eigen::Vector3d ParseDistalJoint(const JsonNode& node) {
  const std::vector<double> p = node.Numbers(3);
  const Eigen::Vector3d p_distal_B(p[0], p[1], p[2]);
  if (!(p_distal_B.norm() > 0.0)) node.Fail("is zero; expected a segment with a length");
  CheckLength(node, p_distal_B.norm());
  return p_distal_B;
}

double ParseLength(const JsonNode& node) {
  const double length = node.PositiveNumber();
  CheckLength(node, length);
  return length;
}

SegmentGeometry ParseGeometry(const JsonNode& node, Segment segment, Side side,
                              Findings* findings) {
  node.WarnOfUnknownKeys(kSegmentKeys, &findings->warnings);
  SegmentGeometry geometry = DefaultGeometry(segment, side);
  const auto length = node.Find("length_m");
  const auto distal_joint = node.Find("distal_joint_m");
  if (length) geometry.p_distal_B = {0.0, -ParseLength(*length), 0.0};
  if (distal_joint) geometry.p_distal_B = ParseDistalJoint(*distal_joint);
  if (length && distal_joint && std::abs(length->Number() - geometry.p_distal_B.norm()) > 0.001)
    findings->warnings.push_back(node.path() +
                                 ": length_m is not the length of distal_joint_m, which is used");
  if (!length && !distal_joint)
    NoteDefault(node, "length_m", Shortest(geometry.p_distal_B.norm()) + " m", findings);
  const double absent = length || distal_joint ? SegmentGeometry{}.sigma : geometry.sigma;
  geometry.sigma = PositiveNumberOr(node, "length_sigma_m", absent, "m", findings);
  return geometry;
}

ElbowModel ParseElbow(const JsonNode& node, Findings* findings) {
  node.WarnOfUnknownKeys(kElbowKeys, &findings->warnings);
  ElbowModel elbow;
  if (const auto constraint = node.Find("constraint")) {
    const std::string name = constraint->Text();
    if (name != "adduction" && name != "none")
      constraint->Fail("is '" + name + "'; expected one of " + Listed(kConstraints));
    elbow.adduction_constraint = name == "adduction";
  } else {
    NoteDefault(node, "constraint", "adduction", findings);
  }
  Findings unseen;  // a ball joint has no carrying angle: its defaults are of no account
  Findings* const seen = elbow.adduction_constraint ? findings : &unseen;
  const double carrying_deg = NumberOr(node, "carrying_angle_deg", 10, "deg", seen);
  if (!(std::abs(carrying_deg) < 90.0))
    node.At("carrying_angle_deg").Fail("is not within -90 to 90; expected degrees");
  elbow.carrying_angle = carrying_deg * kDegree;
  elbow.carrying_angle_sigma =
      PositiveNumberOr(node, "carrying_angle_sigma_deg", 8, "deg", seen) * kDegree;
  if (const auto slope = node.Find("carrying_slope_sigma_deg"))
    elbow.carrying_slope_sigma = slope->PositiveNumber() * kDegree;
  return elbow;
}

ShoulderModel ParseShoulder(const JsonNode& node, Findings* findings) {
  node.WarnOfUnknownKeys(kShoulderKeys, &findings->warnings);
  const ShoulderModel absent;
  return {.sigma = PositiveNumberOr(node, "sigma_m", absent.sigma, "m", findings),
          .correlation_time =
              PositiveNumberOr(node, "correlation_s", absent.correlation_time, "s", findings)};
}

void NoteDefaultGeometry(Segment segment, const SegmentGeometry& geometry, Findings* findings) {
  const Eigen::Vector3d& p = geometry.p_distal_B;
  findings->defaults.push_back("arm.segments." + std::string(Name(segment)) +
                               ".distal_joint_m = [" + Shortest(p.x()) + ", " + Shortest(p.y()) +
                               ", " + Shortest(p.z()) + "], sigma " + Shortest(geometry.sigma) +
                               " m (an adult's mean)");
}

void AddMissingGeometries(const std::set<Segment>& recorded, ArmModel* arm, Findings* findings) {
  for (const Segment segment : recorded) {
    if (arm->segments.contains(segment)) continue;
    const SegmentGeometry geometry = DefaultGeometry(segment, arm->side);
    arm->segments[segment] = geometry;
    if (recorded.size() > 1) NoteDefaultGeometry(segment, geometry, findings);
  }
}

}  // namespace

Segment ParseSegment(const JsonNode& node, const std::string& name) {
  if (const auto segment = SegmentFromName(name)) return *segment;
  std::vector<std::string_view> known;
  for (const Segment segment : kSegments) known.push_back(Name(segment));
  node.Fail("names the unknown segment '" + name + "'; expected one of " + Listed(known));
}

Segment ParseSegment(const JsonNode& name) { return ParseSegment(name, name.Text()); }

Side ParseSide(const JsonNode& node) {
  const std::string name = node.Text();
  if (name != "right" && name != "left")
    node.Fail("is '" + name + "'; expected one of " + Listed(kSides));
  return name == "right" ? Side::kRight : Side::kLeft;
}

ArmModel ParseArm(const JsonNode& node, const std::set<Segment>& recorded, Findings* findings) {
  node.WarnOfUnknownKeys(kArmKeys, &findings->warnings);
  ArmModel arm;
  arm.side = ParseSide(node.At("side"));
  if (const auto segments = node.Find("segments"))
    for (const auto& [name, geometry] : segments->Members()) {
      const Segment segment = ParseSegment(geometry, name);
      arm.segments[segment] = ParseGeometry(geometry, segment, arm.side, findings);
    }
  AddMissingGeometries(recorded, &arm, findings);
  if (const auto elbow = node.Find("elbow"))
    arm.elbow = ParseElbow(*elbow, findings);
  else if (recorded.contains(Segment::kUpperArm) && recorded.contains(Segment::kForearm))
    findings->defaults.push_back(
        "arm.elbow = adduction constraint, carrying angle 10 deg, sigma 8 deg");
  if (const auto shoulder = node.Find("shoulder"))
    arm.shoulder = ParseShoulder(*shoulder, findings);
  else if (recorded.size() > 1)
    findings->defaults.push_back("arm.shoulder = sigma 0.03 m, correlation time 10 s");
  return arm;
}

}  // namespace brachium
