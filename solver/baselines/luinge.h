// The methods of Luinge and co-workers:
//   luinge_unconstrained  a Kalman filter for each segment: inclination_filter.h (2005)
//   luinge                the same, with the elbow's adduction measured at every sample of the first
//                         recording: elbow_constraint.h (2007)
//   luinge_rts            the same model, smoothed backwards: error_state_smoother.h
//
// Upper arm and forearm share one filter that stops at every sample of either; what one sensor has
// no sample of is predicted from its own. Other segments have filters of their own.
// The papers' parameters of the filter are not established. Ours: densities and biases of the sensor
// from recording.noise; cutoff and sigma of the acceleration from a simulated campaign (daily_brisk
// and daily_slow of 60 s, five seeds each, scale errors of 0.3 %, axes 0.2 deg off), over cutoffs of
// 0.25 to 4 Hz and sigmas of 0.7 to 8 m/s². From 2 Hz and 2 m/s² upwards the forearm in the upper arm
// is within 1.4 to 1.7 deg; a lower cutoff costs up to a degree, 0.7 m/s² fails on brisk movement (7 deg
// and more).
// Start and gyro bias: tracks.h.
#pragma once

#include <optional>
#include <string>

#include "solver/estimator.h"

namespace brachium {

struct LuingeUnconstrainedOptions {
  double luinge_acceleration_cutoff_hz = 2.0;
  double luinge_acceleration_sigma_m_s2 = 3.0;
  bool luinge_bias_from_rests = true;

  bool IsValid(std::string* why) const;

  template <typename Options, typename Visitor>
  static void Visit(Options& options, Visitor&& visit) {
    visit("luinge_acceleration_cutoff_hz", options.luinge_acceleration_cutoff_hz,
          "Band of a segment's acceleration, a first-order process [Hz]. Less holds on to a "
          "predicted acceleration longer and corrects the inclination more slowly.");
    visit("luinge_acceleration_sigma_m_s2", options.luinge_acceleration_sigma_m_s2,
          "Standard deviation of that acceleration, per axis [m/s^2]. More trusts the gyroscope.");
    visit(
        "luinge_bias_from_rests", options.luinge_bias_from_rests,
        "Start with the gyro bias that the rests of the recording tell. Off: with none, as sensors "
        "are switched on; the filter then learns it from gravity alone.");
  }
};

struct LuingeOptions {
  LuingeUnconstrainedOptions filter;
  double luinge_adduction_sigma_deg = 10.0;
  bool luinge_expects_carrying_angle = false;

  bool IsValid(std::string* why) const;

  template <typename Options, typename Visitor>
  static void Visit(Options& options, Visitor&& visit) {
    LuingeUnconstrainedOptions::Visit(options.filter, visit);
    visit("luinge_adduction_sigma_deg", options.luinge_adduction_sigma_deg,
          "Standard deviation of the elbow's adduction, taken as new at every sample [deg]. Less "
          "ties the relative heading down harder, whether that is right or not.");
    visit("luinge_expects_carrying_angle", options.luinge_expects_carrying_angle,
          "Expect the trial's carrying angle rather than the paper's 0 deg.");
  }
};

struct LuingeRtsOptions : LuingeOptions {};

class LuingeUnconstrained final : public Estimator {
 public:
  explicit LuingeUnconstrained(const LuingeUnconstrainedOptions& options) : options_(options) {}
  bool Accepts(const Observations& observations, std::string* why) const override;
  Estimate Run(const Observations& observations, const Progress& progress = {}) const override;

 private:
  LuingeUnconstrainedOptions options_;
};

class Luinge final : public Estimator {
 public:
  explicit Luinge(const LuingeOptions& options) : options_(options), smooths_(false) {}
  explicit Luinge(const LuingeRtsOptions& options) : options_(options), smooths_(true) {}
  bool Accepts(const Observations& observations, std::string* why) const override;
  Estimate Run(const Observations& observations, const Progress& progress = {}) const override;

 private:
  LuingeOptions options_;
  bool smooths_;
};

// The attitudes of every segment from a filter of its own. With a heading's sd [rad], and where every
// recording has a magnetometer, the heading of the field (north, that of the first segment's first
// sample) is measured besides.
Estimate FilterEachSegment(const std::string& method, const Observations& observations,
                           const LuingeUnconstrainedOptions& options,
                           std::optional<double> heading_sigma);

// Whether the arm has the elbow that these methods lean on; if not, `why` names the way out.
bool HasHingedElbow(const Observations& observations, std::string* why);

}  // namespace brachium
