#include "solver/baselines/tracks.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "problems/joint_angles.h"
#include "problems/rotation.h"
#include "problems/stillness.h"

namespace brachium {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;

constexpr double kInclinationSpan = 2.0;             // of specific force [s]
constexpr double kInclinationSigma = 2 * kDegree;    // left by the acceleration in that span
constexpr double kEqualHeadingSigma = 45 * kDegree;  // where no start pose was told
constexpr double kFirstHeadingSigma = 1e-3;          // a gauge [rad]
constexpr double kLeastSway = 0.05 * kDegree;        // rms, to and fro, of a segment that rests
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Quaterniond MountingOf(const Recording& recording) {
  return recording.mounting ? recording.mounting->q_BS : Quaterniond::Identity();
}

Recording InSegmentAxes(const Recording& recording) {
  Recording turned = recording;
  const Eigen::Matrix3d R_BS = MountingOf(recording).toRotationMatrix();
  for (Vector3d& gyr : turned.gyr_S) gyr = R_BS * gyr;
  for (Vector3d& acc : turned.acc_S) acc = R_BS * acc;
  for (Vector3d& mag : turned.mag_S) mag = R_BS * mag;
  return turned;
}

Track TrackFrom(const Recording& recording) {
  Recording turned = InSegmentAxes(recording);
  Preintegrator samples(turned);
  return {.recording = std::move(turned), .samples = std::move(samples)};
}

// Mean rate over the rests beside a prior of zero, each weighted by 1/variance. What a rest tells of
// the bias is limited by white noise and by the sway: N²/(2T) + 2 (sway/T)². Whether the rests told
// more than the prior.
bool SetBias(Track& track, const std::vector<RestInterval>& rests) {
  const ImuNoise& noise = track.recording.noise;
  const double prior = 1 / (noise.gyro_bias_sigma * noise.gyro_bias_sigma);
  double weights = prior;
  Vector3d sum = Vector3d::Zero();
  for (const RestInterval& rest : rests) {
    const double T = rest.end - rest.start, sway = std::max(rest.sway, kLeastSway * rest.slack);
    const double variance =
        0.5 * noise.gyro_density * noise.gyro_density / T + 2 * (sway / T) * (sway / T);
    weights += rest.probability / variance;
    sum += rest.mean_rate * (rest.probability / variance);
  }
  track.gyro_bias = sum / weights;
  track.gyro_bias_sigma = 1 / std::sqrt(weights);
  return weights > 2 * prior;
}

void SetInclination(Track& track, double start, double end) {
  const double until = std::min(start + kInclinationSpan, end);
  const Vector3d up_B = track.samples.Sum(start, until, track.gyro_bias).dv.normalized();
  track.q_WB = RotationBetween(up_B, Vector3d::UnitZ());
  const Vector3d x_W = track.q_WB * Vector3d::UnitX();
  track.q_WB =
      Quaterniond(Eigen::AngleAxisd(-std::atan2(x_W.y(), x_W.x()), Vector3d::UnitZ())) * track.q_WB;
  track.inclination_sigma = kInclinationSigma;
}

Quaterniond AttitudeAt(const Track& track, double start, double time) {
  if (time <= start) return track.q_WB;
  return track.q_WB * track.samples.Turn(start, time, track.gyro_bias).dq;
}

// The turn of the forearm about the vertical after which the elbow is nearest to the told pose.
Quaterniond TurnToPose(const Track& upper, const Track& fore, const Observations& observations,
                       double start, double end) {
  const HeldPose& pose = *observations.start_pose;
  const ElbowAngles angles{pose.elbow_flexion.value_or(0.0), observations.arm.elbow.carrying_angle,
                           *pose.forearm_pronation};
  const double time = std::clamp(pose.time, start, end);
  const Quaterniond q_target =
      AttitudeAt(upper, start, time) * ElbowRotation(angles, observations.arm.side);
  const Quaterniond q_turn = q_target * AttitudeAt(fore, start, time).conjugate();
  const double heading = 2 * std::atan2(q_turn.z(), q_turn.w());
  return Quaterniond(Eigen::AngleAxisd(heading, Vector3d::UnitZ()));
}

void SetHeadings(Tracks& tracks, const Observations& observations) {
  auto& segments = tracks.segments;
  for (Track& track : segments) track.heading_sigma = kEqualHeadingSigma;
  std::min_element(segments.begin(), segments.end(), [](const Track& a, const Track& b) {
    return a.recording.segment < b.recording.segment;
  })->heading_sigma = kFirstHeadingSigma;
  if (segments.size() == 1) return;
  const int upper = TrackOf(tracks, Segment::kUpperArm), fore = TrackOf(tracks, Segment::kForearm);
  const auto& pose = observations.start_pose;
  if (upper < 0 || fore < 0 || !pose || !pose->forearm_pronation) {
    tracks.notes.push_back(
        "no start pose: all segments start with the inclination that gravity gives and with the "
        "same heading of their x axes");
    return;
  }
  const Quaterniond q_turn =
      TurnToPose(segments[static_cast<std::size_t>(upper)],
                 segments[static_cast<std::size_t>(fore)], observations, tracks.start, tracks.end);
  for (Track& track : segments)
    if (track.recording.segment >= Segment::kForearm) track.q_WB = q_turn * track.q_WB;
  segments[static_cast<std::size_t>(fore)].heading_sigma = pose->sigma;
  tracks.notes.push_back("the forearm's heading at the start is that of the start pose");
}

}  // namespace

