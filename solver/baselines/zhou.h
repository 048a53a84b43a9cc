// The method `zhou`: wrist, elbow and shoulder from two sensors, by strapdown integration, segment
// lengths, and a shoulder that makes two double integrals agree; after Zhou, Stone, Hu & Harris (2008).
//
// Filters   acceleration low-passed at 10 Hz, angular rate high-passed at 0.05 Hz (butterworth.h).
// Attitude  R' = R Exp(ω T), from the start of tracks.h.
// Chain     with the upper arm's vector d_U, the forearm's d_F and the shoulder p_s,
//             elbow P_e = p_s + R_U d_U,   wrist P_w = P_e + R_F d_F                     (4), (5)
// Shoulder  with lever arms r and sensors' displacements u = ∬ (R f + g_W), Δ since the start,
//             A = u_U - Δ(R_U r_U)                              the shoulder from the upper arm  (6)
//             S = u_F - Δ(R_F r_F) - (u_U + Δ(R_U (d_U - r_U)))  what the two say of the elbow   (7)
//             P_s = A - λ S                                                                     (8)
//           λ of each world axis from `calibration:shoulder_still` intervals (drift_gains.h, (9)),
//           else -1/2. The shoulder starts at zero.
// Departs   from the paper in what it leaves open: order and causality of the filters are options;
//           without the high-pass the gyroscope loses the bias that its rests tell.
// Errata of the printed equations:
//   (2)  R' = R + R S(ω) T leaves the rotations (a column has the norm 4.9 after 20 s at 2 rad/s and
//        25 Hz): Exp instead;
//   (3)  adds (0, 0, 9.81) to a specific force that is +9.81 at rest: subtracted here;
//   (4), (5)  give the upper arm the length of the forearm and the other way round: lengths have
//        names here;
//   (6), (7)  take the acceleration of the sensor for the joint's and leave out where the motion
//        starts: lever arms and displacements from the start here;
//   tables  rms errors below their standard deviations (shrugging: elbow, shoulder) cannot be; errors
//        are means over three axes, in space about √3 larger.
// Blind to  what the high-pass takes: a 1 s, 90 deg reach that is then held reads 77, 56, 30 and 9 deg
//           after 1, 2, 4 and 8 s (first order). Positions drift as double integrals do: λ halves that
//           at best.
// Source    Zhou, Stone, Hu & Harris, Med. Eng. Phys. 30 (2008) 123-133.
#pragma once

#include <string>

#include "solver/estimator.h"

namespace brachium {

struct ZhouOptions {
  double zhou_lowpass_hz = 10.0;
  double zhou_highpass_hz = 0.05;
  int zhou_filter_order = 1;
  bool zhou_zero_phase = false;
  int zhou_repetitions = 20;

  bool IsValid(std::string* why) const;

  template <typename Options, typename Visitor>
  static void Visit(Options& options, Visitor&& visit) {
    visit("zhou_lowpass_hz", options.zhou_lowpass_hz,
          "Cutoff of the low-pass on acceleration [Hz]; 0: none.");
    visit("zhou_highpass_hz", options.zhou_highpass_hz,
          "Cutoff of the high-pass on angular rate [Hz]; 0: none, and the bias that rests tell is "
          "taken off instead. More forgets held postures sooner.");
    visit("zhou_filter_order", options.zhou_filter_order,
          "Order of both Butterworth filters. The paper does not tell it.");
    visit("zhou_zero_phase", options.zhou_zero_phase,
          "Run both filters forwards and backwards rather than forwards alone.");
    visit("zhou_repetitions", options.zhou_repetitions,
          "Movements in the calibration:shoulder_still intervals together; each interval is cut "
          "into equal parts to have as many.");
  }
};

class Zhou final : public Estimator {
 public:
  explicit Zhou(const ZhouOptions& options) : options_(options) {}
  bool Accepts(const Observations& observations, std::string* why) const override;
  Estimate Run(const Observations& observations, const Progress& progress = {}) const override;

 private:
  ZhouOptions options_;
};

}  // namespace brachium
