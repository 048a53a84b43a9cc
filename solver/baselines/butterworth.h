// Butterworth filters of sampled signals.
//
// Analogue prototype 1/(Π s² + 2 sin(π(2k-1)/2n) s + 1), k = 1..n/2, with a factor s + 1 where the
// order n is odd; high-pass by s -> 1/s; digital by the bilinear transform s = (1 - z⁻¹)/(K(1 + z⁻¹)),
// K = tan(π f T), which keeps the cutoff where it is told. Sections of second order, one after the
// other. Source: Oppenheim & Schafer, Discrete-Time Signal Processing, section 7.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace brachium {

struct Butterworth {
  enum class Band { kLow, kHigh };
  Band band = Band::kLow;  // what passes
  double cutoff = 0.0;     // where the gain is 1/√2 (1/2 with zero phase) [Hz]
  int order = 1;
  bool zero_phase = false;  // forwards, then backwards: no delay, the gain squared
};

// Each component of a signal sampled every `period` [s]. A causal filter begins as if the first
// sample had lasted for ever; one of zero phase continues the signal beyond both ends by its point
// reflection. A missing sample is not known as such: the next one takes its place.
// Requires 0 < cutoff < 1/(2 period), order > 0 and a sample.
std::vector<Eigen::Vector3d> Filtered(const std::vector<Eigen::Vector3d>& signal, double period,
                                      const Butterworth& filter);

}  // namespace brachium
