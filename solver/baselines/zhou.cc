#include "solver/baselines/zhou.h"

#include "solver/baselines/butterworth.h"
#include "solver/baselines/drift_gains.h"
#include "solver/baselines/strapdown.h"
#include "solver/baselines/tracks.h"
#include "solver/stage_clock.h"
#include "solver/wearing.h"

namespace brachium {
namespace {

using Eigen::Vector3d;
using Vectors = std::vector<Vector3d>;

// A filtered signal, or the signal itself where the sampling is too slow for the cutoff.
Vectors FilteredOrNot(const Vectors& signal, const Butterworth& filter, const Track& track,
                      const std::string& what, std::vector<std::string>& notes) {
  const double period = track.samples.Period();
  if (filter.cutoff == 0.0) return signal;
  if (2 * filter.cutoff * period < 1) return Filtered(signal, period, filter);
  notes.push_back("the " + what + " of the " + std::string(Name(track.recording.segment)) +
                  " is not filtered: it is sampled less than twice per period of the cutoff");
  return signal;
}

FreeMotion FilteredMotion(const Track& track, const Tracks& tracks, const ZhouOptions& options,
                          Estimate& estimate) {
  Recording filtered = track.recording;
  Butterworth filter{.order = options.zhou_filter_order, .zero_phase = options.zhou_zero_phase};
  filter.cutoff = options.zhou_lowpass_hz;
  filtered.acc_S =
      FilteredOrNot(filtered.acc_S, filter, track, "acceleration", estimate.diagnostics.notes);
  filter.band = Butterworth::Band::kHigh;
  filter.cutoff = options.zhou_highpass_hz;
  filtered.gyr_S =
      FilteredOrNot(filtered.gyr_S, filter, track, "angular rate", estimate.diagnostics.notes);
  const Vector3d bias = options.zhou_highpass_hz > 0 ? Vector3d::Zero() : track.gyro_bias;
  return IntegrateFreely(Preintegrator(filtered), {tracks.start, track.q_WB, bias, tracks.gravity},
                         tracks.end, estimate.time);
}

// A segment's motion, and where sensor and distal joint lie in it.
struct Link {
  FreeMotion motion;
  Vector3d r_B, d_B;
};

Link LinkOf(Segment segment, const Tracks& tracks, const Observations& observations,
            const ZhouOptions& options, Estimate& estimate) {
  const Track& track = tracks.segments[static_cast<std::size_t>(TrackOf(tracks, segment))];
  return {FilteredMotion(track, tracks, options, estimate), track.recording.mounting->p_BS_B,
          observations.arm.segments.at(segment).p_distal_B};
}

struct DriftingShoulder {
  Vectors A, S;  // see zhou.h
};

DriftingShoulder TwoAccounts(const Link& upper, const Link& fore) {
  DriftingShoulder drifting;
  const Vector3d offset_U = upper.d_B - upper.r_B;
  const auto& q_WU = upper.motion.q_WB;
  const auto& q_WF = fore.motion.q_WB;
  Eigen::Index first = -1;
  for (std::size_t i = 0; i < q_WU.size(); ++i) {
    if (first < 0 && upper.motion.p_W[i].allFinite()) first = static_cast<Eigen::Index>(i);
    const std::size_t start = first < 0 ? i : static_cast<std::size_t>(first);
    const auto change = [&](const auto& q, const Vector3d& v) -> Vector3d {
      return q[i] * v - q[start] * v;
    };
    drifting.A.push_back(upper.motion.p_W[i] - change(q_WU, upper.r_B));
    drifting.S.push_back(fore.motion.p_W[i] - change(q_WF, fore.r_B) -
                         (upper.motion.p_W[i] + change(q_WU, offset_U)));
  }
  return drifting;
}

DriftGains GainsFor(const DriftingShoulder& drifting, const Observations& observations,
                    const ZhouOptions& options, Estimate& estimate) {
  std::vector<Interval> still;
  for (const Interval& interval : observations.intervals)
    if (interval.label == "calibration:shoulder_still") still.push_back(interval);
  const auto learned =
      LearnDriftGains(estimate.time, drifting.A, drifting.S, still, options.zhou_repetitions);
  Diagnostics& diagnostics = estimate.diagnostics;
  if (!learned)
    diagnostics.notes.push_back(
        std::string(still.empty() ? "no calibration:shoulder_still interval"
                                  : "the calibration:shoulder_still intervals tell too little") +
        ": the drift gains are -1/2, as for two sensors that drift alike and independently");
  const DriftGains gains = learned.value_or(DriftGains{});
  const auto list = [](const Vector3d& v) { return std::vector<double>{v.x(), v.y(), v.z()}; };
  diagnostics.constants.push_back(
      {"shoulder.drift_gain", list(gains.value), learned ? list(gains.sd) : std::vector<double>{}});
  if (learned) {
    diagnostics.constants.push_back(
        {"shoulder.drift_gain_95_percent_half_width", list(gains.half_width_95), {}});
    diagnostics.figures.push_back({"shoulder_still_repetitions", 1.0 * gains.repetitions});
  }
  return gains;
}

void WriteJoints(const Link& upper, const Link& fore, const DriftingShoulder& drifting,
                 const Vector3d& gains, Estimate& estimate) {
  Vectors& shoulder = estimate.p_W["shoulder"];
  Vectors& elbow = estimate.p_W["elbow"];
  Vectors& wrist = estimate.p_W["wrist"];
  for (std::size_t i = 0; i < estimate.time.size(); ++i) {
    shoulder.push_back(drifting.A[i] - gains.cwiseProduct(drifting.S[i]));
    elbow.push_back(shoulder.back() + upper.motion.q_WB[i] * upper.d_B);
    wrist.push_back(elbow.back() + fore.motion.q_WB[i] * fore.d_B);
  }
}

bool HasRecordingOf(Segment segment, const Observations& observations) {
  for (const Recording& recording : observations.recordings)
    if (recording.segment == segment) return true;
  return false;
}

}  // namespace

bool ZhouOptions::IsValid(std::string* why) const {
  if (!(zhou_lowpass_hz >= 0.0)) return *why = "zhou_lowpass_hz must not be negative", false;
  if (!(zhou_highpass_hz >= 0.0)) return *why = "zhou_highpass_hz must not be negative", false;
  if (zhou_filter_order < 1 || zhou_filter_order > 8)
    return *why = "zhou_filter_order must be 1 to 8", false;
  if (zhou_repetitions < 3) return *why = "zhou_repetitions must be at least 3", false;
  return true;
}

bool Zhou::Accepts(const Observations& observations, std::string* why) const {
  if (!IsWholeChain(observations, why)) return false;
  for (const Segment needed : {Segment::kUpperArm, Segment::kForearm}) {
    if (HasRecordingOf(needed, observations)) continue;
    *why = "there is no recording of the " + std::string(Name(needed)) +
           ", and the method lets two sensors agree on the shoulder: --method=gyroscope does "
           "without";
    return false;
  }
  return true;
}

Estimate Zhou::Run(const Observations& observations, const Progress&) const {
  StageClock clock;
  Observations arm = observations;
  std::erase_if(arm.recordings, [](const Recording& recording) {
    return recording.segment != Segment::kUpperArm && recording.segment != Segment::kForearm;
  });
  const Tracks tracks = StartTracks(arm);
  Estimate estimate = BlankEstimate("zhou", arm, tracks);
  estimate.time = observations.recordings.front().time;
  const Link upper = LinkOf(Segment::kUpperArm, tracks, arm, options_, estimate);
  const Link fore = LinkOf(Segment::kForearm, tracks, arm, options_, estimate);
  estimate.q_WB[Segment::kUpperArm] = upper.motion.q_WB;
  estimate.q_WB[Segment::kForearm] = fore.motion.q_WB;
  estimate.timing.push_back({"integration", clock.Lap()});
  const DriftingShoulder drifting = TwoAccounts(upper, fore);
  const DriftGains gains = GainsFor(drifting, observations, options_, estimate);
  WriteJoints(upper, fore, drifting, gains.value, estimate);
  if (arm.recordings.size() < observations.recordings.size())
    estimate.diagnostics.notes.push_back(
        "the method knows two sensors: those beyond upper arm and forearm are not used");
  estimate.timing.push_back({"shoulder", clock.Lap()});
  return estimate;
}

}  // namespace brachium
