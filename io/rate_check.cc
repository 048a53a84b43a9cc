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

// At least `most` where it is not less.
double MeanError(const Recording& recording, const std::vector<Window>& windows, double scale,
                 double most) {
  const auto count = static_cast<double>(windows.size());
  double sum = 0.0;
  for (auto window = windows.begin(); window != windows.end() && sum < most * count; ++window)
    sum += ErrorOver(recording, *window, scale);
  return sum / count;
}

// The scale at which the mean error is least; 1 where that is more than `share` of what it is as told.
double BestScaleOver(const Recording& recording, const std::vector<Window>& windows, double share) {
  const double told = MeanError(recording, windows, 1.0, HUGE_VAL);
  double best = 1.0, least = told;
  if (told < kLeast) return best;
  const auto scan = [&](double from, double to, double factor) {
    for (double scale = from; scale < to; scale *= factor) {
      const double error = MeanError(recording, windows, scale, least);
      if (error < least) std::tie(least, best) = std::tie(error, scale);
    }
  };
  scan(0.2, 5.0, 1.1);
  scan(best / 1.1, best * 1.1, 1.02);
  return least <= share * told ? best : 1.0;
}

}  // namespace

void CheckRate(const Recording& recording, const std::string& name, Findings* findings) {
  const std::vector<Window> windows = WindowsOf(recording, kShortWindow);
  if (windows.size() < kFewest) return;
  const double best = BestScaleOver(recording, windows, kMuchBetter);
  if (std::abs(best - 1.0) < kTolerance) return;
  const std::vector<Window> longer = WindowsOf(recording, kLongWindow);
  if (longer.size() < kFewest) return;
  const double scale = BestScaleOver(recording, longer, 1.0);
  if (std::abs(scale - 1.0) < kTolerance || std::abs(scale / best - 1.0) > kAgreement) return;
  findings->warnings.push_back(name + ": the sampling rate looks wrong (gravity turns " +
                               Fixed(best, 2) + " times as far as gyr says); expected about " +
                               Fixed(1.0 / (best * SamplingPeriod(recording)), 1) +
                               " Hz: check time_s, or the scale of gyr [rate]");
}

}  // namespace brachium
