// Sensors beyond the simulated arm's two: on a thorax that stands still and on a hand that waves.
#pragma once

#include "problems/simulation/scenario.h"
#include "problems/trial.h"
#include "tests/support/moving_sensor.h"

namespace brachium {

// The hand of a scenario: it flexes and extends about the wrist, without a rest.
inline BodyMotion WavingHand(const Scenario& scenario, double t) {
  const ArmMotion arm = scenario.At(t);
  return {arm.forearm.turning * About(Eigen::Vector3d::UnitZ(), Sine(0.4, 3.0, 0.3, t)),
          arm.wrist_W};
}

inline void AddHand(const Scenario& scenario, Trial& trial) {
  const Mounting mounting{.q_BS = Exp<double>(Eigen::Vector3d(0.1, -0.2, 0.05)),
                          .p_BS_B = {-0.01, -0.06, 0.005}};
  const std::vector<double> time = trial.observations.recordings.front().time;
  trial.observations.recordings.push_back(
      Recorded([&](double t) { return SensorOn(WavingHand(scenario, t), mounting); }, time));
  Recording& recording = trial.observations.recordings.back();
  recording.segment = Segment::kHand;
  recording.mounting = mounting;
  trial.observations.arm.segments[Segment::kHand].p_distal_B = {0.0, -0.08, 0.0};
  for (const double t : time)
    trial.reference->q_VB[Segment::kHand].push_back(WavingHand(scenario, t).turning.q_AB);
}

// The trunk of a scenario of a right arm, 0.2 m to the left of and 0.1 m below the shoulder.
inline void AddThorax(const Scenario& scenario, Trial& trial) {
  const Eigen::Quaterniond q_VT =
      Eigen::AngleAxisd(scenario.trunk_heading, Eigen::Vector3d::UnitZ()) *
      Eigen::AngleAxisd(std::numbers::pi / 2, Eigen::Vector3d::UnitX());
  const std::vector<double> time = trial.observations.recordings.front().time;
  trial.observations.recordings.push_back(Recorded(
      [&](double) {
        return SensorOn({{.q_AB = q_VT}, {}}, {});
      },
      time));
  Recording& recording = trial.observations.recordings.back();
  recording.segment = Segment::kThorax;
  recording.mounting = Mounting{};
  trial.observations.arm.segments[Segment::kThorax].p_distal_B = {0.0, 0.1, 0.2};
  trial.reference->q_VB[Segment::kThorax].assign(time.size(), q_VT);
}

}  // namespace brachium
