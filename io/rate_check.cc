#include "io/rate_check.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "io/text.h"
#include "problems/rotation.h"

namespace brachium {
namespace {

constexpr double kShortWindow = 3.0;     // [s]
constexpr double kLongWindow = 4.5;      // [s]
constexpr double kMeanShare = 1.0 / 3;   // of a window, at either end, over which force is averaged
constexpr std::size_t kFewest = 6;       // windows
constexpr std::size_t kMost = 80;        // windows
constexpr double kLongestStep = 0.2;     // [s]; over a gap nobody knows how the sensor turned
constexpr double kTurns = 20 * kDegree;  // a window in which a sensor turns less tells nothing
constexpr double kLeast = 3 * kDegree;   // sound trials: up to 4.5 deg
constexpr double kMuchBetter = 0.45;     // of the told error; sound trials: 0.8 and more
constexpr double kTolerance = 0.08;      // of the multiple
constexpr double kAgreement = 0.15;      // of the multiples of short and long windows

using Eigen::Quaterniond, Eigen::Vector3d;

struct Window {
  std::size_t first = 0, last = 0;  // samples
};

// Samples [first, last) of windows that overlap by half, or lie as far apart as `kMost` asks for;
// those in which the sensor turns.
std::vector<Window> WindowsOf(const Recording& recording, double length) {
  const double start = recording.time.front();
  const double duration = recording.time.back() - start;
  const double step = std::max(length / 2, duration / static_cast<double>(kMost));
  const auto at = [&](double t) {
    return static_cast<std::size_t>(std::ranges::lower_bound(recording.time, t) -
                                    recording.time.begin());
  };
  std::vector<Window> windows;
  for (double t = start; t + length < start + duration; t += step) {
    const Window window{at(t), at(t + length)};
    double turned = 0.0, longest = 0.0;
    for (std::size_t i = window.first; i < window.last; ++i) {
      const double h = recording.time[i + 1] - recording.time[i];
      turned += h * recording.gyr_S[i].norm();
      longest = std::max(longest, h);
    }
    if (turned > kTurns && longest < kLongestStep) windows.push_back(window);
  }
  return windows;
}

// How far the mean force at the end of a window is from that at its beginning when `scale` times
// the rates carry it there [rad].
double ErrorOver(const Recording& recording, const Window& window, double scale) {
  const double begin = recording.time[window.first], end = recording.time[window.last];
  const double part = kMeanShare * (end - begin);
  Quaterniond q = Quaterniond::Identity();
  Vector3d early = Vector3d::Zero(), late = Vector3d::Zero();
  for (std::size_t i = window.first; i < window.last; ++i) {
    const double t = recording.time[i], step = recording.time[i + 1] - t;
    if (t < begin + part) early += step * (q * recording.acc_S[i]);
    if (t > end - part) late += step * (q * recording.acc_S[i]);
    q = q * Exp<double>(0.5 * scale * step * (recording.gyr_S[i] + recording.gyr_S[i + 1]));
  }
  return std::atan2(early.cross(late).norm(), early.dot(late));
}

double MeanError(const Recording& recording, const std::vector<Window>& windows, double scale) {
  double sum = 0.0;
  for (const Window& window : windows) sum += ErrorOver(recording, window, scale);
  return sum / static_cast<double>(windows.size());
}

struct BestScale {
  double told = 0.0, error = 0.0;  // mean errors [rad]: as told, and at
  double scale = 1.0;
};

BestScale BestScaleOver(const Recording& recording, const std::vector<Window>& windows) {
  BestScale best{.told = MeanError(recording, windows, 1.0)};
  best.error = best.told;
  if (best.told < kLeast) return best;
  const auto scan = [&](double from, double to, double factor) {
    for (double scale = from; scale < to; scale *= factor) {
      const double error = MeanError(recording, windows, scale);
      if (error < best.error) std::tie(best.error, best.scale) = std::tie(error, scale);
    }
  };
  scan(0.2, 5.0, 1.1);
  scan(best.scale / 1.1, best.scale * 1.1, 1.02);
  return best;
}

}  // namespace

void CheckRate(const Recording& recording, const std::string& name, Findings* findings) {
  const std::vector<Window> windows = WindowsOf(recording, kShortWindow);
  if (windows.size() < kFewest) return;
  const BestScale best = BestScaleOver(recording, windows);
  if (best.error > kMuchBetter * best.told || std::abs(best.scale - 1.0) < kTolerance) return;
  const std::vector<Window> longer = WindowsOf(recording, kLongWindow);
  if (longer.size() < kFewest) return;
  const double scale = BestScaleOver(recording, longer).scale;
  if (std::abs(scale / best.scale - 1.0) > kAgreement) return;
  findings->warnings.push_back(name + ": the sampling rate looks wrong (gravity turns " +
                               Fixed(best.scale, 2) +
                               " times as far as gyr says); expected about " +
                               Fixed(1.0 / (best.scale * SamplingPeriod(recording)), 1) +
                               " Hz: check time_s, or the scale of gyr [rate]");
}

}  // namespace brachium
