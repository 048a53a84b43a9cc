// How far the relations between the unknowns hold: the options of the objective.
#pragma once

#include <string>

namespace brachium {

// Physical sigmas, independent of sampling rate and knot spacing.
struct ModelOptions {
  double elbow_adduction_sigma_deg = 5.0;
  double elbow_adduction_correlation_s = 10.0;
  double elbow_wobble_sigma_deg = 3.0;
  double elbow_wobble_correlation_s = 0.2;
  double zero_velocity_sigma_m_s = 0.005;
  double zero_velocity_correlation_s = 0.5;
  double range_of_motion_sigma_deg = 5.0;
  double rest_sway_deg = 0.05;
  double gyro_scale_sigma = 0.003;
  double gyro_cross_axis = 0.003;
  double clock_offset_sigma_s = 0.005;
  bool estimate_mountings = true;
  double soft_tissue_deg = 0.0;
  double soft_tissue_correlation_s = 0.2;
  double accel_scale_sigma = 0.005;
  double accel_size_m = 0.001;
  double unmodelled_acceleration = 0.1;
  double unmodelled_quiver = 0.001;
  double unmodelled_correlation_s = 0.1;
  double bias_node_spacing_s = 5.0;

  template <typename Options, typename Visitor>
  static void Visit(Options& options, Visitor&& visit) {
    visit("elbow_adduction_sigma_deg", options.elbow_adduction_sigma_deg,
          "Deviation of the elbow from its carrying angle [deg]: joint play and soft tissue. Less "
          "ties the relative heading down harder, and to a wrong value where the elbow deviates.");
    visit("elbow_adduction_correlation_s", options.elbow_adduction_correlation_s,
          "How long such a deviation lasts [s]. More trusts each second of the constraint less.");
    visit("elbow_wobble_sigma_deg", options.elbow_wobble_sigma_deg,
          "Fast deviation beside it [deg]: soft tissue wobbling under the sensors.");
    visit("elbow_wobble_correlation_s", options.elbow_wobble_correlation_s,
          "How long a wobble lasts [s].");
    visit("zero_velocity_sigma_m_s", options.zero_velocity_sigma_m_s,
          "Velocity left in a rest [m/s].");
    visit("zero_velocity_correlation_s", options.zero_velocity_correlation_s,
          "How long a residual velocity lasts in a rest [s].");
    visit("range_of_motion_sigma_deg", options.range_of_motion_sigma_deg,
          "How softly the elbow's stops give way [deg].");
    visit("rest_sway_deg", options.rest_sway_deg,
          "Least rms turn of a segment to and fro in a rest [deg].");
    visit("gyro_scale_sigma", options.gyro_scale_sigma,
          "Relative scale error of each gyroscope axis, estimated [1].");
    visit(
        "gyro_cross_axis", options.gyro_cross_axis,
        "Error of the gyroscopes that grows with the rate and is no constant scale [1]: axes that "
        "are not square to each other or not the accelerometer's, bent scales.");
    visit("clock_offset_sigma_s", options.clock_offset_sigma_s,
          "How far the sensors' clocks may be apart, standard deviation; estimated. 0: they are "
          "one [s].");
    visit(
        "estimate_mountings", options.estimate_mountings,
        "Estimate how the sensors of upper arm and forearm are turned on their segments, with the "
        "told sd as prior. Off: all sensors sit exactly as told.");
    visit(
        "soft_tissue_deg", options.soft_tissue_deg,
        "How far skin and muscle turn a sensor about its segment to and fro, rms [deg]; estimated "
        "at every knot instead of the mountings, which cannot be told from it. 0: not at all.");
    visit("soft_tissue_correlation_s", options.soft_tissue_correlation_s,
          "How long such a turn lasts [s].");
    visit("accel_scale_sigma", options.accel_scale_sigma,
          "Relative scale error of each accelerometer axis, estimated [1].");
    visit("accel_size_m", options.accel_size_m,
          "How far the points at which an accelerometer senses lie apart [m]: what it reads wrong "
          "when it turns fast. Matters most to a single sensor, whose rests tell nothing of it.");
    visit("unmodelled_acceleration", options.unmodelled_acceleration,
          "First guess of the acceleration that the model leaves out [m/s^2]; each sensor's own is "
          "then estimated from its residuals.");
    visit(
        "unmodelled_quiver", options.unmodelled_quiver,
        "First guess of how far a sensor quivers about its place on the arm [m]; each sensor's own "
        "is then estimated from its residuals.");
    visit("unmodelled_correlation_s", options.unmodelled_correlation_s,
          "How long an acceleration that the model leaves out lasts [s].");
    visit("bias_node_spacing_s", options.bias_node_spacing_s,
          "Time between the nodes of the gyro biases [s], linear between them.");
  }

  bool IsValid(std::string* why) const;
};

}  // namespace brachium
