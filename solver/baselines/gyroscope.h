// The method `gyroscope`: each segment turns from its start attitude as its gyroscope says, less the
// bias that its rests tell. Nothing else is used: what every other method has to beat.
//
//   R_k+1 = R_k dR(w - b),   dR as in problems/preintegration.h (coning to third order)
//
// A bias left over of 0.01 deg/s turns a segment by 0.6 deg in a minute.
#pragma once

#include <string>

#include "solver/estimator.h"

namespace brachium {

struct GyroscopeOptions {
  bool IsValid(std::string*) const { return true; }

  template <typename Options, typename Visitor>
  static void Visit(Options&, Visitor&&) {}
};

class GyroscopeOnly final : public Estimator {
 public:
  explicit GyroscopeOnly(const GyroscopeOptions&) {}
  bool Accepts(const Observations& observations, std::string* why) const override;
  Estimate Run(const Observations& observations, const Progress& progress = {}) const override;
};

}  // namespace brachium
