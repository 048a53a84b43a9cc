#include "solver/baselines/bai_dead_reckoning.h"

#include <algorithm>

#include "problems/sampling.h"
#include "solver/baselines/given_attitudes.h"
#include "solver/baselines/zero_velocity_update.h"
#include "solver/stage_clock.h"
#include "solver/wearing.h"

namespace brachium {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;

// The most distal sensor first, so that its clock rules.
Observations MostDistalFirst(const Observations& observations) {
  Observations ordered = observations;
  std::stable_sort(ordered.recordings.begin(), ordered.recordings.end(),
                   [](const Recording& a, const Recording& b) { return a.segment > b.segment; });
  return ordered;
}

// Samples of known attitude, segment axes.
struct Path {
  std::vector<double> time;
  std::vector<Quaterniond> q_WB;
  std::vector<Vector3d> a_W;
};

Path PathOf(const Recording& recording, const Estimate& estimate, double gravity) {
  const auto& q_WB = estimate.q_WB.at(recording.segment);
  Path path;
  for (std::size_t i = 0; i < recording.size(); ++i) {
    if (!q_WB[i].coeffs().allFinite()) continue;
    path.time.push_back(recording.time[i]);
    path.q_WB.push_back(q_WB[i]);
    path.a_W.push_back(q_WB[i] * recording.acc_S[i] - gravity * Vector3d::UnitZ());
  }
  return path;
}

// From the sensor to the joint beyond it, displacements from the start.
void MoveToJoint(const Path& path, const Vector3d& lever_B, std::vector<Vector3d>& p_W) {
  for (std::size_t i = 0; i < p_W.size(); ++i)
    p_W[i] += path.q_WB[i] * lever_B - path.q_WB.front() * lever_B;
}

// Everything at other instants than those it was estimated for.
void Resample(const std::vector<double>& time, Estimate& estimate) {
  const SampleTimes from(estimate.time);
  for (auto& [segment, q_WB] : estimate.q_WB) q_WB = Interpolate(from, q_WB, time);
  for (auto& [segment, sd_B] : estimate.sd_B) sd_B = Interpolate(from, sd_B, time);
  for (auto& [name, p_W] : estimate.p_W) p_W = Interpolate(from, p_W, time);
  estimate.time = time;
}

}  // namespace

bool BaiDeadReckoning::Accepts(const Observations& observations, std::string* why) const {
  return IsWholeChain(observations, why);
}

Estimate BaiDeadReckoning::Run(const Observations& observations, const Progress&) const {
  StageClock clock;
  const Observations ordered = MostDistalFirst(observations);
  Estimate estimate = GivenAttitudes(updates_ ? "bai_dead_reckoning_zupt" : "bai_dead_reckoning",
                                     ordered, options_.filter);
  const Tracks tracks = StartTracks(ordered);
  const Recording& recording = tracks.segments.front().recording;
  estimate.diagnostics.epochs = DetectEpochs(tracks, tracks.segments.front(), options_.epochs);

  const Path path = PathOf(recording, estimate, observations.gravity);
  std::vector<Vector3d> v_W = IntegrateOnce(path.time, path.a_W);
  if (updates_) UpdateZeroVelocity(path.time, estimate.diagnostics.epochs, v_W);
  std::vector<Vector3d> p_W = IntegrateOnce(path.time, v_W);
  const bool alone = observations.recordings.size() == 1;
  if (!alone)
    MoveToJoint(path,
                ordered.arm.segments.at(recording.segment).p_distal_B - recording.mounting->p_BS_B,
                p_W);
  const std::string name(alone ? Name(recording.segment) : DistalJointName(recording.segment));
  estimate.p_W[name] = Interpolate(SampleTimes(path.time), p_W, estimate.time);
  Resample(observations.recordings.front().time, estimate);
  estimate.diagnostics.notes.push_back("positions start at zero; followed is the sensor of the " +
                                       std::string(Name(recording.segment)));
  estimate.timing.push_back({"dead reckoning", clock.Lap()});
  return estimate;
}

}  // namespace brachium
