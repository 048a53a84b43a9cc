#include "solver/baselines/bai_kinematic.h"

#include <algorithm>
#include <cmath>

#include "solver/baselines/given_attitudes.h"
#include "solver/baselines/static_alignment.h"
#include "solver/stage_clock.h"
#include "solver/wearing.h"

namespace brachium {
namespace {

using Eigen::Vector3d;

Observations Prepared(const Observations& observations, const BaiKinematicOptions& options) {
  Observations prepared = AlignedByStaticPose(observations, options.bai_facing_deg * kDegree);
  std::erase_if(prepared.recordings,
                [](const Recording& recording) { return recording.segment == Segment::kThorax; });
  if (const double L4 = options.bai_girdle_length_m; L4 > 0.0) {
    const double alpha = options.bai_girdle_angle_deg * kDegree;
    prepared.arm.segments[Segment::kGirdle].p_distal_B =
        Vector3d(0.0, -L4 * std::sin(alpha), Sign(observations.arm.side) * L4 * std::cos(alpha));
  }
  return prepared;
}

void AddChain(const Observations& observations, Estimate& estimate) {
  std::vector<Vector3d> joint(estimate.time.size(), Vector3d::Zero());
  const std::string root(ProximalJointName(estimate.q_WB.begin()->first));
  if (!root.empty()) estimate.p_W[root] = joint;
  for (const auto& [segment, q_WB] : estimate.q_WB) {
    const Vector3d& d_B = observations.arm.segments.at(segment).p_distal_B;
    for (std::size_t i = 0; i < joint.size(); ++i) joint[i] += q_WB[i] * d_B;
    estimate.p_W[std::string(DistalJointName(segment))] = joint;
  }
}

void AddEpochs(const Observations& observations, const EpochOptions& options, Estimate& estimate) {
  const Tracks tracks = StartTracks(observations);
  const Segment last = estimate.q_WB.rbegin()->first;
  const auto track = static_cast<std::size_t>(TrackOf(tracks, last));
  estimate.diagnostics.epochs = DetectEpochs(tracks, tracks.segments[track], options);
}

}  // namespace

bool BaiKinematicOptions::IsValid(std::string* why) const {
  if (!(bai_girdle_length_m >= 0.0))
    return *why = "bai_girdle_length_m must not be negative", false;
  return filter.IsValid(why) && epochs.IsValid(why);
}

bool BaiKinematic::Accepts(const Observations& observations, std::string* why) const {
  const Observations prepared = Prepared(observations, options_);
  if (prepared.recordings.size() < 2)
    return *why =
               "the chain needs the sensors of two segments or more of girdle, upper arm, forearm "
               "and hand: --method=bai_dead_reckoning_zupt follows one",
           false;
  if (IsWholeChain(prepared, why)) return true;
  if (why->find("mounting") != std::string::npos)
    *why +=
        ", or mark a calibration:static_pose interval of recordings that carry the maker's "
        "orientation (columns q_*)";
  return false;
}

Estimate BaiKinematic::Run(const Observations& observations, const Progress&) const {
  StageClock clock;
  const Observations prepared = Prepared(observations, options_);
  Estimate estimate = GivenAttitudes("bai_kinematic", prepared, options_.filter);
  AddChain(prepared, estimate);
  AddEpochs(prepared, options_.epochs, estimate);
  estimate.diagnostics.notes.push_back(std::string("positions are in world axes from ") +
                                       (estimate.q_WB.contains(Segment::kGirdle)
                                            ? "the lowest neck vertebra"
                                            : "the first segment's proximal joint") +
                                       ", which is taken to stand still");
  estimate.timing.push_back({"chain", clock.Lap()});
  return estimate;
}

}  // namespace brachium
