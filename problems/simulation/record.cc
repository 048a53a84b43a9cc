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
                              double rate, Draws draws) {
  const auto cells = static_cast<std::size_t>(scenario.options.duration * rate + 1e-9);
  std::vector<double> edges(cells + 1);
  for (std::size_t i = 0; i < edges.size(); ++i)
    edges[i] = static_cast<double>(i) / rate +
               options.sampling_jitter * std::clamp(draws.Normal(), -4.0, 4.0);
  return edges;
}

// A vector of that size in a random direction, or one of that sd along each axis.
Vector3d Draw(Vector3d (Draws::*of_size)(double), double size, bool drawn, Draws draws) {
  return drawn ? Vector3d(size * draws.Normal3()) : (draws.*of_size)(size);
}

// The mounting as it is told, with its errors and, where they are drawn, their sds.
Mounting TellMounting(const Scenario& scenario, const SimulationOptions& options,
                      const SensorTruth& sensor) {
  const Segment segment = sensor.worn.segment;
  const auto error = [&](const char* name, double size) {
    return Draw(&Draws::OfLength, size, options.draw_sizes,
                ErrorStream(scenario, options, name, segment));
  };
  Mounting told = sensor.worn.mounting;
  told.p_BS_B += error("lever_arm", options.lever_arm_error);
  told.q_BS = told.q_BS * Exp<double>(error("mounting_error", options.mounting_error));
  if (options.mounting_error == 0.0) told.q_sigma = 0.0;
  if (options.draw_sizes) {
    if (options.lever_arm_error > 0.0) told.p_sigma = options.lever_arm_error;
    if (options.mounting_error > 0.0) told.q_sigma = options.mounting_error;
  }
  return told;
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
  const std::vector<double> edges = CellEdges(scenario, options, sensor.rate, stream("jitter"));
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
    sensor.stamp_rms += shift * shift;
    recording.time.push_back(centre + shift - sensor.clock_offset);
    recording.gyr_S.push_back(sensor.gyro_gain * exact.gyr_S + gyro_bias + gyro_noise);
    recording.acc_S.push_back(sensor.accel_gain * exact.acc_S + sensor.accel_bias + accel_noise);
    if (sensor.worn.wobble.present)
      sensor.wobble_rms += Log(TurnOf(sensor.worn.wobble, centre).q_AB).cwiseAbs2();
  }
  sensor.gyro_bias_end = gyro_bias;
  const auto samples = static_cast<double>(recording.size());
  sensor.wobble_rms = (sensor.wobble_rms / samples).cwiseSqrt();
  sensor.stamp_rms = std::sqrt(sensor.stamp_rms / samples);
}

}  // namespace

Draws ErrorStream(const Scenario& scenario, const SimulationOptions& options,
                  std::string_view error, Segment segment) {
  const std::string name = std::to_string(scenario.options.seed) + "/" + std::string(error) + "/" +
                           std::string(Name(segment));
  return Draws(options.seed, name);
}

SensorTruth DrawSensor(const Scenario& scenario, const SimulationOptions& options, Segment segment,
                       bool first) {
  const auto stream = [&](const char* error) {
    return ErrorStream(scenario, options, error, segment);
  };
  const bool drawn = options.draw_sizes;
  Draws mounting = stream("mounting"), wobble = stream("wobble");
  SensorTruth sensor;
  sensor.worn.segment = segment;
  sensor.worn.mounting = DrawMounting(segment, scenario.shape.DistalJoint(segment), mounting);
  sensor.worn.wobble = DrawWobble(options.soft_tissue, segment, scenario.options.duration, wobble);
  if (options.tell_mountings) sensor.told = TellMounting(scenario, options, sensor);
  const auto own = options.own_rate.find(segment);
  sensor.rate = own == options.own_rate.end() ? options.rate : own->second;
  sensor.gyro_gain = DrawGain(options, stream("gyro_gain"));
  sensor.accel_gain = DrawGain(options, stream("accel_gain"));
  sensor.gyro_bias = Draw(&Draws::OfRms, options.gyro_bias, drawn, stream("gyro_bias"));
  sensor.accel_bias = Draw(&Draws::OfRms, options.accel_bias, drawn, stream("accel_bias"));
  Draws clock = stream("clock_offset");
  if (!first) sensor.clock_offset = options.clock_offset * (drawn ? clock.Normal() : clock.Sign());
  return sensor;
}

Recording Record(const Scenario& scenario, const SimulationOptions& options, SensorTruth& sensor) {
  Recording recording;
  recording.segment = sensor.worn.segment;
  recording.noise = options.noise.value_or(MtwNoise());
  if (options.draw_sizes) {
    if (options.gyro_bias > 0.0) recording.noise.gyro_bias_sigma = options.gyro_bias;
    if (options.accel_bias > 0.0) recording.noise.accel_bias_sigma = options.accel_bias;
  }
  recording.mounting = sensor.told;
  AddSamples(scenario, options, sensor, recording);
  return recording;
}

SensorTruth Mirrored(const SensorTruth& sensor) {
  const Matrix3d polar = Vector3d(1.0, 1.0, -1.0).asDiagonal();
  SensorTruth mirrored = sensor;
  mirrored.worn.mounting = Mirrored(sensor.worn.mounting);
  if (sensor.told) mirrored.told = Mirrored(*sensor.told);
  mirrored.gyro_gain = polar * sensor.gyro_gain * polar;
  mirrored.accel_gain = polar * sensor.accel_gain * polar;
  mirrored.gyro_bias = MirroredAxial(sensor.gyro_bias);
  mirrored.gyro_bias_end = MirroredAxial(sensor.gyro_bias_end);
  mirrored.accel_bias = MirroredPolar(sensor.accel_bias);
  return mirrored;
}

}  // namespace brachium
