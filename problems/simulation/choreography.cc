#include "problems/simulation/choreography.h"

#include <algorithm>
#include <cmath>
#include <string_view>

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

std::vector<Movement> Daily(double length, Draws& draws) {
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
    if (t + movement.duration + kHomeward > length) break;
    t += movement.duration + (pause ? wait : wait * movement.duration);
    pose = movement.target;
    movements.push_back(movement);
  }
  const double end = movements.back().start + movements.back().duration;
  movements.push_back({.start = end, .duration = kHomeward, .target = StartPoseJoints()});
  return movements;
}

std::vector<Movement> Reach(double length, Draws& draws) {
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
    if (t > length) return movements;
    movements.insert(movements.end(), cycle.begin(), cycle.end());
  }
}

std::vector<Movement> Shrug(double length, Draws& draws) {
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
    if (cycle.back().start + cycle.back().duration > length) return movements;
    movements.insert(movements.end(), cycle.begin(), cycle.end());
  }
}

constexpr double kCalibrationRest = 0.6;  // between movements [s]

// One after the other, with rests between.
class Sequence {
 public:
  explicit Sequence(Draws& draws) : draws_(draws) {}

  void Go(const JointValues& target, const std::string& label = "") {
    const double duration = draws_.Uniform(0.9, 1.0);
    movements_.push_back({time_, duration, target, label});
    time_ += duration + kCalibrationRest;
  }
  void Repeat(const JointValues& from, const JointValues& to, const std::string& out,
              const std::string& back) {
    Go(from);
    for (int repetition = 0; repetition < 5; ++repetition) {
      Go(to, out);
      Go(from, back);
    }
  }
  const std::vector<Movement>& movements() const { return movements_; }

 private:
  Draws& draws_;
  double time_ = 0.0;
  std::vector<Movement> movements_;
};

std::vector<Movement> Calibration(double, Draws& draws) {
  JointValues bent = StartPoseJoints();
  bent[kShoulderAbduction] = 0.0;
  bent[kElbowFlexion] = 90 * kDegree;
  JointValues palm_down = bent, palm_up = bent, raised = bent, abducted = bent;
  palm_down[kForearmPronation] = 180 * kDegree;
  palm_up[kForearmPronation] = 20 * kDegree;
  raised[kShoulderFlexion] = 45 * kDegree;
  raised[kShoulderRotation] = -30 * kDegree;
  JointValues rotated = raised;
  rotated[kShoulderRotation] = 50 * kDegree;
  abducted[kShoulderAbduction] = 70 * kDegree;
  Sequence sequence(draws);
  sequence.Repeat(palm_down, palm_up, "calibration:forearm_supination",
                  "calibration:forearm_pronation");
  sequence.Repeat(raised, rotated, "calibration:upper_arm_endorotation",
                  "calibration:upper_arm_exorotation");
  sequence.Repeat(bent, abducted, "calibration:upper_arm_abduction", "");
  sequence.Go(StartPoseJoints());
  return sequence.movements();
}

struct Choreography {
  std::string_view name;
  std::vector<Movement> (*compose)(double length, Draws& draws);
  double time_scale = 1.0;
  double shoulder_share = 1.0;   // of the options' shoulder rms
  double adduction_share = 1.0;  // of the options' adduction rms
  double shortest = 10.0;        // time that it needs, before the time scale [s]
};

constexpr std::array kChoreographies = {
    Choreography{.name = "daily_brisk", .compose = Daily},
    Choreography{.name = "daily_slow", .compose = Daily, .time_scale = 4.0},
    Choreography{.name = "reach", .compose = Reach, .shoulder_share = 0.5},
    Choreography{.name = "shrug", .compose = Shrug, .shoulder_share = 0.1},
    Choreography{.name = "calibration",
                 .compose = Calibration,
                 .shoulder_share = 0.2,
                 .adduction_share = 0.2,
                 .shortest = 55.0}};

const Choreography& Find(const std::string& name) {
  return *std::find_if(kChoreographies.begin(), kChoreographies.end(),
                       [&name](const Choreography& c) { return c.name == name; });
}

