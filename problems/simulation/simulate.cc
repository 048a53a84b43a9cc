#include "problems/simulation/simulate.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "problems/rotation.h"
#include "problems/simulation/mirror.h"
#include "problems/simulation/record.h"

namespace brachium {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;

std::vector<Segment> Worn(const Scenario& scenario, const SimulationOptions& options) {
  return options.worn.empty() ? scenario.worn : options.worn;
}

// A segment as a tape finds it.
SegmentGeometry ToldGeometry(const Scenario& scenario, const SimulationOptions& options,
                             Segment segment) {
  Draws draws = ErrorStream(scenario, options, "length", segment);
  const Vector3d distal = scenario.shape.DistalJoint(segment);
  const double error = options.length_error;
  SegmentGeometry told;
  if (segment == Segment::kGirdle)
    told.p_distal_B =
        distal + (options.draw_sizes ? Vector3d(error * draws.Normal3()) : draws.OfLength(error));
  else
    told.p_distal_B = {
        0.0, distal.y() - (options.draw_sizes ? draws.Normal() : draws.Sign()) * error, 0.0};
  if (options.draw_sizes && error > 0.0) told.sigma = error;
  return told;
}

// The elbow and the shoulder keep their anatomical defaults where nothing is told of them.
ArmModel ToldArm(const Scenario& scenario, const SimulationOptions& options) {
  const ScenarioOptions& movement = scenario.options;
  ArmModel arm;
  for (const Segment segment : Worn(scenario, options))
    arm.segments[segment] = ToldGeometry(scenario, options, segment);
  if (options.tell_carrying_angle) arm.elbow.carrying_angle = scenario.shape.carrying_angle;
  if (movement.carrying_angle_sd > 0.0) {
    arm.elbow.carrying_angle = movement.carrying_angle;
    arm.elbow.carrying_angle_sigma = movement.carrying_angle_sd;
  }
  if (movement.carrying_slope_sd > 0.0) arm.elbow.carrying_slope_sigma = movement.carrying_slope_sd;
  if (options.draw_sizes && scenario.shoulder.sigma > 0.0) arm.shoulder = scenario.shoulder;
  if (scenario.rig) {
    arm.elbow = {.carrying_angle = 0.0,
                 .carrying_angle_sigma = 1 * kDegree,
                 .carrying_slope_sigma = 0.5 * kDegree};
    arm.shoulder.sigma = 1e-3;
  }
  return arm;
}

// The pose of both rests, as it is told of the one about that time.
HeldPose ToldPose(const Scenario& scenario, const SimulationOptions& options, double time,
                  std::string_view error) {
  Draws draws = ErrorStream(scenario, options, error, Segment::kUpperArm);
  const auto told = [&](double angle) { return angle + options.start_pose_error * draws.Normal(); };
  const JointValues& pose = scenario.start;
  const double flexed = pose[kShoulderFlexion], abducted = pose[kShoulderAbduction];
  HeldPose held;
  held.time = time;
  held.elbow_flexion = told(pose[kElbowFlexion]);
  held.forearm_pronation = told(pose[kForearmPronation]);
  held.shoulder_elevation =
      std::abs(told(flexed == 0.0 ? abducted : std::acos(std::cos(flexed) * std::cos(abducted))));
  if (options.draw_sizes && options.start_pose_error > 0.0) held.sigma = options.start_pose_error;
  return held;
}

std::vector<Contact> ToldContacts(const Scenario& scenario, const std::vector<Segment>& worn) {
  std::vector<Contact> told;
  for (const Contact& contact : scenario.contacts)
    if (std::find(worn.begin(), worn.end(), contact.segment) != worn.end()) told.push_back(contact);
  return told;
}

// The rests at both ends, a margin away from the movements.
std::vector<Interval> Rests(const Scenario& scenario) {
  constexpr double kMargin = 0.2;  // [s]
  const double end = scenario.options.duration;
  return {{"rest", 0.0, kRestAtStart - kMargin}, {"rest", end - kRestAtEnd + kMargin, end}};
}

// Joints and attitudes as markers of that noise show them.
void AddMarkerNoise(double noise, Draws draws, Reference& reference) {
  const double turn = std::sqrt(2.0) * noise / kMarkerDistance;
  for (auto& [segment, q_VB] : reference.q_VB)
    for (Quaterniond& q : q_VB) q = (q * Exp<double>(turn * draws.Normal3())).normalized();
  for (auto& [joint, p_V] : reference.p_V)
    for (Vector3d& p : p_V) p += noise * draws.Normal3();
}

// The middles of regular sampling cells: cameras lose nothing.
std::vector<double> CameraTimes(const Scenario& scenario, double rate) {
  const auto cells = static_cast<int>(std::floor(scenario.options.duration * rate + 1e-9));
  std::vector<double> time;
  for (int i = 0; i < cells; ++i) time.push_back(0.5 * (i / rate + (i + 1) / rate));
  return time;
}

Reference MakeReference(const Scenario& scenario, const SimulationOptions& options,
                        const std::vector<double>& time) {
  const std::vector<Segment> worn = Worn(scenario, options);
  const bool hand = std::find(worn.begin(), worn.end(), Segment::kHand) != worn.end();
  Reference reference;
  reference.time = time;
  reference.clock_offset = 0.0;
  for (const double t : time) {
    const ArmMotion arm = scenario.At(t);
    for (const Segment segment : worn) reference.q_VB[segment].push_back(arm[segment].turning.q_AB);
    reference.p_V["shoulder"].push_back(arm.upper_arm.joint_W.p);
    reference.p_V["elbow"].push_back(arm.forearm.joint_W.p);
    reference.p_V["wrist"].push_back(arm.wrist_W.p);
    if (hand) reference.p_V["hand"].push_back(arm.fingertip_W.p);
  }
  if (options.reference_noise > 0.0)
    AddMarkerNoise(options.reference_noise,
                   ErrorStream(scenario, options, "reference", worn.front()), reference);
  return reference;
}

std::vector<Quaterniond> AttitudesBySensor(const Scenario& scenario, const SensorTruth& sensor,
                                           const std::vector<double>& time) {
  std::vector<Quaterniond> q_WB;
  if (sensor.told)
    for (const double t : time)
      q_WB.push_back(At(sensor.worn, scenario, t).q_WS * sensor.told->q_BS.conjugate());
  return q_WB;
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
  if (sensor.told) {
    const Vector3d off = Log<double>(q_BS.conjugate() * sensor.told->q_BS);
    truth.push_back({name + ".told_q_BS_error_deg", List(Vector3d(off / kDegree))});
    truth.push_back({name + ".told_p_BS_error_m",
                     List(Vector3d(sensor.told->p_BS_B - sensor.worn.mounting.p_BS_B))});
  }
  truth.push_back({name + ".rate_hz", {sensor.rate}});
  truth.push_back({name + ".stamp_rms_s", {sensor.stamp_rms}});
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

void AddArmTruth(const Scenario& scenario, const SimulationOptions& options,
                 const std::vector<double>& time, bool left, std::vector<TrueValue>& truth) {
  const ArmShape& shape = scenario.shape;
  for (const Segment segment : Worn(scenario, options)) {
    const Vector3d distal = shape.DistalJoint(segment);
    const std::string name(Name(segment));
    if (segment == Segment::kGirdle)
      truth.push_back({name + ".distal_joint_m", List(left ? MirroredPolar(distal) : distal)});
    else
      truth.push_back({name + ".length_m", {-distal.y()}});
  }
  const auto rms = [&](Joint joint) { return Rms(scenario.joints[joint], time); };
  truth.push_back({"elbow.carrying_angle_deg", {shape.carrying_angle / kDegree}});
  truth.push_back({"elbow.carrying_slope_deg", {shape.carrying_slope / kDegree}});
  truth.push_back({"elbow.adduction_rms_deg", {rms(kElbowAdduction) / kDegree}});
  truth.push_back(
      {"shoulder.rms_m", {rms(kShoulderForward), rms(kShoulderUp), rms(kShoulderRight)}});
  const double heading = scenario.trunk_heading / kDegree;
  truth.push_back({"trunk.heading_deg", {left ? -heading : heading}});
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
  const int week = scenario.options.patient_week;
  trial.name = scenario.options.name + (week > 0 ? "-week" + std::to_string(week) : "") + "-" +
               std::string(Name(scenario.options.side)) + "-" +
               std::to_string(scenario.options.seed);
  trial.observations.arm = ToldArm(right, options);
  if (options.tell_start_pose)
    trial.observations.start_pose = ToldPose(right, options, 0.5 * kRestAtStart, "start_pose");
  if (options.tell_end_pose)
    trial.observations.end_pose =
        ToldPose(right, options, right.options.duration - 0.5 * kRestAtEnd, "end_pose");
  if (options.tell_contacts)
    trial.observations.contacts = ToldContacts(right, Worn(right, options));
  trial.observations.intervals = right.intervals;
  if (options.tell_rests)
    for (const Interval& rest : Rests(right)) trial.observations.intervals.push_back(rest);
  std::vector<SensorTruth> sensors;
  for (const Segment segment : Worn(right, options)) {
    sensors.push_back(DrawSensor(right, options, segment, sensors.empty()));
    trial.observations.recordings.push_back(Record(right, options, sensors.back()));
  }
  const std::vector<double> time = CameraTimes(right, sensors.front().rate);
  trial.reference = MakeReference(right, options, time);

  Trial by_sensors;
  by_sensors.reference.emplace();
  for (const SensorTruth& sensor : sensors)
    by_sensors.reference->q_VB[sensor.worn.segment] = AttitudesBySensor(right, sensor, time);

  if (left) {
    trial = Mirrored(trial);
    by_sensors = Mirrored(by_sensors);
  }
  simulated.sensors_q_VB = std::move(by_sensors.reference->q_VB);
  AddArmTruth(right, options, time, left, simulated.truth);
  for (const SensorTruth& sensor : sensors)
    AddSensorTruth(left ? Mirrored(sensor) : sensor, simulated.truth);
  simulated.truth.insert(simulated.truth.end(), scenario.facts.begin(), scenario.facts.end());
  return simulated;
}

}  // namespace brachium
