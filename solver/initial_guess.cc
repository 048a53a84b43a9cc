#include "solver/initial_guess.h"

#include <algorithm>
#include <cmath>

#include "problems/joint_angles.h"

namespace brachium {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;
using Attitude = Eigen::Map<Quaterniond>;
using Vector = Eigen::Map<const Vector3d>;

constexpr double kInclinationSpan = 2.0;  // of specific force that the first inclination uses [s]

std::size_t U(int i) { return static_cast<std::size_t>(i); }

Quaterniond MountingOf(const ArmProblem& problem, int sensor) {
  const auto& mounting = problem.observations().recordings[U(sensor)].mounting;
  return mounting ? mounting->q_BS : Quaterniond::Identity();
}

Vector3d BiasAt(const ArmProblem& problem, const State& state, int knot, int sensor) {
  const Timeline& timeline = problem.timeline();
  const double middle = 0.5 * (timeline.knots[U(knot)] + timeline.knots[U(knot) + 1]);
  const int node = timeline.NodeBefore(middle);
  const double alpha = timeline.NodeFraction(middle);
  return (1 - alpha) * Vector(state.GyroBias(node, sensor)) +
         alpha * Vector(state.GyroBias(node + 1, sensor));
}

Quaterniond Turn(const ArmProblem& problem, const State& state, int knot, int sensor) {
  const Preintegrated& interval = problem.Interval(knot, sensor);
  return interval.dq *
         Exp<double>(interval.dR_dbg * (BiasAt(problem, state, knot, sensor) - interval.gyro_bias) +
                     interval.dR_dsg * Vector(state.Constant(UnknownKind::kGyroScale, sensor)));
}

// The vertical in sensor axes at the first knot: specific force of the first seconds, turned back.
Vector3d FirstVertical(const ArmProblem& problem, const State& state, int sensor) {
  Quaterniond q = Quaterniond::Identity();
  Vector3d sum = Vector3d::Zero();
  double span = 0.0;
  for (int knot = 0; knot < problem.timeline().Intervals() && span < kInclinationSpan; ++knot) {
    const Preintegrated& interval = problem.Interval(knot, sensor);
    sum += q * interval.dv;
    q = q * Turn(problem, state, knot, sensor);
    span += interval.duration;
  }
  return sum.normalized();
}

// The turn about the vertical that brings q nearest to q_target [rad].
double HeadingTowards(const Quaterniond& q_target, const Quaterniond& q) {
  const Quaterniond q_turn = q_target * q.conjugate();
  return 2 * std::atan2(q_turn.z(), q_turn.w());
}

void SetPlaces(const ArmProblem& problem, State& state, int knot) {
  for (int sensor = 0; sensor < problem.size().sensors; ++sensor)
    Eigen::Map<Vector3d>{state.Place(knot, sensor)} = problem.PlaceOnChain(state, knot, sensor);
}

// Where the first touch shows it, if that is beyond `from` and no later than `to`; at the first knot
// too.
void SetContactPlaces(const ArmProblem& problem, State& state, int from, int to) {
  for (int contact = 0; contact < problem.size().contacts; ++contact) {
    const int first = problem.Touches(contact).front(), place = problem.PlaceOf(contact);
    if (first > to || first < from || (first == from && from > 0)) continue;
    const int numbers = problem.Describe(place).Size();
    Eigen::Map<Eigen::VectorXd>{problem.Value(state, place), numbers} =
        problem.TouchingPoint(state, contact, first).tail(numbers);
  }
}

}  // namespace

void SetFirstKnot(const ArmProblem& problem, State& state) {
  for (int sensor = 0; sensor < problem.size().sensors; ++sensor) {
    const Vector3d up_B = MountingOf(problem, sensor) * FirstVertical(problem, state, sensor);
    Attitude{state.Attitude(0, sensor)} = RotationBetween(up_B, Vector3d::UnitZ());
    const Vector3d x_W = Attitude(state.Attitude(0, sensor)) * Vector3d::UnitX();
    TurnFirstKnot(state, sensor, -std::atan2(x_W.y(), x_W.x()));
  }
  const int upper = problem.SensorOn(Segment::kUpperArm);
  const int fore = problem.SensorOn(Segment::kForearm);
  const auto& pose = problem.observations().start_pose;
  if (upper < 0 || fore < 0 || !pose || !pose->forearm_pronation) return;
  const ElbowAngles angles{pose->elbow_flexion.value_or(0.0),
                           problem.observations().arm.elbow.carrying_angle,
                           *pose->forearm_pronation};
  const Quaterniond q_target =
      Attitude(state.Attitude(0, upper)) * ElbowRotation(angles, problem.observations().arm.side);
  TurnFirstKnot(state, fore, HeadingTowards(q_target, Attitude(state.Attitude(0, fore))));
}

void TurnFirstKnot(State& state, int sensor, double heading) {
  Attitude q(state.Attitude(0, sensor));
  q = Quaterniond(Eigen::AngleAxisd(heading, Vector3d::UnitZ())) * q;
}

void DeadReckon(const ArmProblem& problem, State& state, int from, int to) {
  const Vector3d gravity(0, 0, -problem.observations().gravity);
  for (int knot = from; knot < to; ++knot) {
    for (int sensor = 0; sensor < problem.size().sensors; ++sensor) {
      const Preintegrated& interval = problem.Interval(knot, sensor);
      const Quaterniond q_BS = MountingOf(problem, sensor);
      const Quaterniond q_WS = Attitude(state.Attitude(knot, sensor)) * q_BS;
      Attitude{state.Attitude(knot + 1, sensor)} =
          (q_WS * Turn(problem, state, knot, sensor) * q_BS.conjugate()).normalized();
      Eigen::Map<Vector3d>{state.Velocity(knot + 1, sensor)} =
          Vector(state.Velocity(knot, sensor)) + gravity * interval.duration + q_WS * interval.dv;
    }
    for (int root = 0; root < problem.size().roots; ++root)
      std::copy_n(state.Root(knot, root), 3, state.Root(knot + 1, root));
    if (knot == 0) SetPlaces(problem, state, 0);
    SetPlaces(problem, state, knot + 1);
  }
  SetContactPlaces(problem, state, from, to);
}

void HoldBias(const ArmProblem& problem, State& state, int node) {
  for (int next = node + 1; next < problem.size().nodes; ++next)
    for (int sensor = 0; sensor < problem.size().sensors; ++sensor)
      std::copy_n(state.GyroBias(node, sensor), 3, state.GyroBias(next, sensor));
}

}  // namespace brachium