// One value per movement, after a first for the start: an AR(1) sequence, shifted and scaled to
// mean zero and the given rms.
std::vector<double> Wander(std::size_t movements, double rms, double correlation, Draws& draws) {
  std::vector<double> x(movements + 1);
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] = i == 0
               ? draws.Normal()
               : correlation * x[i - 1] + std::sqrt(1 - correlation * correlation) * draws.Normal();
  double mean = 0.0, power = 0.0;
  for (const double value : x) mean += value / static_cast<double>(x.size());
  for (const double value : x)
    power += (value - mean) * (value - mean) / static_cast<double>(x.size());
  for (double& value : x) value = rms * (value - mean) / std::sqrt(power);
  return x;
}

// Adds a wandering of one joint to the movements and to the pose they start from.
void AddWander(Joint joint, const std::vector<double>& wander, JointValues& start,
               std::vector<Movement>& movements) {
  start[joint] += wander[0];
  for (std::size_t i = 0; i < movements.size(); ++i) movements[i].target[joint] += wander[i + 1];
}

// Steps of one joint; it uses a part of each movement's time, from up to 20 % after its start to up
// to 10 % before its end.
Motion JointMotion(Joint joint, const JointValues& start, const std::vector<Movement>& movements,
                   double time_scale, Draws draws) {
  Motion motion(start[joint]);
  double from = start[joint];
  for (const Movement& m : movements) {
    const double late = draws.Uniform(0.0, 0.2), early = draws.Uniform(0.0, 0.1);
    motion.AddStep(kRestAtStart + time_scale * (m.start + late * m.duration),
                   time_scale * (1.0 - late - early) * m.duration, m.target[joint] - from);
    from = m.target[joint];
  }
  return motion;
}

// What the scenario's movements are, in its own time.
std::vector<Movement> Composed(const ScenarioOptions& options) {
  const double length = (options.duration - kRestAtStart - kRestAtEnd) / TimeScale(options);
  Draws path(options.seed, "path");
  return Find(options.name).compose(length, path);
}

}  // namespace

double TimeScale(const ScenarioOptions& options) {
  return options.time_scale * Find(options.name).time_scale;
}

double ShortestPerformance(const ScenarioOptions& options) { return Find(options.name).shortest; }

std::vector<std::string> ScenarioNames() {
  std::vector<std::string> names;
  for (const Choreography& c : kChoreographies) names.emplace_back(c.name);
  return names;
}

JointValues StartPoseJoints() {
  JointValues pose{};
  pose[kShoulderAbduction] = 8 * kDegree;
  pose[kElbowFlexion] = 10 * kDegree;
  pose[kForearmPronation] = 90 * kDegree;
  return pose;
}

std::array<Motion, kJointCount> Perform(const ScenarioOptions& options) {
  const Choreography& choreography = Find(options.name);
  const double time_scale = TimeScale(options);
  Draws wander(options.seed, "wander");
  std::vector<Movement> movements = Composed(options);
  JointValues start = StartPoseJoints();

  const double shoulder_rms = choreography.shoulder_share * options.shoulder_rms;
  const double adduction_rms = choreography.adduction_share * options.adduction_rms;
  AddWander(kElbowAdduction, Wander(movements.size(), adduction_rms, 0.5, wander), start,
            movements);
  for (const Joint joint : {kShoulderForward, kShoulderUp, kShoulderRight})
    AddWander(joint, Wander(movements.size(), shoulder_rms, 0.8, wander), start, movements);

  std::array<Motion, kJointCount> joints;
  for (int i = 0; i < kJointCount; ++i)
    joints[static_cast<std::size_t>(i)] =
        JointMotion(static_cast<Joint>(i), start, movements, time_scale,
                    Draws(options.seed, "onset" + std::to_string(i)));
  return joints;
}

std::vector<Interval> LabelledIntervals(const ScenarioOptions& options) {
  const double scale = TimeScale(options), margin = 0.5 * kCalibrationRest;
  std::vector<Interval> intervals;
  for (const Movement& m : Composed(options))
    if (!m.label.empty())
      intervals.push_back({m.label, kRestAtStart + scale * (m.start - margin),
                           kRestAtStart + scale * (m.start + m.duration + margin)});
  if (!intervals.empty())
    intervals.insert(intervals.begin(), {"calibration:static_pose", 0.2, kRestAtStart - 0.2});
  return intervals;
}

}  // namespace brachium
