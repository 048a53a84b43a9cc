#include "problems/simulation/worn_sensor.h"

#include "problems/rotation.h"

namespace brachium {

namespace {

using Eigen::Matrix3d, Eigen::Quaterniond, Eigen::Vector3d;

// Out of the skin where the sensor sits.
Vector3d Outward(Segment segment) {
  return segment == Segment::kUpperArm ? Vector3d(Vector3d::UnitZ()) : Vector3d(-Vector3d::UnitX());
}

Vector3d Seat(Segment segment, const Vector3d& distal) {
  if (segment == Segment::kGirdle) return {-0.06, -0.05, 0.10};
  if (segment == Segment::kUpperArm) return {0.0, 0.8 * distal.y(), 0.045};
  if (segment == Segment::kForearm) return {-0.03, 0.85 * distal.y(), 0.0};
  return {-0.02, 0.35 * distal.y(), 0.0};
}

}  // namespace

Mounting DrawMounting(Segment segment, const Vector3d& distal, Draws& draws) {
  Matrix3d R_BS;  // sensor x distal (the girdle's down), z out of the skin
  R_BS.col(0) = -Vector3d::UnitY();
  R_BS.col(2) = Outward(segment);
  R_BS.col(1) = R_BS.col(2).cross(R_BS.col(0));
  const Vector3d askew = draws.OfLength(draws.Uniform(5.0, 20.0) * kDegree);
  Mounting mounting;
  mounting.q_BS = (Quaterniond(R_BS) * Exp<double>(askew)).normalized();
  mounting.p_BS_B = Seat(segment, distal);
  return mounting;
}

Wobble DrawWobble(const SoftTissue& soft_tissue, Segment segment, double duration, Draws& draws) {
  constexpr double kOnset = 1.0;  // [s]
  Wobble wobble;
  const bool softest = segment == Segment::kUpperArm && soft_tissue.upper_arm_along_rms > 0.0;
  const double along_rms = softest ? soft_tissue.upper_arm_along_rms : soft_tissue.along_rms;
  const std::array turn_rms = {soft_tissue.across_rms, along_rms, soft_tissue.across_rms};
  for (std::size_t i = 0; i < 3; ++i) {
    wobble.turn[i] = RandomMotion(turn_rms[i], soft_tissue.frequency, draws);
    wobble.shift[i] = RandomMotion(soft_tissue.translation_rms, soft_tissue.frequency, draws);
  }
  wobble.envelope.AddStep(kRestAtStart, kOnset, 1.0);
  wobble.envelope.AddStep(duration - kRestAtEnd - kOnset, kOnset, -1.0);
  wobble.present =
      along_rms > 0.0 || soft_tissue.across_rms > 0.0 || soft_tissue.translation_rms > 0.0;
  return wobble;
}

TurningFrame TurnOf(const Wobble& wobble, double t) {
  const Moving envelope = wobble.envelope.At(t);
  return About(Vector3d::UnitY(), envelope * wobble.turn[1].At(t)) *
         About(Vector3d::UnitX(), envelope * wobble.turn[0].At(t)) *
         About(Vector3d::UnitZ(), envelope * wobble.turn[2].At(t));
}

SensorInstant At(const WornSensor& sensor, const Scenario& scenario, double t) {
  const BodyMotion body = scenario.At(t)[sensor.segment];
  TurningFrame mounting{.q_AB = sensor.mounting.q_BS};
  MovingPoint r_B{.p = sensor.mounting.p_BS_B};
  if (sensor.wobble.present) {
    const Moving envelope = sensor.wobble.envelope.At(t);
    const auto& shift = sensor.wobble.shift;
    const MovingPoint d_B =
        PointOf(envelope * shift[0].At(t), envelope * shift[1].At(t), envelope * shift[2].At(t));
    mounting = TurnOf(sensor.wobble, t) * mounting;
    r_B = {r_B.p + d_B.p, d_B.v, d_B.a};
  }
  const TurningFrame turning = body.turning * mounting;
  const MovingPoint point_W = PointOn(body, r_B);
  const Vector3d force_W = point_W.a + kGravity * Vector3d::UnitZ();
  return {.gyr_S = turning.omega_AB_B,
          .acc_S = turning.q_AB.conjugate() * force_W,
          .q_WS = turning.q_AB,
          .point_W = point_W};
}

}  // namespace brachium
