// brachium simulate: a trial folder whose truth is known.
#include "problems/simulation/simulate.h"

#include <algorithm>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

#include "bin/commands.h"
#include "bin/help.h"
#include "bin/options_json.h"
#include "bin/termination.h"
#include "io/text.h"
#include "io/trial_folder.h"

namespace brachium {
namespace {

struct OutputFlags {
  std::string output;
  bool overwrite = false;

  template <typename Flags, typename Visitor>
  static void Visit(Flags& flags, Visitor&& visit) {
    visit("output", flags.output, "The trial folder to be written.");
    visit("overwrite", flags.overwrite, "Replace an older trial folder.");
  }
};

struct MovementFlags {
  std::string scenario;
  std::string side = "right";
  int seed = 1;
  double duration_s = 60.0;
  double slow = 1.0;
  double carrying_angle_deg = 8.0;
  double adduction_rms_deg = 3.0;
  double shoulder_rms_m = 0.03;

  template <typename Flags, typename Visitor>
  static void Visit(Flags& flags, Visitor&& visit) {
    visit("scenario", flags.scenario,
          "The movement: daily_brisk, daily_slow, reach, shrug or calibration.");
    visit("side", flags.side, "The arm: right or left.");
    visit("seed", flags.seed,
          "Another number gives another movement and other errors; the same one the same trial, "
          "byte for byte.");
    visit("duration_s", flags.duration_s, "Length of the trial, rests at both ends included [s].");
    visit("slow", flags.slow, "How many times slower to go along the same path.");
    visit("carrying_angle_deg", flags.carrying_angle_deg,
          "The elbow's true carrying angle, valgus positive [deg].");
    visit("adduction_rms_deg", flags.adduction_rms_deg,
          "How far the elbow departs from its carrying angle, rms [deg].");
    visit("shoulder_rms_m", flags.shoulder_rms_m,
          "How far the shoulder wanders, rms per axis [m].");
  }
};

struct ErrorFlags {
  std::string noise = "mtw";
  double rate_hz = 100.0;
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
  bool tell_start_pose = true;
  bool tell_mountings = true;
  bool tell_carrying_angle = false;
  bool tell_rests = false;

