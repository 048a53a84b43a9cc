// The instants at which a filter of several sensors stops: every sample of each, in order of time,
// and every sample of the first recording, where the estimate is asked for.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "solver/baselines/tracks.h"

namespace brachium {

inline constexpr int kNoSample = -1;

template <int kSegments>
struct Instant {
  double time = 0.0;                   // [s]
  std::array<int, kSegments> samples;  // of each member at this instant, or kNoSample
  int output = kNoSample;              // of the first recording
};

// Within the span of the tracks; samples less than a nanosecond apart share an instant.
template <int kSegments>
std::vector<Instant<kSegments>> MergeInstants(const Tracks& tracks,
                                              const std::array<const Track*, kSegments>& members) {
  constexpr double kSame = 1e-9;
  const auto& outputs = tracks.segments.front().recording.time;
  std::vector<double> times = outputs;
  for (const Track* member : members)
    times.insert(times.end(), member->recording.time.begin(), member->recording.time.end());
  std::sort(times.begin(), times.end());

  std::array<std::size_t, kSegments + 1> next{};
  const auto take = [&](std::size_t i, const std::vector<double>& series, double until) {
    int taken = kNoSample;
    for (; next[i] < series.size() && series[next[i]] <= until; ++next[i])
      taken = static_cast<int>(next[i]);
    return taken;
  };
  std::vector<Instant<kSegments>> instants;
  for (const double time : times) {
    if (time > tracks.end || (!instants.empty() && time < instants.back().time + kSame)) continue;
    Instant<kSegments> instant{.time = time, .samples = {}};
    for (std::size_t i = 0; i < kSegments; ++i)
      instant.samples[i] = take(i, members[i]->recording.time, time + kSame);
    instant.output = take(kSegments, outputs, time + kSame);
    if (time >= tracks.start) instants.push_back(instant);
  }
  return instants;
}

}  // namespace brachium
