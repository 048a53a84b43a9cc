#include "problems/simulation/wander.h"

#include <algorithm>
#include <cmath>

namespace brachium {
namespace {

constexpr double kAdductionCorrelation = 0.5;  // from one movement to the next
constexpr double kShoulderCorrelation = 0.8;

// One value per movement, after a first for the start: an AR(1) sequence of unit variance.
std::vector<double> UnitWander(std::size_t movements, double correlation, Draws& draws) {
  std::vector<double> x(movements + 1);
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] = i == 0
               ? draws.Normal()
               : correlation * x[i - 1] + std::sqrt(1 - correlation * correlation) * draws.Normal();
  return x;
}

// Shifts and scales to mean zero and exactly that rms.
void Standardise(double rms, std::vector<double>& x) {
  double mean = 0.0, power = 0.0;
  for (const double value : x) mean += value / static_cast<double>(x.size());
  for (const double value : x)
    power += (value - mean) * (value - mean) / static_cast<double>(x.size());
  for (double& value : x) value = rms * (value - mean) / std::sqrt(power);
}

void Add(Joint joint, const std::vector<double>& wander, JointValues& start,
         std::vector<Movement>& movements) {
  start[joint] += wander[0];
  for (std::size_t i = 0; i < movements.size(); ++i) movements[i].target[joint] += wander[i + 1];
}

}  // namespace

void AddWander(const ScenarioOptions& options, double adduction_rms, double shoulder_rms,
               JointValues& start, std::vector<Movement>& movements) {
  if (movements.empty()) return;
  Draws draws(options.seed, "wander");
  const auto wander = [&](double rms, double correlation) {
    std::vector<double> x = UnitWander(movements.size(), correlation, draws);
    if (options.exact_rms)
      Standardise(rms, x);
    else
      for (double& value : x) value *= rms;
    return x;
  };
  Add(kElbowAdduction, wander(adduction_rms, kAdductionCorrelation), start, movements);
  for (const Joint joint : {kShoulderForward, kShoulderUp, kShoulderRight})
    Add(joint, wander(shoulder_rms, kShoulderCorrelation), start, movements);
}

ShoulderModel ShoulderProcess(double shoulder_rms, double mean_step) {
  return {.sigma = shoulder_rms, .correlation_time = -mean_step / std::log(kShoulderCorrelation)};
}

void AddExecutionErrors(const ScenarioOptions& options, std::vector<Movement>& movements) {
  struct Limit {
    Joint joint;
    double low, high;  // [deg]
  };
  constexpr std::array kLimits = {
      Limit{kShoulderFlexion, -50, 170}, Limit{kShoulderAbduction, -30, 170},
      Limit{kShoulderRotation, -80, 90}, Limit{kElbowFlexion, 2, 140},
      Limit{kForearmPronation, 2, 178},  Limit{kWristFlexion, -70, 75},
      Limit{kWristDeviation, -20, 35}};
  if (options.execution_error == 0.0) return;
  Draws draws(options.seed, "execution");
  for (std::size_t i = 0; i + 1 < movements.size(); ++i)
    for (const auto& [joint, low, high] : kLimits) {
      double& target = movements[i].target[joint];
      const double missed = target + options.execution_error * draws.Normal();
      target =
          std::clamp(missed, std::min(target, low * kDegree), std::max(target, high * kDegree));
    }
}

}  // namespace brachium
