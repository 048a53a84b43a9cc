// Trials too long to be held: the samples of each recording, handed out forward in time.
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "problems/observations.h"

namespace brachium {

// One recording, of which no more is held than was asked for last and came along with it.
class SampleSource {
 public:
  virtual ~SampleSource() = default;

  virtual double First() const = 0;  // sample [s]
  virtual double Last() const = 0;   // [s]

  // Rates and forces from the last sample at or before `from` to the first one at or after `to`, as
  // far as there are any [s]. `from` must not fall from call to call: what lies before it is
  // forgotten.
  Recording Between(double from, double to);

  // Samples held now.
  std::size_t held() const { return held_.size(); }

 protected:
  // Appends the next samples, a bounded number of them; false where there are none left.
  virtual bool ReadOn(Recording& held) = 0;

 private:
  void Forget(double before);

  Recording held_;  // its period: of the first samples that were read
};

// A recording that lies in memory.
class HeldSamples final : public SampleSource {
 public:
  explicit HeldSamples(std::shared_ptr<const Recording> recording)
      : recording_(std::move(recording)) {}
  double First() const override { return recording_->time.front(); }
  double Last() const override { return recording_->time.back(); }

 private:
  bool ReadOn(Recording& held) override;

  std::shared_ptr<const Recording> recording_;
  std::size_t read_ = 0;
};

// All that a method may see of a long trial.
struct StreamedObservations {
  Observations told;  // everything but samples: those of its recordings are empty
  std::vector<std::unique_ptr<SampleSource>> samples;  // beside told.recordings
};

// `observations` must outlive the result.
StreamedObservations Streamed(const Observations& observations);

Observations WithoutSamples(Observations observations);

}  // namespace brachium
