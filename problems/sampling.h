// Sampled series and the one rule about gaps: a step over 1.8 times the usual one, or a sample that
// is NaN, is a gap, and nothing is interpolated across it.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <vector>

namespace brachium {

inline constexpr double kGapFactor = 1.8;  // of the median step

// Times that strictly increase [s].
class SampleTimes {
 public:
  explicit SampleTimes(std::vector<double> time);

  // Between samples `index` and `index + 1`, a `fraction` of the step after the first. On a sample
  // (within a nanosecond) the fraction is 0 and the next sample plays no part.
  struct Place {
    std::size_t index = 0;
    double fraction = 0.0;  // [0, 1)
  };

  // Absent before the first sample, after the last and within a gap.
  std::optional<Place> Find(double t) const;

  const std::vector<double>& time() const { return time_; }
  std::size_t size() const { return time_.size(); }
  double step() const { return step_; }  // the median one [s]; 0 below two samples

  // Whether the step from sample i to the next is a gap.
  bool GapAfter(std::size_t i) const { return time_[i + 1] - time_[i] > kGapFactor * step_; }

 private:
  std::vector<double> time_;
  double step_ = 0.0;
};

// The series (one value per time) at other instants [s]: NaN where they have no place or a
// neighbour is NaN. Rotations follow the shortest arc at constant rate; the rest is linear.
std::vector<double> Interpolate(const SampleTimes& times, const std::vector<double>& series,
                                const std::vector<double>& at);
std::vector<Eigen::Vector3d> Interpolate(const SampleTimes& times,
                                         const std::vector<Eigen::Vector3d>& series,
                                         const std::vector<double>& at);
std::vector<Eigen::Quaterniond> Interpolate(const SampleTimes& times,
                                            const std::vector<Eigen::Quaterniond>& series,
                                            const std::vector<double>& at);

}  // namespace brachium
