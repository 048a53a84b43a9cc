// The method `heading_corrected`: six-axis orientations of the two segments, whose relative heading
// is then found, window by window, from the elbow's having two degrees of freedom.
//
// Each segment's attitude comes from inclination_filter.h, right but for a heading that drifts. With
// the flexion axis z_U of the upper arm and the pronation axis y_F of the forearm, both in W, and
// the forearm turned by δ about the vertical,
//   sin β(δ) = z_U · Rz(δ) y_F = A + B cos δ + C sin δ,
//   A = z_z y_z,  B = z_x y_x + z_y y_y,  C = z_y y_x - z_x y_y,
// must be the sine of -s κ0 with the carrying angle κ0 (s = +1 right, -1 left). In a window the
// heading error stands still, so
//   δ_k = argmin Σ (β_i(δ) + s κ0)²         Gauss-Newton from the last filtered value,
//   r_k = mean (∂β_i/∂δ)² in [0, 1]         the rating: how far the window sees δ at all,
//   δ <- δ + (1 - exp(-r_k D / τ)) (δ_k - δ)  every D = 0.5 s,
// and the forearm is turned by δ, linear between windows. δ starts at zero: at the start pose.
//
// Departs   from the papers, where the filter is causal, in that a window is centred on its instant;
//           six-axis orientations are the 2005 filter's; the rating is the information itself.
// Defaults  from the campaign of luinge.h, windows of 4 to 16 s and τ of 2 to 40 s: the window hardly
//           matters; a long τ is better where rests told the bias, and lags behind a drift by τ/r.
// Blind to  the heading where r = 0: a straight hanging arm, or a vertical flexion axis. Two
//           headings fit one posture; the start decides between them.
// Source    Laidig, Müller & Seel, Current Directions in Biomedical Engineering 3 (2017) 167-170;
//           Laidig, Weygers & Seel, Sensors 22 (2022) 9850.
#pragma once

#include <string>
#include <vector>

#include "solver/baselines/luinge.h"

namespace brachium {

struct HeadingCorrectedOptions {
  LuingeUnconstrainedOptions filter;
  double heading_window_s = 8.0;
  double heading_time_constant_s = 10.0;

  bool IsValid(std::string* why) const;

  template <typename Options, typename Visitor>
  static void Visit(Options& options, Visitor&& visit) {
    LuingeUnconstrainedOptions::Visit(options.filter, visit);
    visit("heading_window_s", options.heading_window_s,
          "Span over which the relative heading is taken as constant [s]. More averages over more "
          "postures, and follows a drift less.");
    visit("heading_time_constant_s", options.heading_time_constant_s,
          "Time constant of the filter over the windows where they see the heading fully [s].");
  }
};

class HeadingCorrected final : public Estimator {
 public:
  explicit HeadingCorrected(const HeadingCorrectedOptions& options) : options_(options) {}
  bool Accepts(const Observations& observations, std::string* why) const override;
  Estimate Run(const Observations& observations, const Progress& progress = {}) const override;

 private:
  HeadingCorrectedOptions options_;
};

// How the adduction of one posture depends on the forearm's heading.
struct AdductionOfHeading {
  double A = 0.0, B = 0.0, C = 0.0;

  AdductionOfHeading(const Eigen::Quaterniond& q_WU, const Eigen::Quaterniond& q_WF);

  // β(δ) and its derivative [rad].
  std::pair<double, double> At(double heading) const;
};

struct HeadingWindow {
  double heading = 0.0;  // δ_k [rad]
  double rating = 0.0;   // r_k
};

// The heading of a window of postures, nearest to `heading`, at which the elbow has `adduction`.
HeadingWindow SolveWindow(const AdductionOfHeading* first, const AdductionOfHeading* last,
                          double adduction, double heading);

}  // namespace brachium
