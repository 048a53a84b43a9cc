// The methods `bai_dead_reckoning` and `bai_dead_reckoning_zupt`: one sensor's position by double
// integration, without and with zero-velocity updates; after Bai et al. (2015), section II.C.2.
//
// Attitudes: given_attitudes.h. Epochs of movement: movement_epochs.h. Integrals and updates:
// zero_velocity_update.h. Starts at rest, at zero. With several recordings the most distal sensor is
// followed and its segment's distal joint is told, by the lever arm; with one alone, the sensor's own
// position.
// Source    Bai, Pepper, Yan, Spurgeon, Sakel & Phillips, IEEE T-NSRE 23 (2015) 232-243.
#pragma once

#include <string>

#include "solver/baselines/luinge.h"
#include "solver/baselines/movement_epochs.h"

namespace brachium {

struct BaiDeadReckoningOptions {
  LuingeUnconstrainedOptions filter;
  EpochOptions epochs;

  bool IsValid(std::string* why) const { return filter.IsValid(why) && epochs.IsValid(why); }

  template <typename Options, typename Visitor>
  static void Visit(Options& options, Visitor&& visit) {
    LuingeUnconstrainedOptions::Visit(options.filter, visit);
    EpochOptions::Visit(options.epochs, visit);
  }
};

struct BaiDeadReckoningZuptOptions : BaiDeadReckoningOptions {};

class BaiDeadReckoning final : public Estimator {
 public:
  explicit BaiDeadReckoning(const BaiDeadReckoningOptions& options)
      : options_(options), updates_(false) {}
  explicit BaiDeadReckoning(const BaiDeadReckoningZuptOptions& options)
      : options_(options), updates_(true) {}
  bool Accepts(const Observations& observations, std::string* why) const override;
  Estimate Run(const Observations& observations, const Progress& progress = {}) const override;

 private:
  BaiDeadReckoningOptions options_;
  bool updates_;
};

}  // namespace brachium
