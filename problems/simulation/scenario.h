// Arm movements whose every pose, rate and acceleration is known exactly at any time.
//
// The arm hangs from the shoulder, which moves in a trunk that stands still:
//   R_TU = Rz(shoulder flexion) Rx(-s abduction) Ry(s internal rotation),
//   R_UF = Rz(elbow flexion) Rx(-s k) Ry(s pronation),    k = k0 + k1 cos(elbow flexion) + e(t),
// with every angle a smooth function of time (motion.h), so no pose is singular. A left arm (s =
// -1) is the mirror image of the right arm of the same options, its world mirrored about the x-z
// plane.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "problems/arm_model.h"
#include "problems/observations.h"
#include "problems/simulation/rigid_motion.h"

namespace brachium {

struct ScenarioOptions {
  std::string name = "daily_brisk";  // one of ScenarioNames()
  std::uint64_t seed = 1;            // of the movements, the trunk's heading and the adduction
  Side side = Side::kRight;
  double duration = 60.0;   // of the whole trial, rests included [s]
  double time_scale = 1.0;  // 4: the same path four times slower; the rests at both ends stay

  double carrying_angle = 8 * kDegree;  // k0, valgus positive [rad]
  double carrying_slope = 3 * kDegree;  // k1: more valgus when straight [rad]
  double adduction_rms = 3 * kDegree;   // of e(t), new at every movement [rad]
  double shoulder_rms = 0.03;           // of the shoulder's wandering, per axis [m]

  bool IsValid(std::string* why) const;
};

// "daily_brisk": whole-arm reaches to random poses within everyday joint ranges, 0.5-1.2 s each,
//     running into one another, with a pause after every fifth on average.
// "daily_slow": the same path four times slower.
// "reach": the elbow flexes to 100 deg, the arm reaches forward, and both come back; repeatedly.
// "shrug": the shoulder rises 8 cm and comes back, the arm hanging; pauses of 0.2-4 s.
// "calibration": five times each, still in between, the movements by which sensors are calibrated
//     (calibrate.h): supination and pronation with the elbow at 90 deg, from palm down to palm nearly
//     up and back; endo- and exorotation of a raised upper arm; abduction of a hanging one, elbow at
//     90 deg. Each is a labelled interval that has a rest at both ends; the rest at the start is a
//     static pose. The elbow's adduction and the shoulder wander a fifth as far as elsewhere.
// Each begins with kRestAtStart in the start pose and ends at rest in it, for kRestAtEnd or longer.
std::vector<std::string> ScenarioNames();

inline constexpr double kRestAtStart = 3.0;  // [s]
inline constexpr double kRestAtEnd = 2.0;    // [s]

// The joints that a scenario moves; angles [rad], shoulder position in trunk axes [m].
enum Joint {
  kShoulderFlexion,
  kShoulderAbduction,
  kShoulderRotation,
  kElbowFlexion,
  kForearmPronation,
  kElbowAdduction,  // e(t)
  kShoulderForward,
  kShoulderUp,
  kShoulderRight,
  kJointCount
};
using JointValues = std::array<double, kJointCount>;

// Arm hanging, elbow 10 deg flexed, thumb forward.
JointValues StartPoseJoints();

// Where the arm is at one instant. World: z up; see BodyMotion.
struct ArmMotion {
  BodyMotion upper_arm, forearm;
  MovingPoint wrist_W;

  const BodyMotion& operator[](Segment segment) const {
    return segment == Segment::kForearm ? forearm : upper_arm;
  }
};

struct Scenario {
  ScenarioOptions options;
  std::array<Motion, kJointCount> joints;  // of the right arm
  double trunk_heading = 0.0;              // of the right arm's world [rad]
  std::map<Segment, double> length;        // true lengths [m]
  std::vector<Interval> intervals;         // labelled movements

  ArmMotion At(double t) const;  // t in s, exact at any time
};

// Requires options.IsValid().
Scenario MakeScenario(const ScenarioOptions& options);

}  // namespace brachium
