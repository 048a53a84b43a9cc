#include "problems/simulation/choreography.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "problems/simulation/patient.h"
#include "problems/simulation/wander.h"

namespace brachium {
namespace {

using Eigen::Vector3d;

// When a part of a movement begins, in the trial's time.
class Clock {
 public:
  Clock(double time_scale, StepShape shape) : scale_(time_scale), shape_(shape) {}

  double Time(double own) const { return Rounded(kRestAtStart + scale_ * own); }
  double Span(double own) const { return std::max(Rounded(scale_ * own), 1e-3); }

 private:
  // A minimum-jerk step begins and ends with a kink of its acceleration. On whole milliseconds no
  // integration in such steps meets one inside a step.
  double Rounded(double t) const {
    return shape_ == StepShape::kSmooth ? t : std::round(1e3 * t) * 1e-3;
  }

  double scale_;
  StepShape shape_;
};

// A change of one joint in several strokes, each after the other.
void AddStrokes(const Clock& clock, double start, double duration, double change, int strokes,
                StepShape shape, Motion& motion) {
  const double part = 1.0 / strokes;
  for (int i = 0; i < strokes; ++i)
    motion.AddStep(clock.Time(start + i * part * duration), clock.Span(part * duration),
                   part * change, shape);
}

// Steps of one joint. Where joints move apart, each uses a part of each movement's time, from up to
// 20 % after its start to up to 10 % before its end.
Motion JointMotion(Joint joint, const ScenarioKind& kind, const Clock& clock,
                   const JointValues& start, const std::vector<Movement>& movements, Draws draws) {
  Motion motion(start[joint]);
  double from = start[joint];
  for (const Movement& m : movements) {
    double late = 0.0, early = 0.0;
    if (kind.joints_apart) {
      late = draws.Uniform(0.0, 0.2);
      early = draws.Uniform(0.0, 0.1);
    }
    AddStrokes(clock, m.start + late * m.duration, (1.0 - late - early) * m.duration,
               m.target[joint] - from, m.strokes, kind.shape, motion);
    from = m.target[joint];
  }
  return motion;
}

// Wrist and elbow of a pose.
struct Held {
  Vector3d wrist_T, elbow_T;
};

Held HeldAt(const JointValues& joints, const std::optional<HandPlace>& hand,
            const ArmShape& shape) {
  if (hand) return {hand->p_T, hand->elbow_T};
  const ArmMotion arm = ArmOf(joints, shape);
  return {arm.wrist_W.p, (arm.forearm.joint_W.p - arm.upper_arm.joint_W.p) / shape.upper_arm};
}

Motion Phase(const Choreography& composed, const Clock& clock) {
  Motion phase;
  for (int half = 0; half < 2 * composed.laps; ++half)
    phase.AddStep(clock.Time(composed.circle_start + 0.5 * half * composed.lap),
                  clock.Span(composed.lap), std::numbers::pi, StepShape::kMinimumJerk);
  return phase;
}

// Straight lines between the places, at the times of the movements.
HandPath PathOf(const Choreography& composed, const Clock& clock, const ArmShape& shape) {
  HandPath path;
  Held at = HeldAt(composed.start, std::nullopt, shape);
  for (int i = 0; i < 3; ++i) {
    path.wrist_T[static_cast<std::size_t>(i)] = Motion(at.wrist_T[i]);
    path.elbow_T[static_cast<std::size_t>(i)] = Motion(at.elbow_T[i]);
  }
  for (const Movement& m : composed.movements) {
    const Held next = HeldAt(m.target, m.hand, shape);
    const double start = clock.Time(m.start), duration = clock.Span(m.duration);
    for (int i = 0; i < 3; ++i) {
      const auto axis = static_cast<std::size_t>(i);
      path.wrist_T[axis].AddStep(start, duration, next.wrist_T[i] - at.wrist_T[i],
                                 StepShape::kMinimumJerk);
      path.elbow_T[axis].AddStep(start, duration, next.elbow_T[i] - at.elbow_T[i],
                                 StepShape::kMinimumJerk);
    }
    at = next;
  }
  path.radius = composed.circle_radius;
  path.phase = Phase(composed, clock);
  return path;
}

// Three sinusoids between 4 and 6 Hz for each joint that trembles.
void AddTremor(Scenario& scenario) {
  constexpr double kOnset = 1.0;  // [s]
  const ScenarioOptions& options = scenario.options;
  const double rms = options.tremor + PatientTremor(options.patient_week);
  Draws draws(options.seed, "tremor");
  if (rms == 0.0) return;
  for (const Joint joint : {kElbowFlexion, kForearmPronation, kWristFlexion})
    for (int i = 0; i < 3; ++i) {
      const double frequency = draws.Uniform(4.0, 6.0);
      scenario.tremor[joint].AddSinusoid(rms * std::sqrt(2.0 / 3.0), frequency,
                                         draws.Uniform(0.0, 2.0 * std::numbers::pi));
    }
  scenario.tremor_envelope.AddStep(kRestAtStart, kOnset, 1.0);
  scenario.tremor_envelope.AddStep(options.duration - kRestAtEnd - kOnset, kOnset, -1.0);
}

void AddIntervals(const Choreography& composed, double time_scale, Scenario& scenario) {
  bool calibrates = false;
  for (const auto& [label, start, end] : composed.intervals) {
    scenario.intervals.push_back(
        {label, kRestAtStart + time_scale * start, kRestAtStart + time_scale * end});
    calibrates = calibrates || (label.starts_with("calibration:") && !composed.movements.empty());
  }
  if (calibrates)
    scenario.intervals.insert(scenario.intervals.begin(),
                              {"calibration:static_pose", 0.2, kRestAtStart - 0.2});
}

void AddContacts(const Choreography& composed, double time_scale, Scenario& scenario) {
  scenario.contacts = composed.contacts;
  for (Contact& contact : scenario.contacts)
    for (double& time : contact.times) time = kRestAtStart + time_scale * time;
}

void AddFacts(const Choreography& composed, const Clock& clock, Scenario& scenario) {
  TrueValue start{"movements.start_s", {}}, end{"movements.end_s", {}};
  for (const Movement& m : composed.movements) {
    start.value.push_back(clock.Time(m.start));
    end.value.push_back(clock.Time(m.start) + clock.Span(m.duration));
  }
  if (!composed.movements.empty()) scenario.facts = {start, end};
  const Eigen::Quaterniond q_WT = Eigen::AngleAxisd(scenario.trunk_heading, Vector3d::UnitZ()) *
                                  Eigen::AngleAxisd(std::numbers::pi / 2, Vector3d::UnitX());
  const double s = Sign(scenario.options.side);
  for (const auto& [name, place_T] : composed.places) {
    const Vector3d p_W = q_WT * place_T;
    scenario.facts.push_back({name, {p_W.x(), s * p_W.y(), p_W.z()}});
  }
  if (composed.circle_radius > 0.0)
    scenario.facts.push_back({"circle.radius_m", {composed.circle_radius}});
}

// Rms per axis of where the composed movements themselves take the shoulder [m].
double ComposedShoulderRms(const ArmShape& shape, const std::vector<Movement>& movements) {
  double squares = 0.0;
  for (const Movement& movement : movements)
    squares += ArmOf(movement.target, shape).upper_arm.joint_W.p.squaredNorm();
  return std::sqrt(squares / (3.0 * static_cast<double>(movements.size())));
}

// Whatever adduction and shoulder do, the hand is where it was to be.
void BringHands(const ArmShape& shape, std::vector<Movement>& movements) {
  for (Movement& movement : movements)
    if (movement.hand) BringHandTo(*movement.hand, shape, movement.target);
}

}  // namespace

void Perform(const ScenarioKind& kind, Scenario& scenario) {
  const ScenarioOptions& options = scenario.options;
  const double time_scale = TimeScale(options);
  const Clock clock(time_scale, kind.shape);
  const double length = (options.duration - kRestAtStart - kRestAtEnd) / time_scale;
  Draws path(options.seed, "path");
  Choreography composed =
      kind.compose({.length = length, .patient_week = options.patient_week}, path);
  std::vector<Movement>& movements = composed.movements;
  AddIntervals(composed, time_scale, scenario);
  AddContacts(composed, time_scale, scenario);
  AddFacts(composed, clock, scenario);

  scenario.start = composed.start;
  const double shoulder_rms = kind.rig ? 0.0 : kind.shoulder_share * options.shoulder_rms;
  const double adduction_rms = kind.rig ? 0.0 : kind.adduction_share * options.adduction_rms;
  if (!movements.empty())
    scenario.shoulder =
        ShoulderProcess(std::hypot(shoulder_rms, ComposedShoulderRms(scenario.shape, movements)),
                        time_scale * length / static_cast<double>(movements.size()));
  AddExecutionErrors(options, movements);
  AddWander(options, adduction_rms, shoulder_rms, composed.start, movements);
  BringHands(scenario.shape, movements);

  for (std::size_t i = 0; i < scenario.joints.size(); ++i)
    scenario.joints[i] = JointMotion(static_cast<Joint>(i), kind, clock, composed.start, movements,
                                     Draws(options.seed, "onset" + std::to_string(i)));
  if (kind.along_paths) scenario.hand_path = PathOf(composed, clock, scenario.shape);
  AddTremor(scenario);
}

}  // namespace brachium
