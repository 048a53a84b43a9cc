#include "problems/simulation/record.h"

#include <algorithm>
#include <cmath>

#include "problems/rotation.h"
#include "problems/simulation/mirror.h"

namespace brachium {
namespace {

using Eigen::Matrix3d, Eigen::Vector3d;

Matrix3d DrawGain(const SimulationOptions& options, Draws draws) {
  Matrix3d gain;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      gain(i, j) = i == j ? 1.0 + options.scale_error * draws.Normal()
                          : options.misalignment * draws.Normal();
  return gain;
}

// Edges of the sampling cells [s]: regular, or displaced by at most four standard deviations.
std::vector<double> CellEdges(const Scenario& scenario, const SimulationOptions& options,
                              Draws draws) {
  const auto cells = static_cast<std::size_t>(scenario.options.duration * options.rate + 1e-9);
  std::vector<double> edges(cells + 1);
  for (std::size_t i = 0; i < edges.size(); ++i)
    edges[i] = static_cast<double>(i) / options.rate +
               options.sampling_jitter * std::clamp(draws.Normal(), -4.0, 4.0);
  return edges;
}

struct Sample {
  Vector3d gyr_S = Vector3d::Zero(), acc_S = Vector3d::Zero();
};

// Four-point Gauss-Legendre mean of the exact signals between two instants.
Sample CellMean(const WornSensor& sensor, const Scenario& scenario, double start, double end) {
  constexpr double kNode[] = {0.3399810435848563, 0.8611363115940526};
  constexpr double kWeight[] = {0.3260725774312731, 0.1739274225687269};
  Sample mean;
  for (int i = 0; i < 2; ++i)
    for (const double side : {-1.0, 1.0}) {
      const double t = 0.5 * (start + end) + 0.5 * (end - start) * side * kNode[i];
      const SensorInstant instant = At(sensor, scenario, t);
      mean.gyr_S += kWeight[i] * instant.gyr_S;
      mean.acc_S += kWeight[i] * instant.acc_S;
    }
  return mean;
}

// Adds the samples of one sensor to its recording, and to its truth what only they decide.
void AddSamples(const Scenario& scenario, const SimulationOptions& options, SensorTruth& sensor,
                Recording& recording) {
  const auto stream = [&](const char* error) {
    return ErrorStream(scenario, options, error, sensor.worn.segment);
  };
  Draws noise = stream("noise"), walk = stream("walk"), loss = stream("loss"),
        stamp = stream("stamp");
  const ImuNoise density = options.noise.value_or(ImuNoise{0.0, 0.0, 0.0, 0.0, 0.0});
  const std::vector<double> edges = CellEdges(scenario, options, stream("jitter"));
  Vector3d gyro_bias = sensor.gyro_bias;
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    const double h = edges[i + 1] - edges[i];
    const Vector3d gyro_noise = density.gyro_density / std::sqrt(2.0 * h) * noise.Normal3();
    const Vector3d accel_noise = density.accel_density / std::sqrt(2.0 * h) * noise.Normal3();
    if (i > 0) gyro_bias += density.gyro_bias_walk * std::sqrt(h) * walk.Normal3();
    const double shift = options.stamp_error * std::clamp(stamp.Normal(), -4.0, 4.0);
    const bool end = i == 0 || i + 2 == edges.size();
    if (loss.Uniform(0.0, 1.0) < options.lost_share && !end) {
      ++sensor.lost;
      continue;
    }
    const Sample exact = CellMean(sensor.worn, scenario, edges[i], edges[i + 1]);
    const double centre = 0.5 * (edges[i] + edges[i + 1]);
    recording.time.push_back(centre + shift - sensor.clock_offset);
    recording.gyr_S.push_back(sensor.gyro_gain * exact.gyr_S + gyro_bias + gyro_noise);
    recording.acc_S.push_back(sensor.accel_gain * exact.acc_S + sensor.accel_bias + accel_noise);
    if (sensor.worn.wobble.present)
      sensor.wobble_rms += Log(TurnOf(sensor.worn.wobble, centre).q_AB).cwiseAbs2();
  }
  sensor.gyro_bias_end = gyro_bias;
  sensor.wobble_rms = (sensor.wobble_rms / static_cast<double>(recording.size())).cwiseSqrt();
}

}  // namespace

Draws ErrorStream(const Scenario& scenario, const SimulationOptions& options,
                  std::string_view error, Segment segment) {
  const std::string name = std::to_string(scenario.options.seed) + "/" + std::string(error) + "/" +
                           std::string(Name(segment));
  return Draws(options.seed, name);
}

SensorTruth DrawSensor(const Scenario& scenario, const SimulationOptions& options,
                       Segment segment) {
  const auto stream = [&](const char* error) {
    return ErrorStream(scenario, options, error, segment);
  };
  Draws mounting = stream("mounting"), wobble = stream("wobble");
  SensorTruth sensor;
  sensor.worn.segment = segment;
  sensor.worn.mounting = DrawMounting(segment, scenario.length.at(segment), mounting);
  sensor.worn.wobble = DrawWobble(options.soft_tissue, scenario.options.duration, wobble);
  sensor.gyro_gain = DrawGain(options, stream("gyro_gain"));
  sensor.accel_gain = DrawGain(options, stream("accel_gain"));
  sensor.gyro_bias = stream("gyro_bias").OfRms(options.gyro_bias);
  sensor.accel_bias = stream("accel_bias").OfRms(options.accel_bias);
  if (segment != Segment::kUpperArm)
    sensor.clock_offset = options.clock_offset * stream("clock_offset").Sign();
  return sensor;
}

Recording Record(const Scenario& scenario, const SimulationOptions& options, SensorTruth& sensor) {
  const Segment segment = sensor.worn.segment;
  Recording recording;
  recording.segment = segment;
  recording.noise = options.noise.value_or(MtwNoise());
  Mounting told = sensor.worn.mounting;
  told.p_BS_B +=
      ErrorStream(scenario, options, "lever_arm", segment).OfLength(options.lever_arm_error);
  const Vector3d turn =
      ErrorStream(scenario, options, "mounting_error", segment).OfLength(options.mounting_error);
  told.q_BS = told.q_BS * Exp<double>(turn);
  if (options.tell_mountings) recording.mounting = told;
  AddSamples(scenario, options, sensor, recording);
  return recording;
}

SensorTruth Mirrored(const SensorTruth& sensor) {
  const Matrix3d polar = Vector3d(1.0, 1.0, -1.0).asDiagonal();
  SensorTruth mirrored = sensor;
  mirrored.worn.mounting = Mirrored(sensor.worn.mounting);
  mirrored.gyro_gain = polar * sensor.gyro_gain * polar;
  mirrored.accel_gain = polar * sensor.accel_gain * polar;
  mirrored.gyro_bias = MirroredAxial(sensor.gyro_bias);
  mirrored.gyro_bias_end = MirroredAxial(sensor.gyro_bias_end);
  mirrored.accel_bias = MirroredPolar(sensor.accel_bias);
  return mirrored;
}

}  // namespace brachium
