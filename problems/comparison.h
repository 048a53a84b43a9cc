// Several methods on the same trials, side by side.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "problems/evaluation.h"

namespace brachium {

// One method on one trial.
struct ComparedPair {
  enum class Outcome {
    kDone,
    kRefused,     // the method cannot use this trial, or tells nothing that its reference knows
    kFailed,      // it could, but came to no estimate
    kUnreadable,  // the trial is wrong, or has nothing to compare with
  };
  std::string trial{}, method{};
  Outcome outcome = Outcome::kDone;
  std::string reason{};     // why it was refused, failed or is not to be trusted
  bool trusted = true;      // kDone: converged, and not singular
  Evaluation evaluation{};  // kDone only
  bool reused = false;      // from an estimate that was there before
  double seconds = 0.0;     // that it took
};

// Each method on each trial: trial by trial, the methods in their order.
struct Comparison {
  std::vector<std::string> trials, methods;
  std::vector<ComparedPair> pairs;

  const ComparedPair& At(std::size_t trial, std::size_t method) const {
    return pairs[trial * methods.size() + method];
  }
};

// "done", "refused", "failed", "unreadable".
std::string NameOf(ComparedPair::Outcome outcome);

}  // namespace brachium
