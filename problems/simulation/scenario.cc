#include "problems/simulation/scenario.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "problems/simulation/choreography.h"
#include "problems/simulation/mirror.h"
#include "problems/simulation/patient.h"

namespace brachium {
namespace {

using Eigen::Vector3d;

// Trunk axes (X forward, Y up, Z right) in the world, facing `heading` from the world's x.
TurningFrame Upright(double heading) {
  return About(Vector3d::UnitZ(), {heading, 0.0, 0.0}) *
         About(Vector3d::UnitX(), {std::numbers::pi / 2, 0.0, 0.0});
}

// The elbow and the lengths of this very arm.
ArmShape ShapeOf(const ScenarioOptions& options, const ScenarioKind& kind) {
  constexpr double kGoniometerArm = 0.1;  // [m]
  if (kind.rig) return {.forearm = kGoniometerArm, .carrying_angle = 0.0, .carrying_slope = 0.0};
  Draws draws(options.seed, "carrying");
  const auto drawn = [&draws](double mean, double sd) {
    return mean + sd * std::clamp(draws.Normal(), -3.0, 3.0);
  };
  ArmShape shape;
  shape.carrying_angle = drawn(options.carrying_angle, options.carrying_angle_sd);
  shape.carrying_slope = drawn(options.carrying_slope, options.carrying_slope_sd);
  return shape;
}

std::vector<Segment> UsuallyWorn(const ScenarioKind& kind) {
  if (!kind.four_sensors) return {Segment::kUpperArm, Segment::kForearm};
  return {Segment::kGirdle, Segment::kUpperArm, Segment::kForearm, Segment::kHand};
}

bool HasRightSizes(const ScenarioOptions& options, std::string* why) {
  const auto fail = [why](const std::string& reason) {
    *why = "scenario." + reason;
    return false;
  };
  if (!(options.adduction_rms >= 0.0)) return fail("adduction_rms must be >= 0 rad");
  if (!(options.shoulder_rms >= 0.0)) return fail("shoulder_rms must be >= 0 m");
  if (!(options.execution_error >= 0.0)) return fail("execution_error must be >= 0 rad");
  if (!(options.tremor >= 0.0)) return fail("tremor must be >= 0 rad");
  if (!(options.carrying_angle_sd >= 0.0 && options.carrying_slope_sd >= 0.0))
    return fail("carrying_angle_sd and carrying_slope_sd must be >= 0 rad");
  if (!(std::abs(options.carrying_angle) + std::abs(options.carrying_slope) +
            3.0 * (options.carrying_angle_sd + options.carrying_slope_sd) <
        std::numbers::pi / 3))
    return fail(
        "carrying_angle and carrying_slope must stay within 60 deg together, three sds "
        "of each included");
  return true;
}

}  // namespace

bool ScenarioOptions::IsValid(std::string* why) const {
  const auto fail = [why](const std::string& reason) {
    *why = "scenario." + reason;
    return false;
  };
  const ScenarioKind* const kind = FindScenario(name);
  if (kind == nullptr) return fail("name \"" + name + "\" is not a known scenario");
  if (!(time_scale > 0.0)) return fail("time_scale must be > 0");
  if (!(patient_week >= 0 && patient_week <= kPatientWeeks))
    return fail("patient_week must be 0 (healthy) or a week from 1 to 10");
  if (patient_week > 0 && !kind->has_patient)
    return fail("patient_week: " + name + " is not done by a patient");
  const double shortest = kRestAtStart + kRestAtEnd + kind->shortest * TimeScale(*this);
  if (!(duration >= shortest))
    return fail("duration: " + name + " takes " + std::to_string(std::lround(std::ceil(shortest))) +
                " s or more, rests and slowness included");
  return HasRightSizes(*this, why);
}

MovingPoint HandPath::WristAt(double t) const {
  const auto along = [t](const std::array<Motion, 3>& p) {
    return PointOf(p[0].At(t), p[1].At(t), p[2].At(t));
  };
  const Moving angle = phase.At(t);
  return along(wrist_T) +
         PointOf(radius * (Cos(angle) + Moving{-1.0, 0.0, 0.0}), {}, -(radius * Sin(angle)));
}

MovingJoints Scenario::JointsAt(double t) const {
  MovingJoints q;
  for (std::size_t i = 0; i < q.size(); ++i) q[i] = joints[i].At(t);
  if (hand_path) {
    const auto& elbow = hand_path->elbow_T;
    const MovingPoint shoulder_T = PointOf(q[kShoulderForward], q[kShoulderUp], q[kShoulderRight]);
    BringWristTo(hand_path->WristAt(t) - shoulder_T,
                 PointOf(elbow[0].At(t), elbow[1].At(t), elbow[2].At(t)), shape, q);
  }
  const Moving envelope = tremor_envelope.At(t);
  for (std::size_t i = 0; i < q.size(); ++i) q[i] = q[i] + envelope * tremor[i].At(t);
  return q;
}

ArmMotion Scenario::At(double t) const {
  const ArmMotion right = ArmOf(JointsAt(t), shape, Upright(trunk_heading));
  return options.side == Side::kRight ? right : Mirrored(right);
}

Scenario MakeScenario(const ScenarioOptions& options) {
  const ScenarioKind& kind = *FindScenario(options.name);
  Scenario scenario;
  scenario.options = options;
  scenario.shape = ShapeOf(options, kind);
  scenario.trunk_heading =
      Draws(options.seed, "trunk_heading").Uniform(-std::numbers::pi, std::numbers::pi);
  scenario.worn = UsuallyWorn(kind);
  scenario.rig = kind.rig;
  Perform(kind, scenario);
  return scenario;
}

}  // namespace brachium
