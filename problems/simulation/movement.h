// What a scenario is composed of: movements one after another.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "problems/observations.h"
#include "problems/simulation/draws.h"
#include "problems/simulation/inverse_kinematics.h"

namespace brachium {

// All joints go to `target`, between `start` and `start + duration`. Time in s from the end of the
// rest at the start, before the options' time scale.
struct Movement {
  double start = 0.0;
  double duration = 0.0;
  JointValues target{};
  std::optional<HandPlace> hand{};  // rules shoulder and elbow flexion of the target
  int strokes = 1;                  // performed in so many strokes
};

struct Choreography {
  JointValues start = StartPoseJoints();
  std::vector<Movement> movements{};
  std::vector<Interval> intervals{};                              // in the movements' time
  std::vector<Contact> contacts{};                                // in the movements' time
  double circle_radius = 0.0;                                     // the hand circles so wide [m],
  double circle_start = 0.0;                                      // from then on [s],
  double lap = 0.0;                                               // each lap in that time [s],
  int laps = 0;                                                   // so many times
  std::vector<std::pair<std::string, Eigen::Vector3d>> places{};  // in the upright trunk's axes [m]
};

// What a composition depends on.
struct Task {
  double length = 0.0;   // time to fill, in the movements' time [s]
  int patient_week = 0;  // see patient.h
};

// Writes movements one after the other.
class Score {
 public:
  explicit Score(const JointValues& start = StartPoseJoints()) { choreography_.start = start; }

  // Goes to `target` within `duration`, then waits for `pause`; a negative pause lets the next
  // movement begin before the end of this one.
  Movement& Go(const JointValues& target, double duration, double pause);
  Movement& Go(const JointValues& posture, const HandPlace& hand, double duration, double pause);

  // Labels what there is between two instants.
  void Label(const std::string& label, double start, double end);

  void WaitUntil(double time) { time_ = time; }
  double time() const { return time_; }
  Choreography& choreography() { return choreography_; }

 private:
  Choreography choreography_;
  double time_ = 0.0;
};

}  // namespace brachium
