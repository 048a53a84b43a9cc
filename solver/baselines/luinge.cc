#include "solver/baselines/luinge.h"

#include <cmath>
#include <limits>

#include "solver/baselines/elbow_constraint.h"
#include "solver/baselines/error_state_smoother.h"
#include "solver/baselines/instants.h"
#include "solver/stage_clock.h"
#include "solver/wearing.h"

namespace brachium {
namespace {

template <int kSegments>
using Members = typename InclinationFilter<kSegments>::Members;

// The adduction that the elbow is expected to have, as a sine, and how well that holds.
struct Expectation {
  double sine = 0.0;
  double variance = 0.0;
};

AccelerationModel ModelOf(const LuingeUnconstrainedOptions& options, double gravity) {
  return {options.luinge_acceleration_cutoff_hz, options.luinge_acceleration_sigma_m_s2, gravity};
}

void AddDeviations(const Tracks& tracks, Estimate& estimate) {
  const Eigen::Vector3d nothing =
      Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  for (const Track& track : tracks.segments)
    estimate.sd_B[track.recording.segment].assign(estimate.time.size(), nothing);
}

template <int kSegments>
void Write(const Members<kSegments>& members, const FilterState<kSegments>& state, int output,
           Estimate& estimate) {
  if (output == kNoSample) return;
  const auto at = static_cast<std::size_t>(output);
  for (std::size_t i = 0; i < kSegments; ++i) {
    const Segment segment = members[i]->recording.segment;
    const auto row = static_cast<Eigen::Index>(6 * i);
    estimate.q_WB[segment][at] = state.q_WB[i];
    estimate.sd_B[segment][at] = state.P.diagonal().template segment<3>(row).cwiseSqrt();
  }
}

// World axes of the paper to the segment axes of the filter: θ_W = R θ_B.
void MeasureAdduction(const Expectation& expected, InclinationFilter<2>& filter) {
  const auto& [q_WF, q_WU] = filter.state().q_WB;
  const PredictedAdduction predicted = PredictAdduction(q_WF, q_WU);
  const InclinationFilter<2>::Attitudes<1> H{predicted.H_W.head<3>() * q_WF.toRotationMatrix(),
                                             predicted.H_W.tail<3>() * q_WU.toRotationMatrix()};
  filter.Correct<1>(Eigen::Matrix<double, 1, 1>(predicted.sine - expected.sine), H,
                    Eigen::Matrix<double, 1, 1>(expected.variance));
}

// Runs a filter over all instants; told of each as it is done.
template <int kSegments, typename Measured, typename Done>
void RunForward(const Members<kSegments>& members, const AccelerationModel& model,
                const Tracks& tracks, const std::vector<Instant<kSegments>>& instants,
                Measured&& measured, Done&& done) {
  InclinationFilter<kSegments> filter(members, model, tracks.start);
  for (const Instant<kSegments>& instant : instants) {
    filter.Predict(instant.time);
    for (std::size_t i = 0; i < kSegments; ++i)
      if (instant.samples[i] != kNoSample)
        filter.Measure(i, static_cast<std::size_t>(instant.samples[i]));
    measured(instant, filter);
    done(instant, filter.state());
  }
}

// `measured` adds what the segments of a filter measure together.
template <int kSegments, typename Measured>
void FilterSegments(const Members<kSegments>& members, const AccelerationModel& model,
                    const Tracks& tracks, bool smooths, Measured&& measured, Estimate& estimate) {
  const auto instants = MergeInstants<kSegments>(tracks, members);
  if (!smooths)
    return RunForward<kSegments>(members, model, tracks, instants, measured,
                                 [&](const auto& instant, const auto& state) {
                                   Write<kSegments>(members, state, instant.output, estimate);
                                 });
  std::vector<FilterState<kSegments>> states;
  states.reserve(instants.size());
  RunForward<kSegments>(members, model, tracks, instants, measured,
                        [&](const auto&, const auto& state) { states.push_back(state); });
  SmoothBackwards<kSegments>(members, states);
  for (std::size_t k = 0; k < states.size(); ++k)
    Write<kSegments>(members, states[k], instants[k].output, estimate);
}

constexpr auto kNothingMore = [](const auto&, auto&) {};

void FilterAlone(const Track& track, const AccelerationModel& model, const Tracks& tracks,
                 bool smooths, Estimate& estimate) {
  FilterSegments<1>({&track}, model, tracks, smooths, kNothingMore, estimate);
}

// The heading of the field in W, where every segment has a magnetometer.
std::optional<Eigen::Vector2d> NorthOf(const Tracks& tracks) {
  for (const Track& track : tracks.segments)
    if (track.recording.mag_S.size() != track.recording.size()) return std::nullopt;
  const Track& first = tracks.segments.front();
  for (std::size_t i = 0; i < first.recording.size(); ++i) {
    const double time = first.recording.time[i];
    if (time < tracks.start || !first.recording.mag_S[i].allFinite()) continue;
    const Eigen::Quaterniond q_WB =
        time > tracks.start
            ? first.q_WB * first.samples.Turn(tracks.start, time, first.gyro_bias).dq
            : first.q_WB;
    return (q_WB * first.recording.mag_S[i]).head<2>();
  }
  return std::nullopt;
}

void FilterArm(const Tracks& tracks, const AccelerationModel& model, const Expectation& expected,
               bool smooths, Estimate& estimate) {
  const auto fore = static_cast<std::size_t>(TrackOf(tracks, Segment::kForearm));
  const auto upper = static_cast<std::size_t>(TrackOf(tracks, Segment::kUpperArm));
  FilterSegments<2>(
      {&tracks.segments[fore], &tracks.segments[upper]}, model, tracks, smooths,
      [&](const Instant<2>& instant, InclinationFilter<2>& filter) {
        if (instant.output != kNoSample) MeasureAdduction(expected, filter);
      },
      estimate);
}

}  // namespace

bool LuingeUnconstrainedOptions::IsValid(std::string* why) const {
  if (!(luinge_acceleration_cutoff_hz >= 0.0))
    return *why = "luinge_acceleration_cutoff_hz must not be negative", false;
  if (!(luinge_acceleration_sigma_m_s2 > 0.0))
    return *why = "luinge_acceleration_sigma_m_s2 must be greater than 0", false;
  return true;
}

bool LuingeOptions::IsValid(std::string* why) const {
  if (!(luinge_adduction_sigma_deg > 0.0))
    return *why = "luinge_adduction_sigma_deg must be greater than 0", false;
  return filter.IsValid(why);
}

bool HasHingedElbow(const Observations& observations, std::string* why) {
  for (const Segment needed : {Segment::kUpperArm, Segment::kForearm}) {
    bool found = false;
    for (const Recording& recording : observations.recordings)
      found = found || recording.segment == needed;
    if (found) continue;
    *why =
        "there is no recording of the " + std::string(Name(needed)) +
        ", and the method measures the elbow between two segments: --method=luinge_unconstrained "
        "does without";
    return false;
  }
  if (observations.arm.elbow.adduction_constraint) return true;
  *why =
      "elbow.constraint is none, and the method knows the relative heading from the elbow's "
      "adduction: --method=luinge_unconstrained does without";
  return false;
}

bool LuingeUnconstrained::Accepts(const Observations& observations, std::string* why) const {
  return IsWholeChain(observations, why);
}

Estimate FilterEachSegment(const std::string& method, const Observations& observations,
                           const LuingeUnconstrainedOptions& options,
                           std::optional<double> heading_sigma) {
  StageClock clock;
  const Tracks tracks = StartTracks(observations, options.luinge_bias_from_rests);
  Estimate estimate = BlankEstimate(method, observations, tracks);
  AddDeviations(tracks, estimate);
  estimate.timing.push_back({"start", clock.Lap()});
  const std::optional<Eigen::Vector2d> north =
      heading_sigma ? NorthOf(tracks) : std::optional<Eigen::Vector2d>{};
  if (north) estimate.diagnostics.notes.push_back("the headings are the magnetometers'");
  for (const Track& track : tracks.segments)
    FilterSegments<1>(
        {&track}, ModelOf(options, tracks.gravity), tracks, false,
        [&](const Instant<1>& instant, InclinationFilter<1>& filter) {
          if (!north || instant.samples[0] == kNoSample) return;
          const auto sample = static_cast<std::size_t>(instant.samples[0]);
          filter.MeasureHeading(0, track.recording.mag_S[sample], *north, *heading_sigma);
        },
        estimate);
  estimate.timing.push_back({"filter", clock.Lap()});
  return estimate;
}

Estimate LuingeUnconstrained::Run(const Observations& observations, const Progress&) const {
  return FilterEachSegment("luinge_unconstrained", observations, options_, std::nullopt);
}

bool Luinge::Accepts(const Observations& observations, std::string* why) const {
  return IsWholeChain(observations, why) && HasHingedElbow(observations, why);
}

Estimate Luinge::Run(const Observations& observations, const Progress&) const {
  StageClock clock;
  const Tracks tracks = StartTracks(observations, options_.filter.luinge_bias_from_rests);
  Estimate estimate = BlankEstimate(smooths_ ? "luinge_rts" : "luinge", observations, tracks);
  AddDeviations(tracks, estimate);
  estimate.timing.push_back({"start", clock.Lap()});
  const AccelerationModel model = ModelOf(options_.filter, tracks.gravity);
  const double sigma = options_.luinge_adduction_sigma_deg * kDegree;
  Expectation expected{.variance = sigma * sigma};
  if (options_.luinge_expects_carrying_angle)
    expected.sine = -Sign(observations.arm.side) * std::sin(observations.arm.elbow.carrying_angle);
  FilterArm(tracks, model, expected, smooths_, estimate);
  for (const Track& track : tracks.segments)
    if (const Segment segment = track.recording.segment;
        segment != Segment::kUpperArm && segment != Segment::kForearm)
      FilterAlone(track, model, tracks, smooths_, estimate);
  estimate.timing.push_back({smooths_ ? "filter and smoother" : "filter", clock.Lap()});
  return estimate;
}

}  // namespace brachium
