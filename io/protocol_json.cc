#include "io/protocol_json.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "io/json_defaults.h"
#include "io/text.h"

namespace brachium {
namespace {

constexpr double kTimeTolerance = 0.1;  // [s]: "0" may stand for the first sample's 0.005
constexpr std::array<std::string_view, 3> kIntervalKeys = {"label", "start_s", "end_s"};
constexpr std::array<std::string_view, 6> kPoseKeys = {
    "label", "at_s", "elbow_flexion_deg", "forearm_pronation_deg", "shoulder_elevation_deg",
    "sd_deg"};
constexpr std::array<std::string_view, 8> kLabels = {"rest",
                                                     "calibration:forearm_pronation",
                                                     "calibration:forearm_supination",
                                                     "calibration:upper_arm_endorotation",
                                                     "calibration:upper_arm_exorotation",
                                                     "calibration:upper_arm_abduction",
                                                     "calibration:static_pose",
                                                     "calibration:shoulder_still"};
constexpr std::array<std::string_view, 1> kPoses = {"arms_along_body_thumbs_forward"};

bool IsKnownLabel(std::string_view label) {
  return std::ranges::find(kLabels, label) != kLabels.end() || label.starts_with("task:") ||
         label.starts_with("cycle:");
}

Interval ParseInterval(const JsonNode& node, Findings* findings) {
  node.WarnOfUnknownKeys(kIntervalKeys, &findings->warnings);
  const Interval interval{.label = node.At("label").Text(),
                          .start = node.At("start_s").Number(),
                          .end = node.At("end_s").Number()};
  if (!(interval.end > interval.start))
    node.At("end_s").Fail("is " + Shortest(interval.end) + "; expected a time after start_s, " +
                          Shortest(interval.start));
  if (!IsKnownLabel(interval.label))
    findings->warnings.push_back(node.path() + ": no method knows the label '" + interval.label +
                                 "'" + DidYouMean(interval.label, kLabels));
  return interval;
}

HeldPose PoseOfLabel(const JsonNode& node) {
  if (node.Text() != kPoses[0])
    node.Fail("is the unknown pose '" + node.Text() + "'; expected " + Listed(kPoses) +
              ", or angles such as elbow_flexion_deg");
  return {
      .elbow_flexion = 10 * kDegree, .forearm_pronation = 90 * kDegree, .shoulder_elevation = 0.0};
}

void ReplaceIfGiven(const JsonNode& node, const std::string& key, std::optional<double>* angle) {
  const auto given = node.Find(key);
  if (!given) return;
  if (!(std::abs(given->Number()) <= 360.0)) given->Fail("is not an angle; expected degrees");
  *angle = given->Number() * kDegree;
}

std::optional<HeldPose> ParsePose(const JsonNode& trial, const std::string& key, double usual_time,
                                  const Interval& covered, Findings* findings) {
  const auto node = trial.Find(key);
  if (!node) return std::nullopt;
  node->WarnOfUnknownKeys(kPoseKeys, &findings->warnings);
  const auto label = node->Find("label");
  HeldPose pose = label ? PoseOfLabel(*label) : HeldPose{};
  ReplaceIfGiven(*node, "elbow_flexion_deg", &pose.elbow_flexion);
  ReplaceIfGiven(*node, "forearm_pronation_deg", &pose.forearm_pronation);
  ReplaceIfGiven(*node, "shoulder_elevation_deg", &pose.shoulder_elevation);
  if (!pose.elbow_flexion && !pose.forearm_pronation && !pose.shoulder_elevation)
    node->Fail("states no pose; expected a label or an angle such as elbow_flexion_deg");
  pose.time = NumberOr(*node, "at_s", usual_time, "s", findings);
  if (const auto at = node->Find("at_s")) pose.time = TimeWithin(covered, *at, pose.time);
  pose.sigma = PositiveNumberOr(*node, "sd_deg", 10, "deg", findings) * kDegree;
  return pose;
}

}  // namespace

double TimeWithin(const Interval& covered, const JsonNode& node, double time) {
  const double within = std::clamp(time, covered.start, covered.end);
  if (std::abs(time - within) > kTimeTolerance)
    node.Fail("is " + Shortest(time) + "; expected a time within the recordings, " +
              Shortest(covered.start) + " to " + Shortest(covered.end) + " s");
  return within;
}

double ParseGravity(const JsonNode& trial, Findings* findings) {
  const double gravity = PositiveNumberOr(trial, "gravity_m_s2", kGravity, "m/s^2", findings);
  if (gravity < 9.75 || gravity > 9.85)
    trial.At("gravity_m_s2")
        .Fail("is " + Shortest(gravity) + "; expected 9.78 at the equator to 9.83 at the poles");
  return gravity;
}

std::vector<Interval> ParseIntervals(const JsonNode& trial, const Interval& covered,
                                     Findings* findings) {
  std::vector<Interval> intervals;
  const auto list = trial.Find("intervals");
  if (!list) return intervals;
  for (const JsonNode& node : list->Elements()) {
    intervals.push_back(ParseInterval(node, findings));
    const Interval& interval = intervals.back();
    if (interval.start < covered.start || interval.end > covered.end)
      findings->warnings.push_back(node.path() + ": '" + interval.label +
                                   "' reaches outside of the recordings' common time, " +
                                   Shortest(covered.start) + " to " + Shortest(covered.end) + " s");
  }
  return intervals;
}

std::optional<HeldPose> ParseStartPose(const JsonNode& trial, const Interval& covered,
                                       Findings* findings) {
  return ParsePose(trial, "start_pose", covered.start, covered, findings);
}

std::optional<HeldPose> ParseEndPose(const JsonNode& trial, const Interval& covered,
                                     Findings* findings) {
  return ParsePose(trial, "end_pose", covered.end, covered, findings);
}

}  // namespace brachium
