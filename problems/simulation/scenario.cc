#include "problems/simulation/scenario.h"

#include <cmath>
#include <numbers>

#include "problems/simulation/choreography.h"
#include "problems/simulation/mirror.h"

namespace brachium {
namespace {

using Eigen::Vector3d;

// Trunk axes (X forward, Y up, Z right) in the world, facing `heading` from the world's x.
TurningFrame Trunk(double heading) {
  return About(Vector3d::UnitZ(), {heading, 0.0, 0.0}) *
         About(Vector3d::UnitX(), {std::numbers::pi / 2, 0.0, 0.0});
}

// The point (0, -length, 0): a segment's distal joint.
MovingPoint Distal(double length) { return {.p = {0.0, -length, 0.0}}; }

ArmMotion RightArmAt(const Scenario& scenario, double t) {
  std::array<Moving, kJointCount> q;
  for (std::size_t i = 0; i < q.size(); ++i) q[i] = scenario.joints[i].At(t);
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
  const ScenarioOptions& options = scenario.options;

  const BodyMotion trunk{.turning = Trunk(scenario.trunk_heading), .joint_W = {}};
  ArmMotion arm;
  arm.upper_arm.turning = trunk.turning * About(z, q[kShoulderFlexion]) *
                          About(x, -q[kShoulderAbduction]) * About(y, q[kShoulderRotation]);
  arm.upper_arm.joint_W =
      PointOn(trunk, PointOf(q[kShoulderForward], q[kShoulderUp], q[kShoulderRight]));
  const Moving carrying = Moving{options.carrying_angle, 0.0, 0.0} +
                          options.carrying_slope * Cos(q[kElbowFlexion]) + q[kElbowAdduction];
  arm.forearm.turning = arm.upper_arm.turning * About(z, q[kElbowFlexion]) * About(x, -carrying) *
                        About(y, q[kForearmPronation]);
  arm.forearm.joint_W = PointOn(arm.upper_arm, Distal(scenario.length.at(Segment::kUpperArm)));
  arm.wrist_W = PointOn(arm.forearm, Distal(scenario.length.at(Segment::kForearm)));
  return arm;
}

bool IsName(const std::string& name) {
  for (const std::string& known : ScenarioNames())
    if (name == known) return true;
  return false;
}

}  // namespace

bool ScenarioOptions::IsValid(std::string* why) const {
  const auto fail = [why](const std::string& reason) {
    *why = reason;
    return false;
  };
  if (!IsName(name)) return fail("scenario.name \"" + name + "\" is not a known scenario");
  if (!(time_scale > 0.0)) return fail("scenario.time_scale must be > 0");
  const double shortest = kRestAtStart + kRestAtEnd + ShortestPerformance(*this) * TimeScale(*this);
  if (!(duration >= shortest))
    return fail(
        "scenario.duration must be at least 5 s for the rests and 10 s (daily_slow: 40 s, "
        "calibration: 55 s) x time_scale");
  if (!(adduction_rms >= 0.0)) return fail("scenario.adduction_rms must be >= 0 rad");
  if (!(shoulder_rms >= 0.0)) return fail("scenario.shoulder_rms must be >= 0 m");
  if (!(std::abs(carrying_angle) + std::abs(carrying_slope) < std::numbers::pi / 4))
    return fail("scenario.carrying_angle and carrying_slope must stay within 45 deg together");
  return true;
}

ArmMotion Scenario::At(double t) const {
  const ArmMotion right = RightArmAt(*this, t);
  return options.side == Side::kRight ? right : Mirrored(right);
}

Scenario MakeScenario(const ScenarioOptions& options) {
  Scenario scenario{
      .options = options,
      .joints = Perform(options),
      .trunk_heading =
          Draws(options.seed, "trunk_heading").Uniform(-std::numbers::pi, std::numbers::pi),
      .length = {{Segment::kUpperArm, 0.31}, {Segment::kForearm, 0.26}},
      .intervals = LabelledIntervals(options)};
  return scenario;
}

}  // namespace brachium
