// An arm that flexes and extends its elbow to and fro and does nothing else: the upper arm is still,
// so that the vertical part n_z of n = z_U × y_F is what one chooses.
#pragma once

#include <numbers>

#include "problems/joint_angles.h"
#include "problems/trial.h"
#include "tests/support/moving_sensor.h"
#include "tests/support/smooth_motion.h"

namespace brachium {

struct HingedArmOptions {
  // Hanging, flexion axis horizontal, to the right: n_z is large. Identity: the flexion axis is
  // vertical and n_z is zero.
  Eigen::Quaterniond q_WU{Eigen::AngleAxisd(std::numbers::pi / 2, Eigen::Vector3d::UnitX())};
  Side side = Side::kRight;
  double carrying_angle = 0.0;         // true and told [rad]
  double forearm_heading_drift = 0.0;  // a bias about the vertical [rad/s]
  double duration = 30.0;              // [s]
};

inline const Eigen::Quaterniond kFlexionAxisVertical = Eigen::Quaterniond::Identity();

inline BodyMotion HingedForearm(const HingedArmOptions& options, double t) {
  using Eigen::Vector3d;
  const double s = Sign(options.side);
  Moving flexion = Sine(0.35, 3.0, 0.0, t);
  flexion.value += std::numbers::pi / 2;
  return {.turning = TurningFrame{.q_AB = options.q_WU} * About(Vector3d::UnitZ(), flexion) *
                     About(Vector3d::UnitX(), {.value = -s * options.carrying_angle}),
          .joint_W = {}};
}

inline Trial HingedArm(const HingedArmOptions& options) {
  Trial trial;
  Observations& observations = trial.observations;
  observations.arm.side = options.side;
  observations.arm.elbow.carrying_angle = options.carrying_angle;
  observations.start_pose = HeldPose{.time = 0.0,
                                     .elbow_flexion = std::numbers::pi / 2,
                                     .forearm_pronation = 0.0,
                                     .shoulder_elevation = {}};
  const auto times = EvenTimes(0.005, 0.01, static_cast<std::size_t>(options.duration * 100));
  const BodyMotion upper{.turning = {.q_AB = options.q_WU}, .joint_W = {}};
  trial.reference = Reference{};
  trial.reference->time = times;
  for (const Segment segment : {Segment::kUpperArm, Segment::kForearm}) {
    const bool fore = segment == Segment::kForearm;
    const auto body = [&](double t) { return fore ? HingedForearm(options, t) : upper; };
    observations.arm.segments[segment].p_distal_B = {0.0, -0.3, 0.0};
    observations.recordings.push_back(
        Recorded([&](double t) { return SensorOn(body(t), {}); }, times));
    Recording& recording = observations.recordings.back();
    recording.segment = segment;
    recording.mounting = Mounting{};
    for (std::size_t i = 0; i < times.size(); ++i) {
      const Eigen::Quaterniond q_VB = body(times[i]).turning.q_AB;
      trial.reference->q_VB[segment].push_back(q_VB);
      if (fore)
        recording.gyr_S[i] +=
            q_VB.conjugate() * Eigen::Vector3d(0, 0, options.forearm_heading_drift);
    }
  }
  return trial;
}

}  // namespace brachium
