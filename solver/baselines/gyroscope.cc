#include "solver/baselines/gyroscope.h"

#include "solver/baselines/tracks.h"
#include "solver/stage_clock.h"
#include "solver/wearing.h"

namespace brachium {

bool GyroscopeOnly::Accepts(const Observations& observations, std::string* why) const {
  return IsWholeChain(observations, why);
}

Estimate GyroscopeOnly::Run(const Observations& observations, const Progress&) const {
  StageClock watch;
  const Tracks tracks = StartTracks(observations);
  Estimate estimate = BlankEstimate("gyroscope", observations, tracks);
  for (const Track& track : tracks.segments) {
    std::vector<Eigen::Quaterniond>& q_WB = estimate.q_WB[track.recording.segment];
    Eigen::Quaterniond q = track.q_WB;
    double time = tracks.start;
    for (std::size_t i = 0; i < q_WB.size(); ++i) {
      if (estimate.time[i] < tracks.start || estimate.time[i] > tracks.end) continue;
      q = (q * track.samples.Turn(time, estimate.time[i], track.gyro_bias).dq).normalized();
      time = estimate.time[i];
      q_WB[i] = q;
    }
  }
  estimate.timing.push_back({"integration", watch.Lap()});
  return estimate;
}

}  // namespace brachium
