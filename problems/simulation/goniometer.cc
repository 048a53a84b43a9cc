// A goniometer with a sensor on each arm, as the first test of a sensor system: one arm lies
// forward, the other turns upward about the hinge.
//
// Source: Bai et al. 2015, section II.F: 0 to 80 deg in steps of 10 deg; 90 deg in the vertical
// plane, the moving arm 10 cm long. The time at each step is ours.
#include "problems/simulation/families.h"

namespace brachium {
namespace {

constexpr double kHold = 3.0;  // [s]

JointValues Flat() {
  JointValues pose{};
  pose[kShoulderFlexion] = 90 * kDegree;
  return pose;
}

JointValues Opened(double angle_deg) {
  JointValues pose = Flat();
  pose[kElbowFlexion] = angle_deg * kDegree;
  return pose;
}

}  // namespace

Choreography GoniometerSteps(const Task&, Draws&) {
  Score score(Flat());
  for (int step = 1; step <= 8; ++step) {
    score.Go(Opened(10.0 * step), 0.6, kHold);
    score.Label("task:" + std::to_string(10 * step) + "_deg", score.time() - kHold, score.time());
  }
  score.Go(Flat(), 2.0, 0.0);
  return score.choreography();
}

Choreography GoniometerSwing(const Task&, Draws&) {
  Score score(Flat());
  for (int repetition = 0; repetition < 3; ++repetition) {
    const double start = score.time();
    score.Go(Opened(90.0), 1.5, kHold);
    score.Go(Flat(), 1.5, kHold);
    score.Label("cycle:swing", start, score.time());
  }
  return score.choreography();
}

}  // namespace brachium
