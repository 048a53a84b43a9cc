#include "io/report/posture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "problems/sampling.h"

namespace brachium {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr const char* kNeck = "neck";
constexpr const char* kPelvis = "pelvis";

// For the picture only [m].
double NominalLength(Segment segment) {
  if (segment == Segment::kUpperArm) return 0.30;
  return segment == Segment::kForearm ? 0.26 : 0.10;
}
constexpr double kHalfShoulders = 0.18, kTrunk = 0.45;

template <typename T>
std::vector<T> Picked(const std::vector<T>& all, const std::vector<std::size_t>& samples) {
  std::vector<T> picked;
  for (const std::size_t sample : samples) picked.push_back(all[sample]);
  return picked;
}

bool IsOfTheArm(Segment segment) {
  return segment == Segment::kUpperArm || segment == Segment::kForearm || segment == Segment::kHand;
}

// Whether the only point that is told is the sensor of this segment: "hand" is a joint, too.
template <typename Points>
bool IsLone(Segment segment, const Points& points) {
  return points.size() == 1 && points.contains(std::string(Name(segment)));
}

double LengthOf(const Posture& posture, const Bone& bone) {
  const auto &from = posture.p_W.at(bone.from), &to = posture.p_W.at(bone.to);
  for (std::size_t i = 0; i < from.size(); ++i)
    if (const double length = (to[i] - from[i]).norm(); std::isfinite(length)) return length;
  return NominalLength(bone.segment);
}

// The far ends of a segment that hangs from `from`, down its own y axis.
std::vector<Vector3d> Hanging(const std::vector<Vector3d>& from,
                              const std::vector<Quaterniond>& q_WB, double length) {
  std::vector<Vector3d> to;
  for (std::size_t i = 0; i < from.size(); ++i)
    to.push_back(from[i] + q_WB[i] * Vector3d(0.0, -length, 0.0));
  return to;
}

void AddSegment(Segment segment, std::size_t frames, Drawn* drawn) {
  const std::string from(ProximalJointName(segment)), to(DistalJointName(segment));
  auto& p_W = drawn->posture.p_W;
  if (IsLone(segment, p_W)) {
    const std::string own(Name(segment));
    drawn->bones.push_back({own, own, segment});
    return;
  }
  if (!p_W.contains(from)) p_W[from].assign(frames, Vector3d::Zero());
  if (!p_W.contains(to)) {
    p_W[to] = Hanging(p_W[from], drawn->posture.q_WB.at(segment), NominalLength(segment));
    drawn->nominal = true;
  }
  drawn->bones.push_back({from, to, segment});
}

// A trunk as wide and long as an adult's beside the shoulder.
void AddTrunk(Side side, Posture* posture) {
  const auto& q_WT = posture->q_WB.at(Segment::kThorax);
  std::vector<Vector3d> neck = posture->p_W.at("shoulder"), pelvis;
  for (std::size_t i = 0; i < neck.size(); ++i) {
    neck[i] -= q_WT[i] * Vector3d(0.0, 0.0, Sign(side) * kHalfShoulders);
    pelvis.emplace_back(neck[i] + q_WT[i] * Vector3d(0.0, -kTrunk, 0.0));
  }
  posture->p_W[kNeck] = std::move(neck);
  posture->p_W[kPelvis] = std::move(pelvis);
}

// The instant of `at` nearest to t, within a step of it.
std::optional<std::size_t> Nearest(const SampleTimes& at, double t) {
  const auto& time = at.time();
  const auto after = std::lower_bound(time.begin(), time.end(), t);
  std::optional<std::size_t> nearest;
  double least = std::max(at.step(), 1e-9);
  for (auto place : {after, after == time.begin() ? after : std::prev(after)}) {
    if (place == time.end() || std::abs(*place - t) > least) continue;
    least = std::abs(*place - t);
    nearest = static_cast<std::size_t>(place - time.begin());
  }
  return nearest;
}

struct Instants {
  std::vector<std::optional<std::size_t>> nearest;