Tracks StartTracks(const Observations& observations, bool bias_from_rests) {
  Tracks tracks;
  tracks.gravity = observations.gravity;
  tracks.start = -std::numeric_limits<double>::infinity();
  tracks.end = std::numeric_limits<double>::infinity();
  for (const Recording& recording : observations.recordings) {
    tracks.segments.push_back(TrackFrom(recording));
    tracks.start = std::max(tracks.start, tracks.segments.back().samples.Begin());
    tracks.end = std::min(tracks.end, tracks.segments.back().samples.End());
  }
  for (Track& track : tracks.segments) {
    const auto rests = DetectRests(track.recording, {});
    for (const RestInterval& rest : rests)
      tracks.rests.push_back({track.recording.segment, rest.start, rest.end, rest.probability});
    if (!SetBias(track, bias_from_rests ? rests : std::vector<RestInterval>{}))
      tracks.notes.push_back("no rest tells the gyro bias of the " +
                             std::string(Name(track.recording.segment)) + ": it starts near zero");
    SetInclination(track, tracks.start, tracks.end);
  }
  SetHeadings(tracks, observations);
  return tracks;
}

int TrackOf(const Tracks& tracks, Segment segment) {
  for (std::size_t i = 0; i < tracks.segments.size(); ++i)
    if (tracks.segments[i].recording.segment == segment) return static_cast<int>(i);
  return -1;
}

Estimate BlankEstimate(const std::string& method, const Observations& observations,
                       const Tracks& tracks) {
  Estimate estimate;
  estimate.method = method;
  estimate.side = observations.arm.side;
  estimate.time = observations.recordings.front().time;
  for (const Track& track : tracks.segments) {
    const Segment segment = track.recording.segment;
    estimate.q_WB[segment].assign(estimate.time.size(), Quaterniond(kNaN, kNaN, kNaN, kNaN));
    const Vector3d bias_S = MountingOf(track.recording).conjugate() * track.gyro_bias;
    const double sd = track.gyro_bias_sigma / kDegree;
    estimate.diagnostics.constants.push_back(
        {std::string(Name(segment)) + ".start_gyro_bias_deg_s",
         {bias_S.x() / kDegree, bias_S.y() / kDegree, bias_S.z() / kDegree},
         {sd, sd, sd}});
  }
  estimate.diagnostics.rests = tracks.rests;
  estimate.diagnostics.notes = tracks.notes;
  return estimate;
}

}  // namespace brachium
