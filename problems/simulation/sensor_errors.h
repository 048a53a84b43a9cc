// What is wrong with real recordings and with what is told about them, one switch per error.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "problems/imu.h"

namespace brachium {

// The sensor wobbles on its segment, as a coloured, nearly Gaussian process about `frequency`: it
// turns and shifts with the skin, and its gyroscope and accelerometer feel that. Still at both
// rests.
struct SoftTissue {
  double along_rms = 0.0;            // turning about the segment's long axis (y) [rad]
  double upper_arm_along_rms = 0.0;  // the same of the upper arm, the softest; 0: as the others
  double across_rms = 0.0;           // turning about x and about z, each [rad]
  double translation_rms = 0.0;      // shift per axis [m]
  double frequency = 1.0;            // middle of its two octaves [Hz]
};

// 3 deg, 1.2 deg, 3 mm at 1 Hz.
SoftTissue TypicalSoftTissue();

// Zero, or an absent noise, switches an error off exactly. Sizes are the same in every trial and
// directions and signs are drawn from the seed, unless draw_sizes makes sizes standard deviations
// (per axis, where there are axes) and has them told. The defaults are the standard case by which
// estimators are judged; its harder half sets soft_tissue = TypicalSoftTissue().
struct SimulationOptions {
  std::uint64_t seed = 1;  // of all errors; a scenario has its own
  bool draw_sizes = false;
  double rate = 100.0;                 // [Hz]
  std::map<Segment, double> own_rate;  // of sensors that have another [Hz]
  std::vector<Segment> worn;  // segments that wear a sensor; none: as the scenario usually has

  std::optional<ImuNoise> noise = MtwNoise();  // densities and gyro bias walk; told when present
  double gyro_bias = 0.3 * kDegree;            // rms over the axes, at the start [rad/s]
  double accel_bias = 0.04;                    // rms over the axes [m/s^2]
  double scale_error = 0.0;                    // sd per axis, gyroscope and accelerometer: 0.003
  double misalignment = 0.0;                   // sd of each off-diagonal element [rad]

  double lever_arm_error = 0.005;  // distance from the told to the true sensor position [m]
  double mounting_error = 0.0;  // angle from the told to the true rotation [rad]; 0: told as exact
  double length_error = 0.003;  // of each told segment length, of either sign [m]
  double start_pose_error = 0.0;  // sd of each told angle of start and end pose [rad]

  double clock_offset = 0.0;     // of every sensor but the first, of either sign [s]
  double sampling_jitter = 0.0;  // sd of each cell edge about its regular time; told truly [s]
  double stamp_error = 0.0;      // sd of each told time about the true cell centre [s]
  double lost_share = 0.0;       // share of samples that never arrive, each on its own

  SoftTissue soft_tissue;

  // Sd per axis of the reference's joint positions [m]; its attitudes err as those of clusters of
  // three such markers, kMarkerDistance apart.
  double reference_noise = 0.0;

  bool tell_start_pose = true;
  bool tell_end_pose = false;        // that of the rest at the end
  bool tell_contacts = false;        // the scenario's, of segments that are worn
  bool tell_mountings = true;        // false: no recording has one, as before a calibration
  bool tell_carrying_angle = false;  // the true k0, as prior mean; otherwise the anatomical default
  bool tell_rests = false;           // the rests at both ends as "rest" intervals

  bool IsValid(std::string* why) const;
};

inline constexpr double kMarkerDistance = 0.1;  // [m]

// All that is wrong with sensors worn by people at once, in the sizes that are usual: scale 0.3 %,
// axes 0.2 deg, clocks 5 ms, jitter, 0.5 % lost, stated mountings 3 deg and 1.5 cm off, lengths
// 5 mm, soft tissue of 2 deg and 5 mm with 8 deg about the upper arm, a reference of 1 mm. Gyro
// biases are those of the class: 0.3 deg/s for MTw, 0.7 deg/s for MTx.
SimulationOptions HonestErrors(const ImuNoise& noise);

// Exact signals and exact knowledge: every error off.
SimulationOptions NoErrors();

}  // namespace brachium
