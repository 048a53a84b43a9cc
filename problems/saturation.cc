#include "problems/saturation.h"

#include <algorithm>
#include <cmath>

namespace brachium {

std::vector<SaturatedRun> FindSaturatedRuns(const std::vector<Eigen::Vector3d>& samples,
                                            double least) {
  constexpr std::size_t kShortest = 3;
  constexpr double kStep = 5e-5;  // of the range: -32768 and 32767 are one limit
  std::vector<SaturatedRun> runs;
  for (int axis = 0; axis < 3; ++axis) {
    double most = 0.0;
    for (const Eigen::Vector3d& v : samples) most = std::max(most, std::abs(v[axis]));
    if (most < least) continue;
    const double limit = (1.0 - kStep) * most;
    for (std::size_t first = 0; first < samples.size();) {
      const double sign = samples[first][axis] < 0.0 ? -1.0 : 1.0;
      std::size_t last = first;
      while (last < samples.size() && sign * samples[last][axis] >= limit) ++last;
      if (last - first >= kShortest) runs.push_back({axis, first, last});
      first = std::max(last, first + 1);
    }
  }
  return runs;
}

double HiddenExcess(const std::vector<double>& time, const std::vector<Eigen::Vector3d>& samples,
                    const SaturatedRun& run) {
  double slope = 0.0;
  const auto consider = [&](std::size_t i) {
    slope = std::max(
        slope, std::abs(samples[i + 1][run.axis] - samples[i][run.axis]) / (time[i + 1] - time[i]));
  };
  for (std::size_t back = 1; back <= 2 && back <= run.first; ++back) consider(run.first - back);
  for (std::size_t i = run.last - 1; i <= run.last && i + 1 < samples.size(); ++i) consider(i);
  return slope * (time[run.last - 1] - time[run.first]) / 4;
}

}  // namespace brachium
