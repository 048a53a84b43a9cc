// Everyday and single-joint movements.
#include <algorithm>
#include <cmath>

#include "problems/simulation/families.h"

namespace brachium {
namespace {

constexpr double kHomeward = 1.2;  // the last movement, back to the start pose [s]

struct Range {
  double low, high;
};

// Everyday ranges of the joints, from shoulder flexion to pronation [rad].
constexpr std::array<Range, 5> kDailyRange = {{{-15 * kDegree, 90 * kDegree},
                                               {0 * kDegree, 60 * kDegree},
                                               {-30 * kDegree, 60 * kDegree},
                                               {15 * kDegree, 130 * kDegree},
                                               {20 * kDegree, 150 * kDegree}}};

// Longer movements take longer: 0.5 s and up to 1.2 s across a whole range, 10 % more or less.
double DailyDuration(const JointValues& from, const JointValues& to, Draws& draws) {
  double share = 0.0;
  for (std::size_t i = 0; i < kDailyRange.size(); ++i)
    share = std::max(share, std::abs(to[i] - from[i]) / (kDailyRange[i].high - kDailyRange[i].low));
  return std::clamp((0.5 + 0.7 * share) * draws.Uniform(0.9, 1.1), 0.5, 1.2);
}

}  // namespace

Choreography Daily(const Task& task, Draws& draws) {
  std::vector<Movement> movements;
  JointValues pose = StartPoseJoints();
  double t = 0.0;
  while (true) {
    Movement movement{.start = t, .target = pose};
    for (std::size_t i = 0; i < kDailyRange.size(); ++i)
      movement.target[i] = draws.Uniform(kDailyRange[i].low, kDailyRange[i].high);
    movement.duration = DailyDuration(pose, movement.target, draws);
    const bool pause = draws.Uniform(0.0, 1.0) < 0.2;
    const double wait = pause ? draws.Uniform(0.3, 2.0) : draws.Uniform(-0.25, 0.0);
    if (t + movement.duration + kHomeward > task.length) break;
    t += movement.duration + (pause ? wait : wait * movement.duration);
    pose = movement.target;
    movements.push_back(movement);
  }
  const double end = movements.back().start + movements.back().duration;
  movements.push_back({.start = end, .duration = kHomeward, .target = StartPoseJoints()});
  return {.movements = movements};
}

Choreography Reach(const Task& task, Draws& draws) {
  std::vector<Movement> movements;
  const JointValues home = StartPoseJoints();
  JointValues flexed = home;
  flexed[kElbowFlexion] = 100 * kDegree;
  double t = 0.0;
  while (true) {
    JointValues reached = home;
    reached[kShoulderFlexion] = draws.Uniform(50 * kDegree, 80 * kDegree);
    reached[kShoulderAbduction] = draws.Uniform(0.0, 20 * kDegree);
    reached[kElbowFlexion] = draws.Uniform(20 * kDegree, 40 * kDegree);
    reached[kForearmPronation] = draws.Uniform(60 * kDegree, 120 * kDegree);
    std::vector<Movement> cycle;
    for (const JointValues& target : {flexed, reached, flexed, home}) {
      cycle.push_back({.start = t, .duration = draws.Uniform(0.6, 1.0), .target = target});
      t += cycle.back().duration + draws.Uniform(0.1, 0.5);
    }
    if (t > task.length) return {.movements = movements};
    movements.insert(movements.end(), cycle.begin(), cycle.end());
  }
}

Choreography Shrug(const Task& task, Draws& draws) {
  std::vector<Movement> movements;
  const JointValues home = StartPoseJoints();
  JointValues raised = home;
  raised[kShoulderUp] = 0.08;
  double t = 0.0;
  while (true) {
    std::vector<Movement> cycle;
    for (const JointValues& target : {raised, home}) {
      cycle.push_back({.start = t, .duration = draws.Uniform(0.5, 1.0), .target = target});
      t += cycle.back().duration + draws.Uniform(0.2, 4.0);
    }
    if (cycle.back().start + cycle.back().duration > task.length) return {.movements = movements};
    movements.insert(movements.end(), cycle.begin(), cycle.end());
  }
}

// Zhou et al. 2008, third test: the forearm turns, the elbow bent; read as pronation and
// supination, which the paper's figure of an angle about a sensor axis does not settle.
Choreography ForearmRotation(const Task& task, Draws& draws) {
  JointValues bent = StartPoseJoints(), pronated, supinated;
  bent[kElbowFlexion] = 90 * kDegree;
  pronated = supinated = bent;
  pronated[kForearmPronation] = 150 * kDegree;
  supinated[kForearmPronation] = 30 * kDegree;
  Score score;
  score.Go(bent, 1.0, 0.3);
  constexpr double kLongestCycle = 2 * (1.0 + 0.3);
  while (score.time() + kLongestCycle + 0.3 + kHomeward <= task.length) {
    const double start = score.time();
    for (const JointValues& target : {pronated, supinated})
      score.Go(target, draws.Uniform(0.7, 1.0), draws.Uniform(0.1, 0.3));
    score.Label("cycle:forearm_rotation", start, score.time());
  }
  score.Go(StartPoseJoints(), kHomeward, 0.0);
  return score.choreography();
}

}  // namespace brachium
