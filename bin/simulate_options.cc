#include "bin/simulate_options.h"

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <string_view>
#include <vector>

#include "bin/flags.h"
#include "io/text.h"

namespace brachium {
namespace {

SoftTissue SoftTissueOf(double along_rms) {
  SoftTissue tissue = TypicalSoftTissue();
  const double factor = along_rms / tissue.along_rms;
  tissue.along_rms *= factor;
  tissue.across_rms *= factor;
  tissue.translation_rms *= factor;
  return tissue;
}

Side SideFrom(const std::string& name) {
  for (const Side side : {Side::kRight, Side::kLeft})
    if (Name(side) == name) return side;
  throw UsageError("--side=" + name + ": right or left was expected");
}

void RequireScenario(const std::string& name) {
  const std::vector<std::string> names = ScenarioNames();
  const std::vector<std::string_view> known(names.begin(), names.end());
  if (std::find(known.begin(), known.end(), name) == known.end())
    throw UsageError("--scenario=" + name + " is not known" + DidYouMean(name, known) +
                     " (known: " + Listed(known) + ")");
}

std::vector<Segment> WornOf(int sensors, const Scenario& scenario) {
  if (sensors == 0) return scenario.worn;
  if (sensors == 2) return {Segment::kUpperArm, Segment::kForearm};
  if (sensors == 4)
    return {Segment::kGirdle, Segment::kUpperArm, Segment::kForearm, Segment::kHand};
  throw UsageError("--sensors=" + std::to_string(sensors) + ": 2 or 4 was expected");
}

// One rate for all sensors, or one for each.
void SetRates(const std::string& text, SimulationOptions& errors) {
  std::vector<double> rates;
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, ',');) {
    char* end = nullptr;
    rates.push_back(std::strtod(word.c_str(), &end));
    if (word.empty() || *end != '\0' || !(rates.back() > 0.0))
      throw UsageError("--rate_hz=" + text + ": numbers above 0 were expected");
  }
  if (rates.empty() || (rates.size() != 1 && rates.size() != errors.worn.size()))
    throw UsageError("--rate_hz=" + text + ": one rate, or one for each of " +
                     std::to_string(errors.worn.size()) + " sensors was expected");
  errors.rate = rates.front();
  for (std::size_t i = 1; i < rates.size(); ++i) errors.own_rate[errors.worn[i]] = rates[i];
}

}  // namespace

ScenarioOptions ScenarioFrom(const MovementFlags& flags, bool draw_errors) {
  RequireScenario(flags.scenario);
  if (flags.seed < 0)
    throw UsageError("--seed=" + std::to_string(flags.seed) + ": 0 or more was expected");
  ScenarioOptions scenario;
  scenario.name = flags.scenario;
  scenario.seed = static_cast<std::uint64_t>(flags.seed);
  scenario.side = SideFrom(flags.side);
  scenario.time_scale = flags.slow;
  scenario.patient_week = flags.patient_week;
  scenario.carrying_angle = flags.carrying_angle_deg * kDegree;
  scenario.carrying_angle_sd = flags.carrying_angle_sd_deg * kDegree;
  scenario.carrying_slope = flags.carrying_slope_deg * kDegree;
  scenario.carrying_slope_sd = flags.carrying_slope_sd_deg * kDegree;
  scenario.adduction_rms = flags.adduction_rms_deg * kDegree;
  scenario.shoulder_rms = flags.shoulder_rms_m;
  scenario.exact_rms = !draw_errors;
  scenario.execution_error = flags.execution_error_deg * kDegree;
  scenario.tremor = flags.tremor_deg * kDegree;
  scenario.duration = flags.duration_s == 0.0 ? UsualDuration(scenario) : flags.duration_s;
  RequireValid(scenario);
  return scenario;
}

SimulationOptions ErrorsFrom(const ErrorFlags& flags, int seed, const Scenario& scenario) {
  SimulationOptions errors;
  errors.seed = static_cast<std::uint64_t>(seed);
  errors.worn = WornOf(flags.sensors, scenario);
  errors.draw_sizes = flags.draw_errors;
  SetRates(flags.rate_hz, errors);
  errors.noise = NoiseFromPreset(flags.noise);
  if (!errors.noise && flags.noise != "none")
    throw UsageError("--noise=" + flags.noise + ": mtw, mtx or none was expected");
  errors.gyro_bias = flags.gyro_bias_deg_s * kDegree;
  errors.accel_bias = flags.accel_bias;
  errors.scale_error = flags.scale_error;
  errors.misalignment = flags.misalignment_deg * kDegree;
  errors.lever_arm_error = flags.lever_arm_error_m;
  errors.mounting_error = flags.mounting_error_deg * kDegree;
  errors.length_error = flags.length_error_m;
  errors.start_pose_error = flags.start_pose_error_deg * kDegree;
  errors.clock_offset = flags.clock_offset_s;
  errors.sampling_jitter = flags.sampling_jitter_s;
  errors.stamp_error = flags.stamp_error_s;
  errors.lost_share = flags.lost_share;
  errors.soft_tissue = SoftTissueOf(flags.soft_tissue_deg * kDegree);
  errors.soft_tissue.upper_arm_along_rms = flags.upper_arm_soft_tissue_deg * kDegree;
  errors.reference_noise = flags.reference_noise_m;
  errors.tell_start_pose = flags.tell_start_pose;
  errors.tell_end_pose = flags.tell_end_pose;
  errors.tell_contacts = flags.tell_contacts;
  errors.tell_mountings = flags.tell_mountings;
  errors.tell_carrying_angle = flags.tell_carrying_angle;
  errors.tell_rests = flags.tell_rests;
  RequireValid(errors);
  return errors;
}

}  // namespace brachium
