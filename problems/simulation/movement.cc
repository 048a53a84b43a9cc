#include "problems/simulation/movement.h"

namespace brachium {

Movement& Score::Go(const JointValues& target, double duration, double pause) {
  choreography_.movements.push_back({.start = time_, .duration = duration, .target = target});
  time_ += duration + pause;
  return choreography_.movements.back();
}

Movement& Score::Go(const JointValues& posture, const HandPlace& hand, double duration,
                    double pause) {
  Movement& movement = Go(posture, duration, pause);
  movement.hand = hand;
  return movement;
}

void Score::Label(const std::string& label, double start, double end) {
  choreography_.intervals.push_back({label, start, end});
}

}  // namespace brachium
