#include "problems/sampling.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace brachium {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;

constexpr double kOnSample = 1e-9;  // [s]
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

double MedianStep(const std::vector<double>& time) {
  if (time.size() < 2) return 0.0;
  std::vector<double> steps(time.size() - 1);
  for (std::size_t i = 0; i < steps.size(); ++i) steps[i] = time[i + 1] - time[i];
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

double Between(double first, double second, double fraction) {
  return first + fraction * (second - first);
}

Vector3d Between(const Vector3d& first, const Vector3d& second, double fraction) {
  return first + fraction * (second - first);
}

Quaterniond Between(const Quaterniond& first, const Quaterniond& second, double fraction) {
  const bool known = first.coeffs().allFinite() && second.coeffs().allFinite();
  return known ? first.slerp(fraction, second) : Quaterniond(kNaN, kNaN, kNaN, kNaN);
}

template <typename Value>
std::vector<Value> InterpolateAll(const SampleTimes& times, const std::vector<Value>& series,
                                  const std::vector<double>& at, const Value& absent) {
  std::vector<Value> values;
  values.reserve(at.size());
  for (const double t : at) {
    const auto place = times.Find(t);
    if (!place)
      values.push_back(absent);
    else if (place->fraction == 0.0)
      values.push_back(series[place->index]);
    else
      values.push_back(Between(series[place->index], series[place->index + 1], place->fraction));
  }
  return values;
}

}  // namespace

SampleTimes::SampleTimes(std::vector<double> time)
    : time_(std::move(time)), step_(MedianStep(time_)) {}

std::optional<SampleTimes::Place> SampleTimes::Find(double t) const {
  const auto after = std::upper_bound(time_.begin(), time_.end(), t + kOnSample);
  if (after == time_.begin()) return std::nullopt;
  const auto i = static_cast<std::size_t>(after - time_.begin()) - 1;
  if (t - time_[i] <= kOnSample) return Place{i, 0.0};
  if (after == time_.end()) return std::nullopt;
  if (GapAfter(i)) return std::nullopt;
  return Place{i, (t - time_[i]) / (time_[i + 1] - time_[i])};
}

std::vector<double> Interpolate(const SampleTimes& times, const std::vector<double>& series,
                                const std::vector<double>& at) {
  return InterpolateAll(times, series, at, kNaN);
}

std::vector<Vector3d> Interpolate(const SampleTimes& times, const std::vector<Vector3d>& series,
                                  const std::vector<double>& at) {
  return InterpolateAll<Vector3d>(times, series, at, Vector3d::Constant(kNaN));
}

std::vector<Quaterniond> Interpolate(const SampleTimes& times,
                                     const std::vector<Quaterniond>& series,
                                     const std::vector<double>& at) {
  return InterpolateAll(times, series, at, Quaterniond(kNaN, kNaN, kNaN, kNaN));
}

}  // namespace brachium
