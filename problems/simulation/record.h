// What one sensor records of a scenario, and what only the simulator knows about it.
#pragma once

#include "problems/simulation/worn_sensor.h"

namespace brachium {

// All about one sensor that the estimator is not told.
struct SensorTruth {
  WornSensor worn;
  Eigen::Matrix3d gyro_gain = Eigen::Matrix3d::Identity();  // measured = gain * true + bias
  Eigen::Matrix3d accel_gain = Eigen::Matrix3d::Identity();
  Eigen::Vector3d gyro_bias = Eigen::Vector3d::Zero();      // at the first sample
  Eigen::Vector3d gyro_bias_end = Eigen::Vector3d::Zero();  // at the last
  Eigen::Vector3d accel_bias = Eigen::Vector3d::Zero();
  std::optional<Mounting> told;                          // absent: none is
  double rate = 0.0;                                     // [Hz]
  double clock_offset = 0.0;                             // true time = told time + offset
  Eigen::Vector3d wobble_rms = Eigen::Vector3d::Zero();  // of the turning, over the samples
  double stamp_rms = 0.0;                                // of told against true times [s]
  std::size_t lost = 0;
};

// The stream of one kind of error of one sensor or segment.
Draws ErrorStream(const Scenario& scenario, const SimulationOptions& options,
                  std::string_view error, Segment segment);

// Draws how a segment's sensor is worn, how wrong it is and how wrongly its mounting is told. The
// right arm's, whatever the side. The first sensor's clock is right.
SensorTruth DrawSensor(const Scenario& scenario, const SimulationOptions& options, Segment segment,
                       bool first);

// The recording, with what is told of it; completes `sensor` by what only the samples decide.
Recording Record(const Scenario& scenario, const SimulationOptions& options, SensorTruth& sensor);

// The mirror image, as of a trial.
SensorTruth Mirrored(const SensorTruth& sensor);

}  // namespace brachium
