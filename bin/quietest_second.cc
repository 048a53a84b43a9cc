#include "bin/quietest_second.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace brachium {
namespace {

using Eigen::Vector3d;

// Samples [first, last) of a series: sums from which means and variances come at once. The first
// sample is taken off, so that large constants do not drown small variances.
class RunningSums {
 public:
  explicit RunningSums(const std::vector<Vector3d>& series) : origin_(series.front()) {
    sums_.reserve(series.size() + 1);
    squares_.reserve(series.size() + 1);
    sums_.push_back(Vector3d::Zero());
    squares_.push_back(0.0);
    for (const Vector3d& value : series) {
      sums_.push_back(sums_.back() + value - origin_);
      squares_.push_back(squares_.back() + (value - origin_).squaredNorm());
    }
  }

  Vector3d Mean(std::size_t first, std::size_t last) const {
    return origin_ + (sums_[last] - sums_[first]) / static_cast<double>(last - first);
  }

  double Rms(std::size_t first, std::size_t last) const {
    const double count = static_cast<double>(last - first);
    const double variance =
        (squares_[last] - squares_[first]) / count - (Mean(first, last) - origin_).squaredNorm();
    return std::sqrt(std::max(0.0, variance / 3));
  }

 private:
  Vector3d origin_;
  std::vector<Vector3d> sums_;
  std::vector<double> squares_;
};

}  // namespace

QuietestSecond FindQuietestSecond(const Recording& recording) {
  constexpr double kSecond = 1.0;
  constexpr double kCovered = 0.8;  // share of the samples that a second must hold
  const auto needed = static_cast<std::size_t>(std::min(
      static_cast<double>(recording.size()), kCovered * kSecond / SamplingPeriod(recording)));
  const std::vector<double>& time = recording.time;
  const RunningSums rate(recording.gyr_S), force(recording.acc_S);
  QuietestSecond quietest{.rate_noise = std::numeric_limits<double>::infinity()};
  for (std::size_t first = 0, last = 0; last < time.size(); ++first) {
    while (last < time.size() && time[last] < time[first] + kSecond) ++last;
    if (last - first < needed || rate.Rms(first, last) >= quietest.rate_noise) continue;
    quietest = {time[first], rate.Mean(first, last), force.Mean(first, last), rate.Rms(first, last),
                force.Rms(first, last)};
  }
  return quietest;
}

}  // namespace brachium
