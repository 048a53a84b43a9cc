#include "solver/baselines/movement_epochs.h"

#include <algorithm>
#include <cmath>

namespace brachium {
namespace {

using Eigen::Vector3d;

constexpr double kSureOfRest = 100.0, kMayOfRest = 10.0;  // times the energy of the rest
constexpr double kFewestCrossings = 3.0;

// Where the cell of a sample ends and the next one begins; a lost sample belongs to neither.
double EdgeAfter(const Recording& recording, std::size_t i, double period) {
  const double half = 0.5 * period;
  if (i + 1 == recording.size()) return recording.time[i] + half;
  return std::min(recording.time[i] + half, 0.5 * (recording.time[i] + recording.time[i + 1]));
}

int CrossingsBetween(const Vector3d& before, const Vector3d& after) {
  return static_cast<int>(((before.array() >= 0) != (after.array() >= 0)).count());
}

bool MayMove(const Frame& frame, const EpochThresholds& thresholds) {
  if (frame.energy > thresholds.sure) return true;
  return frame.energy > thresholds.may && frame.crossings <= thresholds.crossings;
}

// From a sure frame, the farthest frame in steps of `step` that belongs to its movement.
std::size_t Reach(const std::vector<bool>& moves, std::size_t from, int step) {
  const auto last = static_cast<std::ptrdiff_t>(moves.size()) - 1;
  const auto at = [&](std::ptrdiff_t i) {
    return i >= 0 && i <= last && moves[static_cast<std::size_t>(i)];
  };
  std::ptrdiff_t reached = static_cast<std::ptrdiff_t>(from);
  for (std::ptrdiff_t i = reached + step; at(i) || at(i - step); i += step)
    if (at(i) && at(i - step)) reached = i;
  return static_cast<std::size_t>(reached);
}

std::vector<Interval> RestsOf(const Tracks& tracks, Segment segment) {
  std::vector<Interval> rests;
  for (const Rest& rest : tracks.rests)
    if (rest.segment == segment) rests.push_back({"rest", rest.start, rest.end});
  return rests;
}

bool IsWithin(const std::vector<Interval>& intervals, const Frame& frame) {
  return std::any_of(intervals.begin(), intervals.end(), [&](const Interval& interval) {
    return frame.start >= interval.start && frame.end <= interval.end;
  });
}

}  // namespace

bool EpochOptions::IsValid(std::string* why) const {
  if (!(bai_energy_high >= 0.0 && bai_energy_low >= 0.0 && bai_crossings >= 0.0))
    return *why = "bai_energy_high, bai_energy_low and bai_crossings must not be negative", false;
  if (bai_energy_high > 0.0 && !(bai_energy_low < bai_energy_high))
    return *why = "bai_energy_low must be less than bai_energy_high", false;
  return true;
}

std::vector<Frame> FramesOf(const Recording& recording, const Vector3d& gyro_bias) {
  const double period = SamplingPeriod(recording);
  std::vector<Frame> frames;
  double edge = recording.time.front() - 0.5 * period;
  for (std::size_t first = 0; first + kFrameSamples <= recording.size(); first += kFrameSamples) {
    Frame frame{.start = std::max(edge, recording.time[first] - 0.5 * period)};
    for (std::size_t i = first; i < first + kFrameSamples; ++i) {
      const Vector3d s = recording.gyr_S[i] - gyro_bias;
      frame.energy += s.squaredNorm();
      if (i > 0) frame.crossings += CrossingsBetween(recording.gyr_S[i - 1] - gyro_bias, s);
    }
    edge = frame.end = EdgeAfter(recording, first + kFrameSamples - 1, period);
    frames.push_back(frame);
  }
  return frames;
}

EpochThresholds ThresholdsFor(const std::vector<Frame>& frames, const ImuNoise& noise,
                              double period, const std::vector<Interval>& rests,
                              const EpochOptions& options) {
  double energy = 0.0, crossings = 0.0, count = 0.0;
  for (const Frame& frame : frames) {
    if (!IsWithin(rests, frame)) continue;
    energy += frame.energy;
    crossings += frame.crossings;
    ++count;
  }
  const double white = 3.0 * kFrameSamples * noise.gyro_density * noise.gyro_density / (2 * period);
  const double at_rest = std::max(count > 0 ? energy / count : 0.0, white);
  EpochThresholds thresholds{options.bai_energy_high, options.bai_energy_low,
                             options.bai_crossings};
  if (thresholds.may == 0.0)
    thresholds.may = options.bai_energy_high > 0.0
                         ? std::min(kMayOfRest * at_rest, options.bai_energy_high)
                         : kMayOfRest * at_rest;
  if (thresholds.sure == 0.0) thresholds.sure = std::max(kSureOfRest * at_rest, thresholds.may);
  if (thresholds.crossings == 0.0)
    thresholds.crossings = std::max(count > 0 ? crossings / count : 0.0, kFewestCrossings);
  return thresholds;
}

std::vector<std::pair<std::size_t, std::size_t>> FindEpochs(const std::vector<Frame>& frames,
                                                            const EpochThresholds& thresholds) {
  std::vector<bool> moves;
  for (const Frame& frame : frames) moves.push_back(MayMove(frame, thresholds));
  std::vector<std::pair<std::size_t, std::size_t>> epochs;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (!(frames[i].energy > thresholds.sure)) continue;
    const std::size_t first = Reach(moves, i, -1), last = Reach(moves, i, +1);
    if (!epochs.empty() && first <= epochs.back().second + 1)
      epochs.back().second = last;
    else
      epochs.push_back({first, last});
    i = last;
  }
  return epochs;
}

std::vector<Epoch> DetectEpochs(const Tracks& tracks, const Track& track,
                                const EpochOptions& options) {
  const Segment segment = track.recording.segment;
  const std::vector<Frame> frames = FramesOf(track.recording, track.gyro_bias);
  const EpochThresholds thresholds = ThresholdsFor(
      frames, track.recording.noise, track.samples.Period(), RestsOf(tracks, segment), options);
  std::vector<Epoch> epochs;
  for (const auto& [first, last] : FindEpochs(frames, thresholds))
    epochs.push_back({segment, frames[first].start,
                      last + 1 == frames.size() ? track.samples.End() : frames[last].end});
  return epochs;
}

}  // namespace brachium
