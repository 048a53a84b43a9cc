#include "io/mounting_json.h"

#include <array>
#include <cmath>
#include <string_view>

#include "io/json_defaults.h"
#include "io/text.h"

namespace brachium {
namespace {

constexpr double kFarthestSensor = 2.0;  // [m] from the proximal joint; beyond it the unit is wrong
constexpr std::array<std::string_view, 4> kMountingKeys = {"q_BS_wxyz", "q_sigma_deg", "p_BS_m",
                                                           "p_sigma_m"};
constexpr std::array<std::string_view, 6> kNoiseKeys = {"preset",
                                                        "gyro_density_deg_s_rthz",
                                                        "gyro_bias_sigma_deg_s",
                                                        "gyro_bias_walk_deg_s_rts",
                                                        "accel_density_m_s2_rthz",
                                                        "accel_bias_sigma_m_s2"};
constexpr std::array<std::string_view, 2> kPresets = {"mtw", "mtx"};

Eigen::Vector3d ParsePosition(const JsonNode& node) {
  const std::vector<double> p = node.Numbers(3);
  const Eigen::Vector3d p_BS_B(p[0], p[1], p[2]);
  if (!(p_BS_B.norm() <= kFarthestSensor))
    node.Fail("is " + Fixed(p_BS_B.norm(), 2) +
              " m from the joint; expected metres, and this looks like centimetres or millimetres");
  return p_BS_B;
}

ImuNoise ParsePreset(const JsonNode& node) {
  const auto noise = NoiseFromPreset(node.Text());
  if (!noise)
    node.Fail("is the unknown preset '" + node.Text() + "'; expected one of " + Listed(kPresets) +
              ", or an object");
  return *noise;
}

void ReplaceIfGiven(const JsonNode& node, std::string_view key, double unit, double* value) {
  if (const auto given = node.Find(std::string(key))) *value = given->PositiveNumber() * unit;
}

}  // namespace

Eigen::Quaterniond ParseRotation(const JsonNode& node) {
  const std::vector<double> q = node.Numbers(4);
  const Eigen::Quaterniond q_BS(q[0], q[1], q[2], q[3]);
  if (!(std::abs(q_BS.norm() - 1.0) <= kUnitNormTolerance))
    node.Fail("has the norm " + Fixed(q_BS.norm(), 4) + "; expected a unit quaternion, w first");
  return q_BS.normalized();
}

Mounting ParseMounting(const JsonNode& node, const SegmentGeometry& segment, Findings* findings) {
  node.WarnOfUnknownKeys(kMountingKeys, &findings->warnings);
  Mounting mounting;
  mounting.q_BS = ParseRotation(node.At("q_BS_wxyz"));
  if (const auto q_sigma = node.Find("q_sigma_deg"))
    mounting.q_sigma = q_sigma->NumberFromZero() * kDegree;
  else
    NoteDefault(node, "q_sigma_deg", "2 deg", findings);
  const auto position = node.Find("p_BS_m");
  mounting.p_BS_B = position ? ParsePosition(*position) : 0.5 * segment.p_distal_B;
  if (!position) NoteDefault(node, "p_BS_m", "half-way to the distal joint", findings);
  mounting.p_sigma =
      PositiveNumberOr(node, "p_sigma_m", position ? Mounting{}.p_sigma : 0.05, "m", findings);
  return mounting;
}

ImuNoise ParseNoise(const JsonNode& recording, Findings* findings) {
  const auto node = recording.Find("noise");
  if (!node) {
    NoteDefault(recording, "noise", "mtw", findings);
    return MtwNoise();
  }
  if (node->IsText()) return ParsePreset(*node);
  node->WarnOfUnknownKeys(kNoiseKeys, &findings->warnings);
  const auto preset = node->Find("preset");
  if (!preset) NoteDefault(*node, "preset", "mtw (for the figures that are not given)", findings);
  ImuNoise noise = preset ? ParsePreset(*preset) : MtwNoise();
  ReplaceIfGiven(*node, "gyro_density_deg_s_rthz", kDegree, &noise.gyro_density);
  ReplaceIfGiven(*node, "gyro_bias_sigma_deg_s", kDegree, &noise.gyro_bias_sigma);
  ReplaceIfGiven(*node, "gyro_bias_walk_deg_s_rts", kDegree, &noise.gyro_bias_walk);
  ReplaceIfGiven(*node, "accel_density_m_s2_rthz", 1.0, &noise.accel_density);
  ReplaceIfGiven(*node, "accel_bias_sigma_m_s2", 1.0, &noise.accel_bias_sigma);
  return noise;
}

}  // namespace brachium