  template <typename Flags, typename Visitor>
  static void Visit(Flags& flags, Visitor&& visit) {
    visit("noise", flags.noise,
          "White noise and drift of the sensors' class: mtw, mtx, or none for exact signals (the "
          "other errors below stay as they are).");
    visit("rate_hz", flags.rate_hz, "Sampling rate [Hz].");
    visit("gyro_bias_deg_s", flags.gyro_bias_deg_s, "Gyroscope bias, rms over the axes [deg/s].");
    visit("accel_bias", flags.accel_bias, "Accelerometer bias, rms over the axes [m/s^2].");
    visit("scale_error", flags.scale_error, "Scale error per axis, a share (cheap: 0.003).");
    visit("misalignment_deg", flags.misalignment_deg, "Sd of the sensor axes' directions [deg].");
    visit("lever_arm_error_m", flags.lever_arm_error_m,
          "Distance from the stated to the true place of each sensor [m].");
    visit("mounting_error_deg", flags.mounting_error_deg,
          "Angle from the stated to the true rotation of each sensor [deg].");
    visit("length_error_m", flags.length_error_m, "Error of each stated segment length [m].");
    visit("start_pose_error_deg", flags.start_pose_error_deg,
          "Sd of the stated start angles [deg].");
    visit("clock_offset_s", flags.clock_offset_s, "Clock offset of all sensors but the first [s].");
    visit("sampling_jitter_s", flags.sampling_jitter_s,
          "Sd of the sampling instants about their regular times, truly stated [s].");
    visit("stamp_error_s", flags.stamp_error_s, "Sd of the stated about the true instants [s].");
    visit("lost_share", flags.lost_share, "Share of the samples that get lost.");
    visit("soft_tissue_deg", flags.soft_tissue_deg,
          "Wobble of the sensors about the long axes, rms [deg]; across them two fifths of it, and "
          "1 mm of shift per degree. On people 3 and more.");
    visit("tell_start_pose", flags.tell_start_pose, "State the start pose in trial.json.");
    visit("tell_mountings", flags.tell_mountings,
          "State the mountings in trial.json; without them it needs brachium calibrate.");
    visit("tell_carrying_angle", flags.tell_carrying_angle,
          "State the true carrying angle in trial.json.");
    visit("tell_rests", flags.tell_rests, "State the rests at both ends in trial.json.");
  }
};

const CommandHelp kHelp = {
    "--scenario=NAME --output=DIR [flags]",
    "Writes a trial folder of two sensors on an arm that moves in a known way. The truth stands in "
    "it as the reference, and truth.json holds the constants that an estimate may be asked for. "
    "The folder says that it is simulated."};

SoftTissue SoftTissueOf(double along_rms) {
  SoftTissue tissue = TypicalSoftTissue();
  const double factor = along_rms / tissue.along_rms;
  tissue.along_rms *= factor;
  tissue.across_rms *= factor;
  tissue.translation_rms *= factor;
  return tissue;
}

Side SideFrom(const std::string& name) {
  for (const Side side : {Side::kRight, Side::kLeft})
    if (Name(side) == name) return side;
  throw UsageError("--side=" + name + ": right or left was expected");
}

void RequireScenario(const std::string& name) {
  const std::vector<std::string> names = ScenarioNames();
  const std::vector<std::string_view> known(names.begin(), names.end());
  if (std::find(known.begin(), known.end(), name) == known.end())
    throw UsageError("--scenario=" + name + " is not known" + DidYouMean(name, known) +
                     " (known: " + Listed(known) + ")");
}

ScenarioOptions ScenarioFrom(const MovementFlags& flags) {
  ScenarioOptions scenario;
  scenario.name = flags.scenario;
  scenario.seed = static_cast<std::uint64_t>(flags.seed);
  scenario.side = SideFrom(flags.side);
  scenario.duration = flags.duration_s;
  scenario.time_scale = flags.slow;
  scenario.carrying_angle = flags.carrying_angle_deg * kDegree;
  scenario.adduction_rms = flags.adduction_rms_deg * kDegree;
  scenario.shoulder_rms = flags.shoulder_rms_m;
  RequireValid(scenario);
  return scenario;
}

SimulationOptions ErrorsFrom(const ErrorFlags& flags, int seed) {
  SimulationOptions errors;
  errors.seed = static_cast<std::uint64_t>(seed);
  errors.rate = flags.rate_hz;
  errors.noise = NoiseFromPreset(flags.noise);
  if (!errors.noise && flags.noise != "none")
    throw UsageError("--noise=" + flags.noise + ": mtw, mtx or none was expected");
  errors.gyro_bias = flags.gyro_bias_deg_s * kDegree;
  errors.accel_bias = flags.accel_bias;
  errors.scale_error = flags.scale_error;
  errors.misalignment = flags.misalignment_deg * kDegree;
  errors.lever_arm_error = flags.lever_arm_error_m;
  errors.mounting_error = flags.mounting_error_deg * kDegree;
  errors.length_error = flags.length_error_m;
  errors.start_pose_error = flags.start_pose_error_deg * kDegree;
  errors.clock_offset = flags.clock_offset_s;
  errors.sampling_jitter = flags.sampling_jitter_s;
  errors.stamp_error = flags.stamp_error_s;
  errors.lost_share = flags.lost_share;
  errors.soft_tissue = SoftTissueOf(flags.soft_tissue_deg * kDegree);
  errors.tell_start_pose = flags.tell_start_pose;
  errors.tell_mountings = flags.tell_mountings;
  errors.tell_carrying_angle = flags.tell_carrying_angle;
  errors.tell_rests = flags.tell_rests;
  RequireValid(errors);
  return errors;
}

std::string TruthJson(const SimulatedTrial& simulated, const MovementFlags& movement,
                      const ErrorFlags& errors) {
  nlohmann::ordered_json truth;
  for (const auto& [name, value] : simulated.truth) {
    if (value.size() == 1)
      truth[name] = value[0];
    else
      truth[name] = value;
  }
  const nlohmann::ordered_json json = {{"simulated", true},
                                       {"scenario", ToJson(movement)},
                                       {"errors", ToJson(errors)},
                                       {"truth", truth}};
  return json.dump(2) + "\n";
}

}  // namespace

int RunSimulate(CommandLine& line) {
  OutputFlags place;
  MovementFlags movement;
  ErrorFlags errors;
  line.Add("Flags", place);
  line.Add("Movement", movement);
  line.Add("Errors of the sensors and of what trial.json states", errors);
  if (ShowHelp(line, kHelp)) return kGood;
  line.Read();
  RequireGiven(movement.scenario, "scenario");
  RequireScenario(movement.scenario);
  RequireGiven(place.output, "output");

  const Scenario scenario = MakeScenario(ScenarioFrom(movement));
  const SimulatedTrial simulated = Simulate(scenario, ErrorsFrom(errors, movement.seed));
  {
    const WithoutInterruption writing;
    WriteTrial(place.output, simulated.trial,
               {.simulated = true, .truth_json = TruthJson(simulated, movement, errors)},
               place.overwrite);
  }
  std::cout << "Simulated trial " << simulated.trial.name << " (" << movement.side << " arm, "
            << Shortest(movement.duration_s) << " s) in " << place.output << "\n";
  return kGood;
}

}  // namespace brachium
