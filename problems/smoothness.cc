#include "problems/smoothness.h"

#include <Eigen/Core>
#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <limits>
#include <unsupported/Eigen/FFT>

namespace brachium {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr int kPadLevel = 4;
constexpr std::size_t kMostPadded = std::size_t{1} << 17;
constexpr double kHighest = 10.0;    // [Hz]
constexpr double kThreshold = 0.05;  // of the greatest amplitude

bool Moves(const std::vector<double>& speed) {
  return std::all_of(speed.begin(), speed.end(), [](double v) { return std::isfinite(v); }) &&
         std::any_of(speed.begin(), speed.end(), [](double v) { return v > 0.0; });
}

// Of frequencies 0, 1/n, 2/n ... of the rate.
std::vector<double> Amplitudes(std::vector<double> speed, std::size_t padded, std::size_t kept) {
  speed.resize(padded, 0.0);
  std::vector<std::complex<double>> spectrum;
  Eigen::FFT<double> fft;
  fft.fwd(spectrum, speed);
  std::vector<double> amplitudes;
  for (std::size_t i = 0; i < std::min(kept, padded); ++i)
    amplitudes.push_back(std::abs(spectrum[i]));
  return amplitudes;
}

// The least value on the way from a peak to a higher value or the end, in steps of ±1.
double Valley(const std::vector<double>& speed, std::size_t peak, int step) {
  double least = speed[peak];
  for (auto i = static_cast<std::ptrdiff_t>(peak);
       i >= 0 && i < static_cast<std::ptrdiff_t>(speed.size()); i += step) {
    const double v = speed[static_cast<std::size_t>(i)];
    if (v > speed[peak]) break;
    least = std::min(least, v);
  }
  return least;
}

}  // namespace

double SpectralArcLength(const std::vector<double>& speed, double rate_hz) {
  if (speed.size() < 2 || !Moves(speed)) return kNaN;
  const std::size_t least = std::bit_ceil(speed.size());
  const std::size_t padded = std::max(least, std::min(least << kPadLevel, kMostPadded));
  const double step = rate_hz / static_cast<double>(padded);
  const auto kept = static_cast<std::size_t>(std::floor(kHighest / step)) + 1;
  const std::vector<double> amplitude = Amplitudes(speed, padded, kept);
  const double greatest = *std::max_element(amplitude.begin(), amplitude.end());
  const auto loud = [&](double a) { return a >= kThreshold * greatest; };
  const auto first = std::find_if(amplitude.begin(), amplitude.end(), loud);
  const auto last = std::find_if(amplitude.rbegin(), amplitude.rend(), loud).base() - 1;
  const double df = 1.0 / static_cast<double>(std::max<std::ptrdiff_t>(1, last - first));
  double length = 0.0;
  for (auto at = first; at != last; ++at) length += std::hypot(df, (*(at + 1) - *at) / greatest);
  return -length;
}

double LogDimensionlessJerk(const std::vector<double>& speed, double rate_hz) {
  if (speed.size() < 3 || !Moves(speed)) return kNaN;
  const double duration = static_cast<double>(speed.size()) / rate_hz;
  const double peak = *std::max_element(speed.begin(), speed.end());
  double integral = 0.0;
  for (std::size_t i = 0; i + 2 < speed.size(); ++i)
    integral += std::pow((speed[i + 2] - 2.0 * speed[i + 1] + speed[i]) * rate_hz * rate_hz, 2);
  return -std::log(std::pow(duration, 3) / (peak * peak) * integral / rate_hz);
}

int SpeedPeaks(const std::vector<double>& speed, double least_prominence) {
  if (speed.empty() || !Moves(speed)) return 0;
  const double least = least_prominence * *std::max_element(speed.begin(), speed.end());
  int peaks = 0;
  for (std::size_t i = 0; i < speed.size(); ++i) {
    const bool rises = i == 0 || speed[i] > speed[i - 1];
    const bool falls = i + 1 == speed.size() || speed[i] >= speed[i + 1];
    if (rises && falls && speed[i] - std::max(Valley(speed, i, -1), Valley(speed, i, 1)) >= least)
      ++peaks;
  }
  return peaks;
}

}  // namespace brachium
