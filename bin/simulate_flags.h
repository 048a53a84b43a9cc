// The flags of brachium simulate: what moves, and what is wrong with what is recorded.
#pragma once

#include <string>

namespace brachium {

struct MovementFlags {
  std::string scenario;
  std::string side = "right";
  int seed = 1;
  double duration_s = 0.0;
  double slow = 1.0;
  int patient_week = 0;
  double carrying_angle_deg = 8.0;
  double carrying_angle_sd_deg = 0.0;
  double carrying_slope_deg = 3.0;
  double carrying_slope_sd_deg = 0.0;
  double adduction_rms_deg = 3.0;
  double shoulder_rms_m = 0.03;
  double execution_error_deg = 0.0;
  double tremor_deg = 0.0;

  template <typename Flags, typename Visitor>
  static void Visit(Flags& flags, Visitor&& visit) {
    visit("scenario", flags.scenario, "The movement; they are listed below.");
    visit("side", flags.side, "The arm: right or left.");
    visit("seed", flags.seed,
          "Another number gives another movement and other errors; the same one the same trial, "
          "byte for byte.");
    visit("duration_s", flags.duration_s,
          "Length of the trial, rests at both ends included [s]. 0: as long as the scenario takes, "
          "or 60 s where it goes on for as long as it is asked to.");
    visit("slow", flags.slow, "How many times slower to go along the same path.");
    visit("patient_week", flags.patient_week,
          "nine_hole_peg_test, range_of_motion: 1 to 10, a patient in that week of rehabilitation: "
          "slower, in strokes, with tremor and the trunk's help; 0, a healthy person.");
    visit("carrying_angle_deg", flags.carrying_angle_deg,
          "The elbow's true carrying angle, valgus positive [deg].");
    visit("carrying_angle_sd_deg", flags.carrying_angle_sd_deg,
          "More than 0: it is drawn with that sd about the angle above, which trial.json then "
          "states with this sigma [deg].");
    visit("carrying_slope_deg", flags.carrying_slope_deg,
          "How much more valgus the elbow is when straight than at 90 deg [deg].");
    visit("carrying_slope_sd_deg", flags.carrying_slope_sd_deg,
          "The same of the slope [deg]; what trial.json states is about 0.");
    visit("adduction_rms_deg", flags.adduction_rms_deg,
          "How far the elbow departs from its carrying angle, rms [deg].");
    visit("shoulder_rms_m", flags.shoulder_rms_m,
          "How far the shoulder wanders, rms per axis [m].");
    visit("execution_error_deg", flags.execution_error_deg,
          "How far each joint ends from where a movement should end, sd [deg].");
    visit("tremor_deg", flags.tremor_deg,
          "Tremor at 4-6 Hz of elbow flexion, pronation and wrist flexion, rms each [deg].");
  }
};

struct ErrorFlags {
  std::string noise = "mtw";
  int sensors = 0;
  bool draw_errors = false;
  std::string rate_hz = "100";
  double gyro_bias_deg_s = 0.3;
  double accel_bias = 0.04;
  double scale_error = 0.0;
  double misalignment_deg = 0.0;
  double lever_arm_error_m = 0.005;
  double mounting_error_deg = 0.0;
  double length_error_m = 0.003;
  double start_pose_error_deg = 0.0;
  double clock_offset_s = 0.0;
  double sampling_jitter_s = 0.0;
  double stamp_error_s = 0.0;
  double lost_share = 0.0;
  double soft_tissue_deg = 0.0;
  double upper_arm_soft_tissue_deg = 0.0;
  double reference_noise_m = 0.0;
  bool tell_start_pose = true;
  bool tell_end_pose = false;
  bool tell_contacts = false;
  bool tell_mountings = true;
  bool tell_carrying_angle = false;
  bool tell_rests = false;

  template <typename Flags, typename Visitor>
  static void Visit(Flags& flags, Visitor&& visit) {
    visit("noise", flags.noise,
          "White noise and drift of the sensors' class: mtw, mtx, or none for exact signals (the "
          "other errors below stay as they are).");
    visit("sensors", flags.sensors,
          "2: on upper arm and forearm; 4: also on girdle and hand; 0: as many as the scenario "
          "usually has.");
    visit("draw_errors", flags.draw_errors,
          "Take every size below, and both rms above, as the sd of what is drawn (per axis), and "
          "state it in trial.json where it has a place for it.");
    visit("rate_hz", flags.rate_hz,
          "Sampling rate [Hz]; or one for each sensor, proximal first: 100,60.");
    visit("gyro_bias_deg_s", flags.gyro_bias_deg_s, "Gyroscope bias, rms over the axes [deg/s].");
    visit("accel_bias", flags.accel_bias, "Accelerometer bias, rms over the axes [m/s^2].");
    visit("scale_error", flags.scale_error, "Scale error per axis, a share (cheap: 0.003).");
    visit("misalignment_deg", flags.misalignment_deg, "Sd of the sensor axes' directions [deg].");
    visit("lever_arm_error_m", flags.lever_arm_error_m,
          "Distance from the stated to the true place of each sensor [m].");
    visit("mounting_error_deg", flags.mounting_error_deg,
          "Angle from the stated to the true rotation of each sensor [deg]; 0: stated as exact.");
    visit("length_error_m", flags.length_error_m, "Error of each stated segment length [m].");
    visit("start_pose_error_deg", flags.start_pose_error_deg,
          "Sd of the stated angles of the start and the end pose [deg].");
    visit("clock_offset_s", flags.clock_offset_s, "Clock offset of all sensors but the first [s].");
    visit("sampling_jitter_s", flags.sampling_jitter_s,
          "Sd of the sampling instants about their regular times, truly stated [s].");
    visit("stamp_error_s", flags.stamp_error_s, "Sd of the stated about the true instants [s].");
    visit("lost_share", flags.lost_share, "Share of the samples that get lost.");
    visit("soft_tissue_deg", flags.soft_tissue_deg,
          "Wobble of the sensors about the long axes, rms [deg]; across them two fifths of it, and "
          "1 mm of shift per degree. On people 3 and more.");
    visit("upper_arm_soft_tissue_deg", flags.upper_arm_soft_tissue_deg,
          "Wobble about the upper arm's long axis, if it is another: on people 5-15 [deg].");
    visit("reference_noise_m", flags.reference_noise_m,
          "Noise of the reference's markers, sd per axis [m].");
    visit("tell_start_pose", flags.tell_start_pose, "State the start pose in trial.json.");
    visit("tell_end_pose", flags.tell_end_pose,
          "State the pose of the rest at the end in trial.json.");
    visit("tell_contacts", flags.tell_contacts,
          "State in trial.json when a point of the arm is at the same place: rectangle, the "
          "wrist at the corners; nine_hole_peg_test, the fingertip at the bowl and at the height "
          "of the desk.");
    visit("tell_mountings", flags.tell_mountings,
          "State the mountings in trial.json; without them it needs brachium calibrate.");
    visit("tell_carrying_angle", flags.tell_carrying_angle,
          "State the true carrying angle in trial.json.");
    visit("tell_rests", flags.tell_rests, "State the rests at both ends in trial.json.");
  }
};

}  // namespace brachium
