#include "problems/stillness.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace brachium {
namespace {

using Eigen::Vector3d;

constexpr double kRestless = 1e9;
constexpr double kStill = 2.0;       // of the statistic
constexpr double kEdgeFactor = 4.0;  // of the stillest window's statistic, at the edges of a rest
constexpr double kStillEdge = 0.1;   // an edge is still enough below it, if the sensor has no noise
constexpr double kScaleError = 0.01;  // of an accelerometer
constexpr double kCertainly = 3.0;    // standard deviations

double Square(double x) { return x * x; }

// Running sums of a signal and its square: mean and variance of any window in constant time.
class RunningMoments {
 public:
  explicit RunningMoments(const std::vector<Vector3d>& signal)
      : origin_(signal.front()), sum_{Vector3d::Zero()}, square_{0.0} {
    for (const Vector3d& value : signal) {
      sum_.push_back(sum_.back() + (value - origin_));
      square_.push_back(square_.back() + (value - origin_).squaredNorm());
    }
  }
  Vector3d Mean(std::size_t begin, std::size_t end) const {
    return origin_ + (sum_[end] - sum_[begin]) / static_cast<double>(end - begin);
  }
  // Mean of |value - about|² over [begin, end).
  double Spread(std::size_t begin, std::size_t end, const Vector3d& about) const {
    const Vector3d mean = Mean(begin, end) - origin_;
    const double variance =
        (square_[end] - square_[begin]) / static_cast<double>(end - begin) - mean.squaredNorm();
    return std::max(variance, 0.0) + (mean + origin_ - about).squaredNorm();
  }

 private:
  Vector3d origin_;
  std::vector<Vector3d> sum_;
  std::vector<double> square_;
};

struct Tolerances {
  double rate_squared, force_squared;  // for a rest of this recording
  double slack_squared;                // the larger of their ratios to those of a still person
};

// What a rest may show: real motion, and the sensor's white noise at its sampling rate.
Tolerances TolerancesOf(const Recording& recording, const RunningMoments& rate,
                        const RunningMoments& force, const StillnessOptions& options) {
  const double bandwidth = 0.5 / SamplingPeriod(recording);
  const ImuNoise& noise = recording.noise;
  const double still_rate = Square(options.rate_deg_s * kDegree),
               still_force = Square(options.force);
  const std::size_t n = recording.size();
  const double share = Square(options.share_of_motion);
  const double rate_squared = std::max(still_rate, share * rate.Spread(0, n, rate.Mean(0, n)));
  const double force_squared = std::max(still_force, share * force.Spread(0, n, force.Mean(0, n)));
  return {rate_squared + 3 * Square(noise.gyro_density) * bandwidth,
          force_squared + 3 * Square(noise.accel_density) * bandwidth,
          std::max(rate_squared / still_rate, force_squared / still_force)};
}

// Mean rate of the second in which rate and force vary least: the bias, if that second is a rest.
Vector3d QuietestBias(const Recording& recording, const RunningMoments& rate,
                      const RunningMoments& force, const Tolerances& tolerances) {
  const auto width = static_cast<std::size_t>(std::ceil(1.0 / SamplingPeriod(recording)));
  if (recording.size() < width) return Vector3d::Zero();
  double least = 2.0;
  Vector3d bias = Vector3d::Zero();
  for (std::size_t begin = 0; begin + width <= recording.size(); begin += width / 8 + 1) {
    const std::size_t end = begin + width;
    const Vector3d mean = rate.Mean(begin, end);
    if (mean.norm() > 4 * recording.noise.gyro_bias_sigma) continue;
    const double statistic =
        rate.Spread(begin, end, mean) / tolerances.rate_squared +
        force.Spread(begin, end, force.Mean(begin, end)) / tolerances.force_squared;
    if (statistic >= least) continue;
    least = statistic;
    bias = mean;
  }
  return bias;
}

double Logistic(double statistic) { return 1 / (1 + std::exp(statistic - kStill)); }

// rms per axis of the integrated rate after its straight line is taken off [rad].
double Sway(const Recording& recording, std::size_t begin, std::size_t end, const Vector3d& mean) {
  Vector3d angle = Vector3d::Zero(), sum = Vector3d::Zero();
  double squares = 0.0;
  for (std::size_t i = begin + 1; i < end; ++i) {
    const double step = recording.time[i] - recording.time[i - 1];
    angle += step * (0.5 * (recording.gyr_S[i] + recording.gyr_S[i - 1]) - mean);
    sum += angle;
    squares += angle.squaredNorm();
  }
  const double n = static_cast<double>(end - begin);
  return std::sqrt(std::max(0.0, squares / n - (sum / n).squaredNorm()) / 3);
}

// At rest nothing but gravity is felt.
bool ShowsGravity(const ImuNoise& noise, const Vector3d& mean_force, const Tolerances& tolerances) {
  const double variance =
      Square(noise.accel_bias_sigma) + Square(kScaleError * kGravity) + tolerances.force_squared;
  return std::abs(mean_force.norm() - kGravity) < kCertainly * std::sqrt(variance);
}

RestInterval Describe(const Recording& recording, std::size_t begin, std::size_t end,
                      double probability) {
  RestInterval rest;
  rest.start = recording.time[begin];
  rest.end = recording.time[end - 1];
  rest.probability = probability;
  for (std::size_t i = begin; i < end; ++i) {
    rest.mean_rate += recording.gyr_S[i];
    rest.mean_force += recording.acc_S[i];
  }
  rest.mean_rate /= static_cast<double>(end - begin);
  rest.mean_force /= static_cast<double>(end - begin);
  rest.sway = Sway(recording, begin, end, rest.mean_rate);
  return rest;
}

// A rest of mean statistic T: the quieter, the less of the tolerance it used.
RestInterval Judge(const Recording& recording, std::size_t begin, std::size_t end, double T,
                   const Tolerances& tolerances) {
  RestInterval rest = Describe(recording, begin, end, Logistic(T));
  rest.slack = std::max(1.0, std::sqrt(tolerances.slack_squared * T / 2));
  return rest;
}

// Samples [begin, end).
struct Run {
  std::size_t begin = 0, end = 0;
};

class RestSearch {
 public:
  RestSearch(const Recording& recording, const StillnessOptions& options)
      : recording_(recording),
        options_(options),
        period_(SamplingPeriod(recording)),
        rate_(recording.gyr_S),
        force_(recording.acc_S),
        tolerances_(TolerancesOf(recording, rate_, force_, options)),
        bias_(QuietestBias(recording, rate_, force_, tolerances_)),
        statistic_(StatisticOfSamples()) {}

