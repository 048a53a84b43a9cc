#include "io/recording_checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <vector>

#include "io/input_error.h"
#include "io/text.h"
#include "problems/rotation.h"
#include "problems/saturation.h"
#include "problems/statistics.h"
#include "problems/stillness.h"

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

bool ShowsOnlyGravity(const Eigen::Vector3d& f_S) {
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

// A movement from one rest to the next: gravity on both sides of it, and the rates in between.
struct Passage {
  Eigen::Vector3d before_S, after_S;  // mean specific force
  Eigen::Vector3d bias_S;             // mean rate of the rest before
  std::size_t first = 0, last = 0;    // samples
};

std::vector<Passage> Passages(const Recording& recording) {
  constexpr double kLongest = 10.0;        // [s], before drift counts
  constexpr double kLeast = 10 * kDegree;  // by which gravity turns
  const std::vector<RestInterval> rests = DetectRests(recording, {});
  std::vector<Passage> passages;
  for (std::size_t i = 0; i + 1 < rests.size(); ++i) {
    const RestInterval &from = rests[i], &to = rests[i + 1];
    if (to.start - from.end > kLongest || AngleBetween(from.mean_force, to.mean_force) < kLeast)
      continue;
    const auto at = [&](double t) {
      return static_cast<std::size_t>(std::ranges::lower_bound(recording.time, t) -
                                      recording.time.begin());
    };
    const double middle_from = 0.5 * (from.start + from.end), middle_to = 0.5 * (to.start + to.end);
    passages.push_back({from.mean_force, to.mean_force, from.mean_rate,
                        at(std::max(middle_from, from.end - 0.5)),
                        at(std::min(middle_to, to.start + 0.5))});
  }
  return passages;
}

// How far off gravity is after the movement when `scale` times the rates carry it [rad].
double PassageError(const Recording& recording, const Passage& passage, double scale) {
  Eigen::Quaterniond q = Eigen::Quaterniond::Identity();
  for (std::size_t i = passage.first; i < passage.last; ++i) {
    const double step = recording.time[i + 1] - recording.time[i];
    const Eigen::Vector3d omega_S =
        0.5 * (recording.gyr_S[i] + recording.gyr_S[i + 1]) - passage.bias_S;
    q = q * Exp<double>(scale * step * omega_S);
  }
  return AngleBetween(q * passage.after_S, passage.before_S);
}

double PassageError(const Recording& recording, const std::vector<Passage>& passages,
                    double scale) {
  std::vector<double> errors;
  for (const Passage& passage : passages) errors.push_back(PassageError(recording, passage, scale));
  return Quantile(std::move(errors), 0.5);
}

// Between rests the integrated rates must turn gravity as the accelerometer sees it turned. Where a
// multiple of them does so much better, time runs at that multiple.
void CheckRate(const Recording& recording, const std::string& name, Findings* findings) {
  constexpr std::size_t kFewest = 3, kMost = 20;
  constexpr double kLeast = 3 * kDegree, kTolerance = 0.08;
  std::vector<Passage> passages = Passages(recording);
  if (passages.size() < kFewest) return;
  passages.resize(std::min(passages.size(), kMost));
  const double told = PassageError(recording, passages, 1.0);
  if (told < kLeast) return;
  double best = told, best_scale = 1.0;
  const auto scan = [&](double from, double to, double factor) {
    for (double scale = from; scale < to; scale *= factor) {
      const double error = PassageError(recording, passages, scale);
      if (error < best) std::tie(best, best_scale) = std::tie(error, scale);
    }
  };
  scan(0.2, 5.0, 1.1);
  scan(best_scale / 1.1, best_scale * 1.1, 1.01);
  if (3.0 * best > told || std::abs(best_scale - 1.0) < kTolerance) return;
  findings->warnings.push_back(
      name + ": the sampling rate looks wrong (between rests gravity turns " +
      Fixed(best_scale, 2) + " times as far as gyr says); expected about " +
      Fixed(1.0 / (best_scale * SamplingPeriod(recording)), 1) +
      " Hz: check time_s, or the scale of gyr [rate]");
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
    if (!ShowsOnlyGravity(recording.acc_S[first])) continue;
    Eigen::Quaterniond q_first = Eigen::Quaterniond::Identity();  // first sample from this one
    std::size_t i = first;
    while (i + 1 < recording.size() && recording.time[i] - recording.time[first] < kLength) {
      const double step = recording.time[i + 1] - recording.time[i];
      const Eigen::Vector3d omega_S = 0.5 * (recording.gyr_S[i] + recording.gyr_S[i + 1]);
      q_first = q_first * Exp<double>(gyro_scale * step * omega_S);
      ++i;
    }
    if (i > first && ShowsOnlyGravity(recording.acc_S[i]))
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