  template <typename T>
  std::vector<T> Pick(const std::vector<T>& all, const T& unknown) const {
    std::vector<T> picked;
    for (const auto& instant : nearest) picked.push_back(instant ? all[*instant] : unknown);
    return picked;
  }
};

// reference ≈ proximal * estimate * distal, turned round.
std::vector<Quaterniond> InEstimatesFrames(std::vector<Quaterniond> q_VB,
                                           const RotationAlignment& alignment) {
  for (Quaterniond& q : q_VB) q = alignment.proximal.conjugate() * q * alignment.distal.conjugate();
  return q_VB;
}

// reference ≈ Rz(heading) * estimate + shift, turned round; an unknown height is taken as `z`.
Vector3d InEstimatesWorld(const Vector3d& p_V, const PointAlignment& alignment, double z) {
  Vector3d p = Eigen::AngleAxisd(-alignment.heading, Vector3d::UnitZ()) * (p_V - alignment.shift);
  if (std::isnan(p.z())) p.z() = z;
  return p;
}

}  // namespace

Drawn DrawnEstimate(const Estimate& estimate, const std::vector<std::size_t>& samples) {
  Drawn drawn;
  for (const auto& [name, p_W] : estimate.p_W) drawn.posture.p_W[name] = Picked(p_W, samples);
  for (const auto& [segment, q_WB] : estimate.q_WB)
    drawn.posture.q_WB[segment] = Picked(q_WB, samples);
  for (const auto& [segment, q_WB] : estimate.q_WB)
    if (IsOfTheArm(segment) || IsLone(segment, estimate.p_W))
      AddSegment(segment, samples.size(), &drawn);
  if (drawn.posture.q_WB.contains(Segment::kThorax) && drawn.posture.p_W.contains("shoulder")) {
    AddTrunk(estimate.side, &drawn.posture);
    drawn.bones.push_back({kNeck, kPelvis, Segment::kThorax});
    drawn.bones.push_back({kNeck, "shoulder", Segment::kThorax});
  }
  return drawn;
}

Posture DrawnReference(const ReportedEstimate& reported, const Drawn& drawn,
                       const std::vector<std::size_t>& samples) {
  const Reference& reference = *reported.reference;
  const Evaluation& evaluation = *reported.evaluation;
  const SampleTimes times(evaluation.time);
  Instants instants;
  for (const std::size_t sample : samples)
    instants.nearest.push_back(Nearest(times, reported.estimate.time[sample]));
  Posture posture;
  for (const auto& [segment, orientation] : evaluation.orientation)
    posture.q_WB[segment] = InEstimatesFrames(
        instants.Pick(reference.q_VB.at(segment), Quaterniond(kNaN, kNaN, kNaN, kNaN)),
        orientation.alignment);
  for (const auto& [name, position] : evaluation.positions) {
    posture.p_W[name] = instants.Pick(reference.p_V.at(name), Vector3d(Vector3d::Constant(kNaN)));
    for (std::size_t i = 0; i < samples.size(); ++i)
      posture.p_W[name][i] = InEstimatesWorld(posture.p_W[name][i], evaluation.point_alignment,
                                              drawn.posture.p_W.at(name)[i].z());
  }
  for (const Bone& bone : drawn.bones) {
    if (!IsOfTheArm(bone.segment) || bone.from == bone.to) continue;
    if (!posture.q_WB.contains(bone.segment)) continue;
    if (!posture.p_W.contains(bone.from)) posture.p_W[bone.from] = drawn.posture.p_W.at(bone.from);
    if (!posture.p_W.contains(bone.to))
      posture.p_W[bone.to] = Hanging(posture.p_W[bone.from], posture.q_WB.at(bone.segment),
                                     LengthOf(drawn.posture, bone));
  }
  return posture;
}

}  // namespace brachium