  std::vector<RestInterval> Rests() const {
    std::vector<RestInterval> rests;
    for (Run run; NextRun(run);) {
      const Run rest = Trimmed(run);
      if (recording_.time[rest.end - 1] - recording_.time[rest.begin] >= options_.shortest_s &&
          ShowsGravity(recording_.noise, force_.Mean(rest.begin, rest.end), tolerances_))
        rests.push_back(Judge(recording_, rest.begin, rest.end, MeanStatistic(rest), tolerances_));
    }
    return rests;
  }

 private:
  double Statistic(std::size_t begin, std::size_t end, const Vector3d& mean_force) const {
    return rate_.Spread(begin, end, bias_) / tolerances_.rate_squared +
           force_.Spread(begin, end, mean_force) / tolerances_.force_squared;
  }

  // A sample is as still as the stillest window that holds it.
  std::vector<double> StatisticOfSamples() const {
    const std::size_t n = recording_.size();
    const auto half =
        std::max<std::size_t>(2, static_cast<std::size_t>(options_.window_s / period_ / 2));
    std::vector<double> statistic(n, kRestless);
    for (std::size_t begin = 0; begin + 2 * half + 1 <= n; ++begin) {
      const std::size_t end = begin + 2 * half + 1;
      if (recording_.time[end - 1] - recording_.time[begin] > 2 * options_.window_s)
        continue;  // a gap
      const double T = Statistic(begin, end, force_.Mean(begin, end));
      if (T > kStill) continue;
      for (std::size_t i = begin; i < end; ++i) statistic[i] = std::min(statistic[i], T);
    }
    return statistic;
  }

  // The next still samples without a gap after those of `run`; false where there are none.
  bool NextRun(Run& run) const {
    const std::size_t n = recording_.size();
    std::size_t begin = run.end;
    while (begin < n && statistic_[begin] > kStill) ++begin;
    std::size_t end = begin;
    while (end < n && statistic_[end] <= kStill &&
           (end == begin || recording_.time[end] - recording_.time[end - 1] < 3 * period_))
      ++end;
    run = {begin, end};
    return begin < n;
  }

  // Without the movement that windows took along at the edges of a rest: each edge is about as still
  // as the rest is at its stillest.
  Run Trimmed(Run run) const {
    const auto edge = std::max<std::size_t>(3, static_cast<std::size_t>(options_.edge_s / period_));
    const Vector3d mean_force = force_.Mean(run.begin, run.end);
    const double stillest = *std::min_element(At(run.begin), At(run.end));
    const double tolerated = std::clamp(kEdgeFactor * stillest, kStillEdge, kStill);
    while (run.end - run.begin > edge &&
           Statistic(run.begin, run.begin + edge, mean_force) > tolerated)
      ++run.begin;
    while (run.end - run.begin > edge && Statistic(run.end - edge, run.end, mean_force) > tolerated)
      --run.end;
    return run;
  }

  double MeanStatistic(const Run& run) const {
    return std::accumulate(At(run.begin), At(run.end), 0.0) /
           static_cast<double>(run.end - run.begin);
  }

  std::vector<double>::const_iterator At(std::size_t sample) const {
    return statistic_.begin() + static_cast<std::ptrdiff_t>(sample);
  }

  const Recording& recording_;
  const StillnessOptions& options_;
  double period_;
  RunningMoments rate_, force_;
  Tolerances tolerances_;
  Vector3d bias_;
  std::vector<double> statistic_;
};

}  // namespace

std::vector<RestInterval> DetectRests(const Recording& recording, const StillnessOptions& options) {
  return RestSearch(recording, options).Rests();
}

RestInterval PartOfRest(const Recording& recording, const RestInterval& rest, double start,
                        double end) {
  const auto& time = recording.time;
  const auto at = [&](double t) {
    return static_cast<std::size_t>(std::lower_bound(time.begin(), time.end(), t) - time.begin());
  };
  const std::size_t first = at(std::max(start, rest.start));
  const std::size_t last = at(std::nextafter(std::min(end, rest.end), 1e300));
  if (last < first + 3) return {.probability = 0.0};
  RestInterval part = Describe(recording, first, last, rest.probability);
  part.slack = rest.slack;
  return part;
}

}  // namespace brachium
