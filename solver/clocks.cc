#include "solver/clocks.h"

#include <cmath>

#include "solver/covariance.h"

namespace brachium {
namespace {

// The linear effect of a clock is good for this much of it [s].
constexpr double kReach = 0.005;

// A clock whose sd is smaller than this share of its prior's is told by the movement.
constexpr double kInformed = 1.0 / 3;

// Over less than this a step between two findings is rather their error than a rate [s].
constexpr double kRateTold = 100.0;

}  // namespace

ClocksFound FindClocks(const ArmProblem& problem, const State& state, ChainWorkspace& workspace) {
  ClocksFound found;
  for (int sensor = 0; sensor < problem.size().sensors; ++sensor) {
    const double summed = problem.Interval(0, sensor).clock_offset;
    const double offset = *state.Constant(UnknownKind::kClockOffset, sensor);
    const bool is_far = std::abs(offset - summed) > kReach;
    const bool is_told =
        is_far && DrawnSd(workspace, problem.Constant(UnknownKind::kClockOffset, sensor)) <
                      kInformed * problem.options().clock_offset_sigma_s;
    found.offsets.push_back(is_far && !is_told ? summed : offset);
    found.far = found.far || is_told;
  }
  return found;
}

void ClockRates::Add(double time, const std::vector<double>& offsets) {
  if (first_.empty()) {
    first_ = offsets;
    since_ = time;
  }
  rates_.clear();
  for (std::size_t i = 0; i < offsets.size(); ++i)
    rates_.push_back((offsets[i] - first_[i]) / (time - since_ + kRateTold));
}

std::vector<double> ClockRates::Steps(double seconds) const {
  std::vector<double> steps;
  for (const double rate : rates_) steps.push_back(rate * seconds);
  return steps;
}

}  // namespace brachium
