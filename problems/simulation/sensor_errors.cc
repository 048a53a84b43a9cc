#include "problems/simulation/sensor_errors.h"

#include <algorithm>
#include <utility>

namespace brachium {

SoftTissue TypicalSoftTissue() {
  return {.along_rms = 3 * kDegree, .across_rms = 1.2 * kDegree, .translation_rms = 0.003};
}

SimulationOptions NoErrors() {
  SimulationOptions options;
  options.noise = std::nullopt;
  options.gyro_bias = options.accel_bias = 0.0;
  options.lever_arm_error = options.length_error = 0.0;
  return options;
}

SimulationOptions HonestErrors(const ImuNoise& noise) {
  SimulationOptions options;
  options.noise = noise;
  if (noise.gyro_bias_sigma > MtwNoise().gyro_bias_sigma) options.gyro_bias = 0.7 * kDegree;
  options.scale_error = 0.003;
  options.misalignment = 0.2 * kDegree;
  options.lever_arm_error = 0.015;
  options.mounting_error = 3 * kDegree;
  options.length_error = 0.005;
  options.start_pose_error = 5 * kDegree;
  options.clock_offset = 0.005;
  options.sampling_jitter = 0.0002;
  options.stamp_error = 0.0002;
  options.lost_share = 0.005;
  options.soft_tissue = {.along_rms = 2 * kDegree,
                         .upper_arm_along_rms = 8 * kDegree,
                         .across_rms = 2 * kDegree,
                         .translation_rms = 0.005};
  options.reference_noise = 0.001;
  return options;
}

bool SimulationOptions::IsValid(std::string* why) const {
  const auto fail = [why](const std::string& reason) {
    *why = "simulation." + reason;
    return false;
  };
  const std::pair<const char*, double> sizes[] = {
      {"gyro_bias", gyro_bias},
      {"accel_bias", accel_bias},
      {"scale_error", scale_error},
      {"misalignment", misalignment},
      {"lever_arm_error", lever_arm_error},
      {"mounting_error", mounting_error},
      {"length_error", length_error},
      {"start_pose_error", start_pose_error},
      {"clock_offset", clock_offset},
      {"sampling_jitter", sampling_jitter},
      {"stamp_error", stamp_error},
      {"reference_noise", reference_noise},
      {"soft_tissue.along_rms", soft_tissue.along_rms},
      {"soft_tissue.upper_arm_along_rms", soft_tissue.upper_arm_along_rms},
      {"soft_tissue.across_rms", soft_tissue.across_rms},
      {"soft_tissue.translation_rms", soft_tissue.translation_rms}};
  for (const auto& [name, size] : sizes)
    if (!(size >= 0.0)) return fail(std::string(name) + " must be >= 0");
  if (!(rate > 0.0)) return fail("rate must be > 0 Hz");
  double highest = rate;
  for (const auto& [segment, own] : own_rate) {
    if (!(own > 0.0)) return fail("rate must be > 0 Hz");
    highest = std::max(highest, own);
  }
  if (!(sampling_jitter * highest <= 0.1)) return fail("sampling_jitter must be <= 0.1 / rate");
  if (!(stamp_error * highest <= 0.1)) return fail("stamp_error must be <= 0.1 / rate");
  for (const Segment segment : worn)
    if (segment == Segment::kThorax) return fail("worn: no thorax is simulated");
  if (!(lost_share >= 0.0 && lost_share < 0.5)) return fail("lost_share must lie in [0, 0.5)");
  if (!(soft_tissue.frequency > 0.0)) return fail("soft_tissue.frequency must be > 0 Hz");
  return true;
}

}  // namespace brachium
