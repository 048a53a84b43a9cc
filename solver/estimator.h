// The interface that every method shares: observations in, estimate out.
#pragma once

#include <functional>
#include <string>

#include "problems/estimate.h"
#include "problems/observations.h"

namespace brachium {

// Told what is being done and how much of it is done (0 to 1), for a progress line.
using Progress = std::function<void(const std::string& stage, double done)>;

// Stateless, deterministic, offline: the same observations give the same estimate, bit for bit.
class Estimator {
 public:
  virtual ~Estimator() = default;

  // Whether the method can use these observations; if not, `why` says what is missing and how to
  // get it.
  virtual bool Accepts(const Observations& observations, std::string* why) const = 0;

  // Requires Accepts().
  virtual Estimate Run(const Observations& observations, const Progress& progress = {}) const = 0;
};

}  // namespace brachium
