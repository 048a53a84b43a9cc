#include "problems/movement_outcomes.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "problems/arm_angles.h"
#include "problems/arm_model.h"
#include "problems/rotation.h"
#include "problems/sampling.h"
#include "problems/smoothness.h"
#include "problems/statistics.h"

namespace brachium {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;

constexpr double kNaN = Statistics::kUnknown;
constexpr double kCutoff = 10.0;            // -3 dB [Hz]
constexpr double kGaussian = 0.1325;        // sqrt(ln 2)/(2 pi): its sd [s] times the cutoff [Hz]
constexpr double kMovingShare = 0.05;       // of the usual top speed
constexpr double kUsualTop = 0.95;          // quantile
constexpr double kLeastSpeed = 0.01;        // [m/s]
constexpr double kLeastRate = 3 * kDegree;  // [rad/s]
constexpr double kLongestPause = 0.1, kShortest = 0.2;  // [s]
constexpr double kDirectShare = 0.01;  // of the path: the least straight way a ratio is taken of
constexpr double kOutermost = 0.01;    // part of the samples beyond a range on either side

// What moves, evenly sampled: places, and the rate of change at each.
struct Track {
  double start = 0.0, step = 0.0;  // [s]
  std::vector<Vector3d> place;     // of a point; otherwise empty
  std::vector<double> speed;       // NaN at gaps and at ends

  double Time(std::size_t i) const { return start + step * static_cast<double>(i); }
};

std::vector<double> EvenTimes(const SampleTimes& times) {
  std::vector<double> even;
  const double span = times.time().back() - times.time().front();
  const auto n = static_cast<std::size_t>(std::floor(span / times.step() + 1e-6)) + 1;
  for (std::size_t i = 0; i < n; ++i)
    even.push_back(times.time().front() + times.step() * static_cast<double>(i));
  return even;
}

// A Gaussian over the known neighbours; what is unknown stays so.
template <typename Value>
std::vector<Value> Smoothed(const std::vector<Value>& series, double step, const Value& zero) {
  const double sd = kGaussian / kCutoff / step;  // [samples]
  const auto reach = static_cast<std::ptrdiff_t>(std::ceil(4.0 * sd));
  const auto n = static_cast<std::ptrdiff_t>(series.size());
  std::vector<double> weights;  // by distance
  for (std::ptrdiff_t j = 0; j <= reach; ++j)
    weights.push_back(std::exp(-0.5 * std::pow(static_cast<double>(j) / sd, 2)));
  std::vector<Value> smooth = series;
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    Value sum = zero;
    double total = 0.0;
    const std::ptrdiff_t half = std::min({reach, i, n - 1 - i});
    for (std::ptrdiff_t j = i - half; j <= i + half; ++j) {
      const double weight = weights[static_cast<std::size_t>(std::abs(j - i))];
      sum += weight * series[static_cast<std::size_t>(j)];
      total += weight;
    }
    smooth[static_cast<std::size_t>(i)] = sum / total;
  }
  return smooth;
}

Track TrackOf(const SampleTimes& times, const std::vector<Vector3d>& points) {
  Track track{.start = times.time().front(), .step = times.step(), .place = {}, .speed = {}};
  track.place = Smoothed<Vector3d>(Interpolate(times, points, EvenTimes(times)), track.step,
                                   Vector3d::Zero());
  track.speed.assign(track.place.size(), kNaN);
  for (std::size_t i = 1; i + 1 < track.place.size(); ++i)
    track.speed[i] = (track.place[i + 1] - track.place[i - 1]).norm() / (2.0 * track.step);
  return track;
}

Track TrackOf(const SampleTimes& times, const std::vector<Quaterniond>& attitudes) {
  Track track{.start = times.time().front(), .step = times.step(), .place = {}, .speed = {}};
  const auto even = Interpolate(times, attitudes, EvenTimes(times));
  std::vector<Vector3d> rates(even.size(), Vector3d::Constant(kNaN));
  for (std::size_t i = 1; i + 1 < even.size(); ++i)
    if (even[i - 1].coeffs().allFinite() && even[i + 1].coeffs().allFinite())
      rates[i] =
          even[i] * Log(Quaterniond(even[i - 1].conjugate() * even[i + 1])) / (2.0 * track.step);
  for (const Vector3d& rate : Smoothed<Vector3d>(rates, track.step, Vector3d::Zero()))
    track.speed.push_back(rate.norm());
  return track;
}

struct Part {
  std::size_t first = 0, end = 0;
};

// Runs above the threshold, short pauses bridged but never gaps, short runs dropped.
std::vector<Part> MovingParts(const Track& track, double threshold) {
  std::vector<Part> parts;
  bool known_since = false;
  for (std::size_t i = 0; i < track.speed.size(); ++i) {
    if (std::isnan(track.speed[i])) known_since = false;
    if (!(track.speed[i] > threshold)) continue;
    const bool goes_on = !parts.empty() && known_since &&
                         static_cast<double>(i - parts.back().end) * track.step < kLongestPause;
    if (!goes_on) parts.push_back({i, i});
    parts.back().end = i + 1;
    known_since = true;
  }
  std::erase_if(parts, [&](const Part& part) {
    return static_cast<double>(part.end - part.first) * track.step < kShortest;
  });
  return parts;
}

