#include "solver/baselines/given_attitudes.h"

#include <algorithm>

#include "problems/sampling.h"
#include "solver/baselines/tracks.h"

namespace brachium {
namespace {

Estimate MakersAttitudes(const std::string& method, const Observations& observations) {
  Estimate estimate = BlankEstimate(method, observations, StartTracks(observations));
  estimate.diagnostics.notes = {"the attitudes are the sensor maker's (columns q_*)"};
  for (const Recording& recording : observations.recordings) {
    const Mounting mounting = recording.mounting.value_or(Mounting{});
    auto& q_WB = estimate.q_WB[recording.segment];
    q_WB = Interpolate(SampleTimes(recording.time), recording.q_WS, estimate.time);
    for (Eigen::Quaterniond& q : q_WB) q = q * mounting.q_BS.conjugate();
  }
  return estimate;
}

}  // namespace

Estimate GivenAttitudes(const std::string& method, const Observations& observations,
                        const LuingeUnconstrainedOptions& options) {
  const bool made = std::all_of(observations.recordings.begin(), observations.recordings.end(),
                                [](const Recording& recording) { return !recording.q_WS.empty(); });
  if (made) return MakersAttitudes(method, observations);
  constexpr double kHeadingSigma =
      10 * kDegree;  // iron nearby bends the field; the gyroscope rules
  Estimate estimate = FilterEachSegment(method, observations, options, kHeadingSigma);
  estimate.diagnostics.notes.push_back(
      "the attitudes are those of the 2005 filter (luinge_unconstrained)");
  return estimate;
}

}  // namespace brachium
