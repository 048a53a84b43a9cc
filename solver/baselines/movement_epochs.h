// When a sensor moves, from its gyroscope alone: the double-threshold detector of Bai et al. (2015),
// section II.C.2.b, borrowed from the end-point detection of speech.
//
//   s = angular rate less its bias, per axis; frames of N = 4 samples
//   E_i = Σ_axes Σ_n s(n)²                                  short-time energy                (7)
//   Z_i = Σ_axes Σ_n |sgn s(n) - sgn s(n-1)|, sgn in {1, 0}   zero crossings                 (8)
// A frame is sure to move where E > T1, and may move where E > T2 and Z <= T3: many crossings at low
// energy are noise. An epoch grows from a sure frame both ways over frames that may move, past a
// single one that does not: two in succession end it, and it begins and ends with a pair that may.
//
// Errata: (7) and (8) take s as the norm of the rate, which never crosses zero, and which a bias
//   keeps above any threshold: each axis and less its bias here.
// T1, T2, T3 were set by trial and error. Ours come from the rests, of which those between movements
// are the less quiet: E there, scaled. Sure: T1
// = 100 E, may: T2 = 10 E with E the mean over the rests' frames, at least that of white noise at the
// sensor's density; T3 = the mean of Z there, at least what half as many crossings as white noise
// makes would be (3 of 6).
#pragma once

#include <string>
#include <vector>

#include "problems/estimate.h"
#include "solver/baselines/tracks.h"

namespace brachium {

inline constexpr std::size_t kFrameSamples = 4;

struct Frame {
  double start = 0.0, end = 0.0;  // of its cells [s]
  double energy = 0.0;            // E [rad²/s²]
  int crossings = 0;              // Z
};

struct EpochThresholds {
  double sure = 0.0;       // T1 [rad²/s²]
  double may = 0.0;        // T2 [rad²/s²]
  double crossings = 0.0;  // T3
};

// A threshold of 0 is taken from the data.
struct EpochOptions {
  double bai_energy_high = 0.0;
  double bai_energy_low = 0.0;
  double bai_crossings = 0.0;

  bool IsValid(std::string* why) const;

  template <typename Options, typename Visitor>
  static void Visit(Options& options, Visitor&& visit) {
    visit("bai_energy_high", options.bai_energy_high,
          "T1: energy of four samples of angular rate above which the sensor is sure to move "
          "[rad^2/s^2]; 0: from the rests.");
    visit("bai_energy_low", options.bai_energy_low,
          "T2: energy down to which a movement reaches, less than T1 [rad^2/s^2]; 0: from the "
          "rests. Less makes movements longer and rests shorter.");
    visit("bai_crossings", options.bai_crossings,
          "T3: zero crossings of four samples, three axes, above which low energy is noise; 0: "
          "from the rests.");
  }
};

// Whole frames only: up to three samples at the end are left over.
std::vector<Frame> FramesOf(const Recording& recording, const Eigen::Vector3d& gyro_bias);

// `rests` as intervals of time; without any, from the sensor's noise alone.
EpochThresholds ThresholdsFor(const std::vector<Frame>& frames, const ImuNoise& noise,
                              double period, const std::vector<Interval>& rests,
                              const EpochOptions& options);

// Epochs as pairs of frames, first and last, in order.
std::vector<std::pair<std::size_t, std::size_t>> FindEpochs(const std::vector<Frame>& frames,
                                                            const EpochThresholds& thresholds);

// All of the above for one segment, with its rests among those of the tracks. An epoch of the last
// frame lasts to the end of the recording.
std::vector<Epoch> DetectEpochs(const Tracks& tracks, const Track& track,
                                const EpochOptions& options);

}  // namespace brachium
