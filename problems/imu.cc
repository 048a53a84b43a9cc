#include "problems/imu.h"

#include <algorithm>

namespace brachium {

ImuNoise MtwNoise() { return {}; }

ImuNoise MtxNoise() {
  return {.gyro_density = 0.075 * kDegree,
          .gyro_bias_sigma = 1.0 * kDegree,
          .gyro_bias_walk = 5e-3 * kDegree,
          .accel_density = 0.0025,
          .accel_bias_sigma = 0.05};
}

std::optional<ImuNoise> NoiseFromPreset(const std::string& name) {
  if (name == "mtw") return MtwNoise();
  if (name == "mtx") return MtxNoise();
  return std::nullopt;
}

double SamplingPeriod(const Recording& recording) {
  if (recording.period > 0.0) return recording.period;
  std::vector<double> steps;
  steps.reserve(recording.size());
  for (std::size_t i = 1; i < recording.size(); ++i)
    steps.push_back(recording.time[i] - recording.time[i - 1]);
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

}  // namespace brachium
