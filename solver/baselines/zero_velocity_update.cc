#include "solver/baselines/zero_velocity_update.h"

#include <algorithm>

namespace brachium {

using Eigen::Vector3d;
using Vectors = std::vector<Vector3d>;

Vectors IntegrateOnce(const std::vector<double>& time, const Vectors& rate) {
  Vectors integral(time.size(), Vector3d::Zero());
  for (std::size_t i = 1; i < time.size(); ++i)
    integral[i] = integral[i - 1] + 0.5 * (time[i] - time[i - 1]) * (rate[i - 1] + rate[i]);
  return integral;
}

void UpdateZeroVelocity(const std::vector<double>& time, const std::vector<Epoch>& epochs,
                        Vectors& v_W) {
  const Vectors drifting = v_W;
  std::fill(v_W.begin(), v_W.end(), Vector3d::Zero());
  for (const Epoch& epoch : epochs) {
    // The last sample before the epoch and the first one after it: both stand.
    const auto after_start = std::upper_bound(time.begin(), time.end(), epoch.start);
    const auto first = std::max<std::ptrdiff_t>(after_start - time.begin() - 1, 0);
    const auto end = std::lower_bound(time.begin(), time.end(), epoch.end) - time.begin();
    const bool comes_to_rest = end < static_cast<std::ptrdiff_t>(time.size());
    const auto last = static_cast<std::size_t>(comes_to_rest ? end : end - 1);
    const auto begin = static_cast<std::size_t>(first);
    const Vector3d slope =
        comes_to_rest ? Vector3d((drifting[last] - drifting[begin]) / (time[last] - time[begin]))
                      : Vector3d::Zero();
    for (std::size_t i = begin; i <= last; ++i)
      v_W[i] = drifting[i] - drifting[begin] - slope * (time[i] - time[begin]);
  }
}

}  // namespace brachium