MovementEpoch EpochOf(const Track& track, const Part& part) {
  const std::vector<double> speed(track.speed.begin() + static_cast<std::ptrdiff_t>(part.first),
                                  track.speed.begin() + static_cast<std::ptrdiff_t>(part.end));
  const auto peak = std::max_element(speed.begin(), speed.end());
  MovementEpoch epoch{.start = track.Time(part.first), .end = track.Time(part.end - 1)};
  epoch.peak_speed = *peak;
  epoch.time_to_peak = track.step * static_cast<double>(peak - speed.begin());
  epoch.speed_peaks = SpeedPeaks(speed);
  epoch.spectral_arc_length = SpectralArcLength(speed, 1.0 / track.step);
  epoch.log_jerk = LogDimensionlessJerk(speed, 1.0 / track.step);
  for (const double v : speed) epoch.path += v * track.step;
  if (track.place.empty()) return epoch;
  const double straight = (track.place[part.end - 1] - track.place[part.first]).norm();
  if (straight > kDirectShare * epoch.path) epoch.path_ratio = epoch.path / straight;
  return epoch;
}

std::vector<MovementEpoch> EpochsOf(const Track& track, double least_speed) {
  const double threshold = std::max(least_speed, kMovingShare * Quantile(track.speed, kUsualTop));
  std::vector<MovementEpoch> epochs;
  for (const Part& part : MovingParts(track, threshold)) epochs.push_back(EpochOf(track, part));
  return epochs;
}

template <typename Series, typename At>
std::vector<double> Column(const Series& series, const At& at) {
  std::vector<double> values;
  for (const auto& value : series) values.push_back(at(value));
  return values;
}

// The greatest known value; NaN without one.
double Greatest(const std::vector<double>& values) { return Quantile(values, 1.0); }

Vector3d MedianOf(const std::vector<Vector3d>& vectors) {
  Vector3d median;
  for (int axis = 0; axis < 3; ++axis)
    median[axis] = Quantile(Column(vectors, [&](const Vector3d& v) { return v[axis]; }), 0.5);
  return median;
}

std::optional<double> KnownOnly(double value) {
  return std::isnan(value) ? std::nullopt : std::optional(value);
}

std::optional<double> RangeOfPoint(const std::vector<Vector3d>& points) {
  const Vector3d median = MedianOf(points);
  return KnownOnly(
      Greatest(Column(points, [&](const Vector3d& p) { return (p - median).norm(); })));
}

std::optional<double> TiltOf(const std::vector<Quaterniond>& attitudes) {
  std::vector<Vector3d> up_B;
  for (const Quaterniond& q_WB : attitudes) up_B.push_back(q_WB.conjugate() * Vector3d::UnitZ());
  const Vector3d median = MedianOf(up_B).normalized();
  return KnownOnly(Greatest(Column(up_B, [&](const Vector3d& up) {
    return std::atan2(up.cross(median).norm(), up.dot(median));
  })));
}

}  // namespace

MovementOutcomes OutcomesOf(Side side, const std::vector<double>& time,
                            const std::map<Segment, std::vector<Quaterniond>>& q_WB,
                            const std::map<std::string, std::vector<Vector3d>>& p_W) {
  MovementOutcomes outcomes;
  if (time.size() < 3) return outcomes;
  const SampleTimes times(time);
  for (const char* point : {"hand", "wrist", "elbow"})
    if (outcomes.mover.empty() && p_W.contains(point)) outcomes.mover = point;
  if (!outcomes.mover.empty()) {
    outcomes.epochs = EpochsOf(TrackOf(times, p_W.at(outcomes.mover)), kLeastSpeed);
  } else if (!q_WB.empty()) {
    const auto& [segment, attitudes] = *q_WB.rbegin();
    outcomes.mover = Name(segment);
    outcomes.is_point = false;
    outcomes.epochs = EpochsOf(TrackOf(times, attitudes), kLeastRate);
  }
  for (const auto& [name, series] : JointAngleSeries(q_WB, side))
    if (const AngleRange range{Quantile(series, kOutermost), Quantile(series, 1.0 - kOutermost)};
        std::isfinite(range.least))
      outcomes.ranges[name] = range;
  if (p_W.contains("shoulder")) outcomes.shoulder_range = RangeOfPoint(p_W.at("shoulder"));
  if (q_WB.contains(Segment::kThorax)) outcomes.trunk_tilt = TiltOf(q_WB.at(Segment::kThorax));
  return outcomes;
}

}  // namespace brachium
