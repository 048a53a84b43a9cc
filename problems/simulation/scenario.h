// Arm movements whose every pose, rate and acceleration is known exactly at any time: an arm
// (arm_chain.h) whose angles and places are smooth functions of time (motion.h), so that no pose is
// singular. A left arm is the mirror image of the right arm of the same options, its world mirrored
// about the x-z plane.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "problems/observations.h"
#include "problems/simulation/arm_chain.h"

namespace brachium {

// A number, or a few, that an estimator may be asked for. The name says the unit (SI without).
struct TrueValue {
  std::string name;
  std::vector<double> value;
};

struct ScenarioOptions {
  std::string name = "daily_brisk";  // one of ScenarioNames()
  std::uint64_t seed = 1;            // of the movements, the trunk's heading and the adduction
  Side side = Side::kRight;
  double duration = 60.0;   // of the whole trial, rests included [s]
  double time_scale = 1.0;  // 4: the same path four times slower; the rests at both ends stay
  int patient_week = 0;     // 0: healthy; 1 to 10: a patient in that week (patient.h)

  double carrying_angle = 8 * kDegree;  // k0, valgus positive: the mean where it is drawn [rad]
  double carrying_angle_sd = 0.0;       // of k0, drawn once [rad]
  double carrying_slope = 3 * kDegree;  // k1: more valgus when straight; the mean too [rad]
  double carrying_slope_sd = 0.0;       // of k1, drawn once [rad]
  double adduction_rms = 3 * kDegree;   // of e(t), new at every movement [rad]
  double shoulder_rms = 0.03;           // of the shoulder's wandering, per axis [m]
  bool exact_rms = true;                // false: both rms are the sds of what is drawn, about zero
  double execution_error = 0.0;         // sd of each angle at the end of each movement [rad]
  double tremor = 0.0;  // rms of elbow flexion, pronation, wrist flexion, at 4-6 Hz [rad]

  bool IsValid(std::string* why) const;
};

// Each begins with kRestAtStart in its start pose and ends at rest in it, for kRestAtEnd or longer.
std::vector<std::string> ScenarioNames();

// What a scenario is, in one line.
std::string_view ScenarioHelp(const std::string& name);

// How long the whole trial takes [s]: 60 s where a scenario goes on for as long as it is asked to.
// Reads name, time scale and week; 60 s for a week that there is not.
double UsualDuration(const ScenarioOptions& options);

inline constexpr double kRestAtStart = 3.0;  // [s]
inline constexpr double kRestAtEnd = 2.0;    // [s]

// The wrist is led along a path in space and shoulder and elbow follow: places in the upright
// trunk's axes from the shoulder's mean place [m].
struct HandPath {
  std::array<Motion, 3> wrist_T;  // where it is, but for the circle
  std::array<Motion, 3> elbow_T;  // direction in which the elbow is kept
  double radius = 0.0;  // of a circle in the horizontal plane, from its foremost point [m]
  Motion phase;         // of the circle, counterclockwise from above [rad]

  MovingPoint WristAt(double t) const;
};

struct Scenario {
  ScenarioOptions options;
  ArmShape shape;                          // of the right arm
  JointValues start{};                     // of both rests, but for adduction and shoulder
  std::array<Motion, kJointCount> joints;  // of the right arm
  std::optional<HandPath> hand_path;       // rules shoulder and elbow flexion where present
  std::array<Motion, kJointCount> tremor;  // beside it, between the rests
  Motion tremor_envelope;
  double trunk_heading = 0.0;       // of the right arm's world [rad]
  std::vector<Segment> worn;        // the segments that usually wear a sensor
  bool rig = false;                 // a hinge: no carrying angle, no shoulder that moves
  ShoulderModel shoulder;           // how it moves, as a process
  std::vector<Interval> intervals;  // labelled movements
  std::vector<Contact> contacts;    // where a point of the arm is again and again
  std::vector<TrueValue> facts;     // of the movement: when, and where to

  MovingJoints JointsAt(double t) const;  // of the right arm, exact at any time t [s]
  ArmMotion At(double t) const;           // exact at any time t [s]
};

// Requires options.IsValid().
Scenario MakeScenario(const ScenarioOptions& options);

}  // namespace brachium
