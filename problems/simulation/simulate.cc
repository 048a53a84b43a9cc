#include "problems/simulation/simulate.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "problems/simulation/mirror.h"
#include "problems/simulation/record.h"

namespace brachium {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;

// Segments and the told part of the arm; the elbow and the shoulder keep their anatomical defaults.
ArmModel ToldArm(const Scenario& scenario, const SimulationOptions& options) {
  ArmModel arm;
  for (const auto& [segment, length] : scenario.length) {
    const double sign = ErrorStream(scenario, options, "length", segment).Sign();
    arm.segments[segment].p_distal_B = {0.0, -(length + sign * options.length_error), 0.0};
  }
  if (options.tell_carrying_angle) arm.elbow.carrying_angle = scenario.options.carrying_angle;
  return arm;
}

StartPose ToldStartPose(const Scenario& scenario, const SimulationOptions& options) {
  Draws draws = ErrorStream(scenario, options, "start_pose", Segment::kUpperArm);
  const auto told = [&](double angle) { return angle + options.start_pose_error * draws.Normal(); };
  const JointValues pose = StartPoseJoints();
  StartPose start;
  start.time = 0.5 * kRestAtStart;
  start.elbow_flexion = told(pose[kElbowFlexion]);
  start.forearm_pronation = told(pose[kForearmPronation]);
  start.shoulder_elevation = std::abs(told(pose[kShoulderAbduction]));
  return start;
}

// The rests at both ends, a margin away from the movements.
std::vector<Interval> Rests(const Scenario& scenario) {
  constexpr double kMargin = 0.2;  // [s]
  const double end = scenario.options.duration;
  return {{"rest", 0.0, kRestAtStart - kMargin}, {"rest", end - kRestAtEnd + kMargin, end}};
}

Reference MakeReference(const Scenario& scenario, const std::vector<double>& time) {
  Reference reference;
  reference.time = time;
  reference.clock_offset = 0.0;
  for (const double t : time) {
    const ArmMotion arm = scenario.At(t);
    reference.q_VB[Segment::kUpperArm].push_back(arm.upper_arm.turning.q_AB);
    reference.q_VB[Segment::kForearm].push_back(arm.forearm.turning.q_AB);
    reference.p_V["shoulder"].push_back(arm.upper_arm.joint_W.p);
    reference.p_V["elbow"].push_back(arm.forearm.joint_W.p);
    reference.p_V["wrist"].push_back(arm.wrist_W.p);
  }
  return reference;
}

// Adding zero makes -0 a plain 0.
std::vector<double> List(const Vector3d& v) { return {v.x() + 0.0, v.y() + 0.0, v.z() + 0.0}; }

std::vector<double> List(const Eigen::Matrix3d& m) {
  std::vector<double> list;
  for (int i = 0; i < 9; ++i) list.push_back(m(i / 3, i % 3) + 0.0);
  return list;
}

void AddSensorTruth(const SensorTruth& sensor, std::vector<TrueValue>& truth) {
  const std::string name(Name(sensor.worn.segment));
  const Quaterniond& q_BS = sensor.worn.mounting.q_BS;
  truth.push_back({name + ".q_BS_wxyz", {q_BS.w(), q_BS.x(), q_BS.y(), q_BS.z()}});
  truth.push_back({name + ".p_BS_m", List(sensor.worn.mounting.p_BS_B)});
  truth.push_back({name + ".gyro_bias", List(sensor.gyro_bias)});
  truth.push_back({name + ".gyro_bias_end", List(sensor.gyro_bias_end)});
  truth.push_back({name + ".accelerometer_bias", List(sensor.accel_bias)});
  truth.push_back({name + ".gyro_gain", List(sensor.gyro_gain)});
  truth.push_back({name + ".accelerometer_gain", List(sensor.accel_gain)});
  truth.push_back({name + ".clock_offset_s", {sensor.clock_offset}});
  truth.push_back({name + ".soft_tissue_rms_deg", List(Vector3d(sensor.wobble_rms / kDegree))});
  truth.push_back({name + ".lost_samples", {static_cast<double>(sensor.lost)}});
}

// Root mean square of a joint's motion about its mean, over the given times.
double Rms(const Motion& motion, const std::vector<double>& time) {
  double sum = 0.0, squares = 0.0;
  for (const double t : time) {
    const double value = motion.At(t).value;
    sum += value;
    squares += value * value;
  }
  const double n = static_cast<double>(time.size());
  return std::sqrt(std::max(0.0, squares / n - sum * sum / (n * n)));
}

void AddArmTruth(const Scenario& scenario, const std::vector<double>& time,
                 std::vector<TrueValue>& truth) {
  const ScenarioOptions& options = scenario.options;
  for (const auto& [segment, length] : scenario.length)
    truth.push_back({std::string(Name(segment)) + ".length_m", {length}});
  const auto rms = [&](Joint joint) { return Rms(scenario.joints[joint], time); };
  truth.push_back({"elbow.carrying_angle_deg", {options.carrying_angle / kDegree}});
  truth.push_back({"elbow.carrying_slope_deg", {options.carrying_slope / kDegree}});
  truth.push_back({"elbow.adduction_rms_deg", {rms(kElbowAdduction) / kDegree}});
  truth.push_back(
      {"shoulder.rms_m", {rms(kShoulderForward), rms(kShoulderUp), rms(kShoulderRight)}});
}

}  // namespace

const std::vector<double>& SimulatedTrial::True(const std::string& name) const {
  for (const TrueValue& value : truth)
    if (value.name == name) return value.value;
  throw std::out_of_range("no true value named " + name);
}

SimulatedTrial Simulate(const Scenario& scenario, const SimulationOptions& options) {
  const bool left = scenario.options.side == Side::kLeft;
  Scenario right = scenario;
  right.options.side = Side::kRight;

  SimulatedTrial simulated;
  Trial& trial = simulated.trial;
  trial.name = scenario.options.name + "-" + std::string(Name(scenario.options.side)) + "-" +
               std::to_string(scenario.options.seed);
  trial.observations.arm = ToldArm(right, options);
  if (options.tell_start_pose) trial.observations.start_pose = ToldStartPose(right, options);
  trial.observations.intervals = right.intervals;
  if (options.tell_rests)
    for (const Interval& rest : Rests(right)) trial.observations.intervals.push_back(rest);
  std::vector<SensorTruth> sensors;
  for (const auto& [segment, length] : right.length) {
    sensors.push_back(DrawSensor(right, options, segment));
    trial.observations.recordings.push_back(Record(right, options, sensors.back()));
  }
  const std::vector<double> time = trial.observations.recordings.front().time;
  trial.reference = MakeReference(right, time);

  if (left) trial = Mirrored(trial);
  AddArmTruth(right, time, simulated.truth);
  for (const SensorTruth& sensor : sensors)
    AddSensorTruth(left ? Mirrored(sensor) : sensor, simulated.truth);
  return simulated;
}

}  // namespace brachium
