#include "io/report/replay_json.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "io/report/packed.h"
#include "io/report/posture.h"
#include "io/report/series.h"
#include "problems/arm_model.h"
#include "problems/sampling.h"

namespace brachium {
namespace {

using Json = nlohmann::ordered_json;
using Samples = std::vector<std::size_t>;

std::vector<std::string> JointsOf(const Drawn& drawn) {
  std::vector<std::string> joints;
  for (const auto& [name, p_W] : drawn.posture.p_W) joints.push_back(name);
  return joints;
}

std::vector<Segment> SegmentsOf(const Drawn& drawn) {
  std::vector<Segment> segments;
  for (const auto& [segment, q_WB] : drawn.posture.q_WB) segments.push_back(segment);
  return segments;
}

template <typename T>
std::ptrdiff_t PlaceOf(const T& value, const std::vector<T>& all) {
  return std::find(all.begin(), all.end(), value) - all.begin();
}

Json BonesJson(const Drawn& drawn) {
  const auto joints = JointsOf(drawn);
  const auto segments = SegmentsOf(drawn);
  Json bones = Json::array();
  for (const Bone& bone : drawn.bones)
    bones.push_back(
        {PlaceOf(bone.from, joints), PlaceOf(bone.to, joints), PlaceOf(bone.segment, segments)});
  return bones;
}

// Joints and segments of `drawn`, as `posture` has them.
Json PostureJson(const Posture& posture, const Drawn& drawn, std::size_t frames) {
  std::vector<double> p_W, q_WB;
  const auto joints = JointsOf(drawn);
  const auto segments = SegmentsOf(drawn);
  for (std::size_t i = 0; i < frames; ++i) {
    for (const std::string& joint : joints) {
      const auto found = posture.p_W.find(joint);
      for (Eigen::Index axis = 0; axis < 3; ++axis)
        p_W.push_back(found == posture.p_W.end() ? std::nan("") : found->second[i][axis]);
    }
    for (const Segment segment : segments) {
      const auto found = posture.q_WB.find(segment);
      const Eigen::Quaterniond q = found == posture.q_WB.end()
                                       ? Eigen::Quaterniond(std::nan(""), 0.0, 0.0, 0.0)
                                       : found->second[i];
      q_WB.insert(q_WB.end(), {q.w(), q.x(), q.y(), q.z()});
    }
  }
  return {{"p", Packed(p_W, 1e-4)}, {"q", Packed(q_WB, 1.0 / 32767.0)}};
}

Json DeviationJson(const Estimate& estimate, const Drawn& drawn, const Samples& samples) {
  for (const std::string joint : {"hand", "wrist", "elbow", "forearm", "upper_arm"}) {
    const auto found = estimate.sd_W.find(joint);
    const auto joints = JointsOf(drawn);
    if (found == estimate.sd_W.end() || std::ranges::find(joints, joint) == joints.end()) continue;
    std::vector<double> sd;
    for (const std::size_t sample : samples)
      for (Eigen::Index axis = 0; axis < 3; ++axis) sd.push_back(found->second[sample][axis]);
    return {{"joint", PlaceOf(joint, joints)}, {"sd", Packed(sd, 1e-5)}};
  }
  return nullptr;
}

std::vector<double> Picked(const std::vector<double>& values, const Samples& samples) {
  std::vector<double> picked;
  for (const std::size_t sample : samples)
    picked.push_back(values.empty() ? std::nan("") : values[sample]);
  return picked;
}

Json AnglesJson(const ReportedEstimate& reported, const Samples& samples) {
  constexpr double kFinest = 0.01;  // [deg]
  Json angles = Json::array();
  for (const auto& [name, series] : ShownAngles(reported.estimate)) {
    Json angle = {{"name", name},
                  {"value", Packed(Picked(series.value, samples), kFinest)},
                  {"sd", Packed(Picked(series.sd, samples), kFinest)}};
    if (const ShownSeries reference = ReferenceAngle(reported, name); !reference.time.empty())
      angle["reference"] = Packed(Interpolate(SampleTimes(reference.time), reference.value,
                                              Picked(reported.estimate.time, samples)),
                                  kFinest);
    angles.push_back(std::move(angle));
  }
  return angles;
}

std::vector<std::string> NotesOf(const ReportedEstimate& reported, const Drawn& drawn,
                                 std::size_t step) {
  std::vector<std::string> notes;
  if (step > 1) notes.push_back("Shown is one sample of " + std::to_string(step) + ".");
  if (drawn.nominal)
    notes.push_back(
        "The method tells no positions: joints are drawn with an adult's lengths, from a shoulder "
        "that stays.");
  if (reported.reference)
    notes.push_back(
        "The reference is drawn in the estimate's world, after the heading and shift "
        "that lay both together.");
  return notes;
}

}  // namespace

Json ReplayJson(const ReportedEstimate& reported, std::size_t most) {
  const std::size_t size = reported.estimate.time.size(), step = (size + most - 1) / most;
  Samples samples;
  for (std::size_t sample = 0; sample < size; sample += step) samples.push_back(sample);
  const Drawn drawn = DrawnEstimate(reported.estimate, samples);
  std::vector<std::string> segments;
  for (const Segment segment : SegmentsOf(drawn)) segments.emplace_back(Name(segment));
  Json json = {{"name", reported.name},
               {"time", PackedExactly(Picked(reported.estimate.time, samples))},
               {"joints", JointsOf(drawn)},
               {"segments", segments},
               {"bones", BonesJson(drawn)},
               {"estimate", PostureJson(drawn.posture, drawn, samples.size())},
               {"deviation", DeviationJson(reported.estimate, drawn, samples)},
               {"angles", AnglesJson(reported, samples)},
               {"notes", NotesOf(reported, drawn, step)}};
  if (reported.reference)
    json["reference"] =
        PostureJson(DrawnReference(reported, drawn, samples), drawn, samples.size());
  return json;
}

}  // namespace brachium
