#include "io/recording_checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <vector>

#include "io/input_error.h"
#include "io/rate_check.h"
#include "io/text.h"
#include "problems/rotation.h"
#include "problems/saturation.h"
#include "problems/statistics.h"

namespace brachium {
namespace {

constexpr double kFullRange = 35.0;  // [rad/s], 2000 deg/s: the usual sensor measures no more
constexpr double kBrisk = 20.0;      // [rad/s], seldom passed by an arm

std::vector<double> Norms(const std::vector<Eigen::Vector3d>& vectors) {
  std::vector<double> norms;
  norms.reserve(vectors.size());
  for (const Eigen::Vector3d& v : vectors) norms.push_back(v.norm());
  return norms;
}

double AngleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

bool ShowsNearlyGravity(const Eigen::Vector3d& f_S) {
  return std::abs(f_S.norm() - kGravity) < 0.1 * kGravity;
}

// True when another scale of the gyroscope explains gravity three times better.
bool Explains(const Recording& recording, double scale, double mismatch) {
  constexpr double kLeast = 2 * kDegree;  // below it nothing turns
  return mismatch > kLeast && mismatch > 3.0 * GravityMismatch(recording, scale);
}

void CheckAccelerometer(double acc, double gyr, const std::string& file) {
  if (gyr > 0.8 * kGravity && gyr < 1.2 * kGravity && acc < 0.5 * kGravity)
    throw InputError(file, 0,
                     "gyr and acc look swapped (median norms " + Fixed(gyr, 2) + " and " +
                         Fixed(acc, 2) +
                         "); expected gravity in acc: exchange the columns [acc_gyr_swapped]");
  if (acc > 0.8 && acc < 1.2)
    throw InputError(file, 0,
                     "acc looks like g (median norm " + Fixed(acc, 3) +
                         "); expected m/s^2, 9.81 at rest: multiply by 9.80665 [acc_in_g]");
  if (acc > 800.0 && acc < 1200.0)
    throw InputError(file, 0,
                     "acc looks like thousandths of g (median norm " + Fixed(acc, 0) +
                         "); expected m/s^2, 9.81 at rest [acc_in_g]");
  if (acc < 0.8)
    throw InputError(file, 0,
                     "acc lacks gravity (median norm " + Fixed(acc, 3) +
                         "); expected specific force, 9.81 m/s^2 at rest: export it with gravity "
                         "[acc_without_gravity]");
}

void CheckRange(const std::vector<Eigen::Vector3d>& samples, double least, const std::string& name,
                Findings* findings) {
  std::array<std::size_t, 3> saturated{};
  std::array<double, 3> limit{};
  for (const SaturatedRun& run : FindSaturatedRuns(samples, least)) {
    const auto axis = static_cast<std::size_t>(run.axis);
    saturated[axis] += run.last - run.first;
    limit[axis] = std::abs(samples[run.first][run.axis]);
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (saturated[axis] > 0)
      findings->warnings.push_back(
          name + "_" + "xyz"[axis] + " stays at its largest value, " + Fixed(limit[axis], 1) +
          ", in " + std::to_string(saturated[axis]) +
          " samples: the sensor was out of its range there, and they count for less [clipping]");
}

// A sensor that repeats its last sample instead of measuring.
void CheckFrozen(const Recording& recording, const std::string& name, Findings* findings) {
  constexpr double kLongest = 0.2;  // [s]
  double frozen = 0.0, longest_at = 0.0;
  for (std::size_t i = 0, begin = 0; i < recording.size(); ++i) {
    if (recording.gyr_S[i] != recording.gyr_S[begin] ||
        recording.acc_S[i] != recording.acc_S[begin])
      begin = i;
    const double length = recording.time[i] - recording.time[begin];
    if (length > frozen) std::tie(frozen, longest_at) = std::tie(length, recording.time[begin]);
  }
  if (frozen > kLongest)
    findings->warnings.push_back(name + ": no number changes for " + Fixed(frozen, 2) + " s from " +
                                 Fixed(longest_at, 2) +
                                 " s on; the sensor dropped out: delete these rows, so that they "
                                 "are a gap [frozen]");
}

}  // namespace

double GravityMismatch(const Recording& recording, double gyro_scale) {
  constexpr std::size_t kWindows = 400;
  constexpr double kLength = 0.5;  // [s]
  const std::size_t stride = std::max<std::size_t>(1, recording.size() / kWindows);
  std::vector<double> angles;
  for (std::size_t first = 0; first < recording.size(); first += stride) {
    if (!ShowsNearlyGravity(recording.acc_S[first])) continue;
    Eigen::Quaterniond q_first = Eigen::Quaterniond::Identity();  // first sample from this one
    std::size_t i = first;
    while (i + 1 < recording.size() && recording.time[i] - recording.time[first] < kLength) {
      const double step = recording.time[i + 1] - recording.time[i];
      const Eigen::Vector3d omega_S = 0.5 * (recording.gyr_S[i] + recording.gyr_S[i + 1]);
      q_first = q_first * Exp<double>(gyro_scale * step * omega_S);
      ++i;
    }
    if (i > first && ShowsNearlyGravity(recording.acc_S[i]))
      angles.push_back(AngleBetween(q_first * recording.acc_S[i], recording.acc_S[first]));
  }
  return angles.empty() ? 0.0 : Quantile(std::move(angles), 0.5);
}

void CheckSensorUnits(const Recording& recording, const std::string& file, const std::string& name,
                      Findings* findings) {
  const std::vector<double> rates = Norms(recording.gyr_S);
  const double acc = Quantile(Norms(recording.acc_S), 0.5);
  CheckAccelerometer(acc, Quantile(rates, 0.5), file);
  if (acc < 0.5 * kGravity || acc > 2.0 * kGravity)
    findings->warnings.push_back(name + ": acc has the median norm " + Fixed(acc, 2) +
                                 "; expected about 9.81 m/s^2");
  const double fast = Quantile(rates, 0.95);
  if (fast > kFullRange)
    throw InputError(file, 0,
                     "gyr looks like deg/s (5 % of it is above " + Fixed(fast, 0) +
                         "); expected rad/s: multiply by pi / 180 [gyr_in_deg_s]");
  const double mismatch = GravityMismatch(recording, 1.0);
  if (fast > kBrisk || Explains(recording, kDegree, mismatch))
    findings->warnings.push_back(name + ": gyr looks like deg/s (5 % of it is above " +
                                 Fixed(fast, 2) +
                                 "); expected rad/s: multiply by pi / 180 [gyr_in_deg_s]");
  else if (Explains(recording, -1.0, mismatch))
    findings->warnings.push_back(
        name + ": gyr looks turned round: gravity turns the other way " +
        "in acc; expected right-handed axes and specific force [gyr_sign]");
  else
    CheckRate(recording, name, findings);
  CheckRange(recording.gyr_S, kSmallestGyroRange, name + ": gyr", findings);
  CheckRange(recording.acc_S, kSmallestAccelRange, name + ": acc", findings);
  CheckFrozen(recording, name, findings);
}

}  // namespace brachium
