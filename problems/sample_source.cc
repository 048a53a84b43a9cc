#include "problems/sample_source.h"

#include <algorithm>

namespace brachium {
namespace {

constexpr std::size_t kAtOnce = 2000;  // samples

void Append(const Recording& from, std::size_t first, std::size_t last, Recording& to) {
  const auto append = [&](const auto& source, auto& target) {
    const auto begin = source.begin();
    target.insert(target.end(), begin + static_cast<std::ptrdiff_t>(first),
                  begin + static_cast<std::ptrdiff_t>(last));
  };
  append(from.time, to.time);
  append(from.gyr_S, to.gyr_S);
  append(from.acc_S, to.acc_S);
}

}  // namespace

Recording SampleSource::Between(double from, double to) {
  while ((held_.time.empty() || held_.time.back() < to) && ReadOn(held_)) {
    if (held_.period == 0.0 && held_.size() > 1) held_.period = SamplingPeriod(held_);
    Forget(from);
  }
  Forget(from);
  const auto beyond = std::ranges::lower_bound(held_.time, to) - held_.time.begin();
  Recording between;
  between.period = held_.period;
  Append(held_, 0, std::min(static_cast<std::size_t>(beyond) + 1, held_.size()), between);
  return between;
}

// All samples but the last at or before that time.
void SampleSource::Forget(double before) {
  const auto later = std::ranges::upper_bound(held_.time, before) - held_.time.begin();
  if (later < 2) return;
  const auto forget = [&](auto& values) {
    values.erase(values.begin(), values.begin() + later - 1);
  };
  forget(held_.time);
  forget(held_.gyr_S);
  forget(held_.acc_S);
}

bool HeldSamples::ReadOn(Recording& held) {
  const std::size_t last = std::min(read_ + kAtOnce, recording_->size());
  if (last == read_) return false;
  Append(*recording_, read_, last, held);
  read_ = last;
  return true;
}

StreamedObservations Streamed(const Observations& observations) {
  StreamedObservations streamed{WithoutSamples(observations), {}};
  for (const Recording& recording : observations.recordings)
    streamed.samples.push_back(std::make_unique<HeldSamples>(
        std::shared_ptr<const Recording>(std::shared_ptr<const Recording>(), &recording)));
  return streamed;
}

Observations WithoutSamples(Observations observations) {
  for (Recording& recording : observations.recordings) {
    Recording told;
    told.segment = recording.segment;
    told.noise = recording.noise;
    told.mounting = recording.mounting;
    recording = std::move(told);
  }
  return observations;
}

}  // namespace brachium
