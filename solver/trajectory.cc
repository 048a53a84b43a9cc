#include "solver/trajectory.h"

#include <algorithm>
#include <limits>
#include <string>

namespace brachium {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;
using Attitude = Eigen::Map<const Quaterniond>;
using Vector = Eigen::Map<const Vector3d>;

std::size_t U(int i) { return static_cast<std::size_t>(i); }

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// Gyro integration from a knot, sample by sample, closed onto the next knot.
class AttitudeBetweenKnots {
 public:
  AttitudeBetweenKnots(const ArmProblem& problem, const State& state, int knot, int sensor)
      : problem_(problem), sensor_(sensor) {
    const Timeline& timeline = problem.timeline();
    start_ = time_ = timeline.knots[U(knot)];
    end_ = timeline.knots[U(knot) + 1];
    const double middle = 0.5 * (start_ + end_), alpha = timeline.NodeFraction(middle);
    const int node = timeline.NodeBefore(middle);
    bias_ = (1 - alpha) * Vector(state.GyroBias(node, sensor)) +
            alpha * Vector(state.GyroBias(node + 1, sensor));
    const auto& mounting = problem.observations().recordings[U(sensor)].mounting;
    const Quaterniond q_CS = mounting ? mounting->q_BS : Quaterniond::Identity();
    const Vector mounting_turn(state.Constant(UnknownKind::kMounting, sensor));
    turn_ = mounting_turn + Vector(state.Skin(knot, sensor));
    turning_ = Vector(state.Skin(knot + 1, sensor)) - Vector(state.Skin(knot, sensor));
    q_SC_ = q_CS.conjugate();
    q_WS_ = Attitude(state.Attitude(knot, sensor)) * q_CS;
    clock_offset_ = *state.Constant(UnknownKind::kClockOffset, sensor);
    const Quaterniond q_end =
        q_WS_ * problem.Samples(sensor).Turn(start_, end_, bias_, clock_offset_).dq;
    closing_ = Log<double>(q_end.conjugate() * (Attitude(state.Attitude(knot + 1, sensor)) * q_CS));
  }

  // Times must not decrease from call to call.
  Quaterniond At(double time) {
    if (time > time_)
      q_WS_ = q_WS_ * problem_.Samples(sensor_).Turn(time_, time, bias_, clock_offset_).dq;
    time_ = std::max(time, time_);
    const double fraction = (time_ - start_) / (end_ - start_);
    const Quaterniond q_SB = q_SC_ * Exp<double>(-turn_ - fraction * turning_);
    return (q_WS_ * Exp<double>(fraction * closing_) * q_SB).normalized();
  }

 private:
  const ArmProblem& problem_;
  int sensor_;
  double start_, end_, time_, clock_offset_;
  Vector3d bias_, closing_, turn_, turning_;
  Quaterniond q_SC_, q_WS_;
};

// Slope of the arm's root at a knot: a sensor's own velocity, else differences of its neighbours.
Vector3d RootVelocity(const ArmProblem& problem, const State& state, int knot, int root) {
  if (problem.size().sensors == 1) return Vector(state.Velocity(knot, 0));
  const auto& knots = problem.timeline().knots;
  const int before = std::max(knot - 1, 0), after = std::min(knot + 1, problem.size().knots - 1);
  return (Vector(state.Root(after, root)) - Vector(state.Root(before, root))) /
         (knots[U(after)] - knots[U(before)]);
}

Vector3d RootAt(const ArmProblem& problem, const State& state, int knot, int root, double time) {
  const auto& knots = problem.timeline().knots;
  const double D = knots[U(knot) + 1] - knots[U(knot)], u = (time - knots[U(knot)]) / D;
  const Vector p0(state.Root(knot, root)), p1(state.Root(knot + 1, root));
  const Vector3d v0 = RootVelocity(problem, state, knot, root);
  const Vector3d v1 = RootVelocity(problem, state, knot + 1, root);
  return p0 + (p1 - p0) * (u * u * (3 - 2 * u)) + v0 * (D * u * (1 - u) * (1 - u)) -
         v1 * (D * u * u * (1 - u));
}

// Positions of the joints along the arm at one instant; `q_WB` by sensor.
void StoreJoints(const ArmProblem& problem, const State& state, const Vector3d& root,
                 const std::vector<Quaterniond>& q_WB, std::size_t sample, Estimate& estimate) {
  const auto& recordings = problem.observations().recordings;
  const int first = problem.FirstOfArm(), sensors = problem.size().sensors;
  if (sensors == 1) {
    estimate.p_W[std::string(Name(recordings[0].segment))][sample] = root;
    return;
  }
  const std::string name(ProximalJointName(recordings[U(first)].segment));
  if (!name.empty()) estimate.p_W[name][sample] = root;
  Vector3d p = root;
  for (int sensor = first; sensor < sensors; ++sensor) {
    p += q_WB[U(sensor)] * Vector(state.Constant(UnknownKind::kJointVector, sensor));
    estimate.p_W[std::string(DistalJointName(recordings[U(sensor)].segment))][sample] = p;
  }
}

void AddColumns(const ArmProblem& problem, Estimate& estimate) {
  const auto& recordings = problem.observations().recordings;
  const std::size_t samples = estimate.time.size();
  const auto add_point = [&](const std::string& name) {
    if (!name.empty()) estimate.p_W[name].assign(samples, Vector3d::Constant(kNaN));
  };
  for (const Recording& recording : recordings)
    estimate.q_WB[recording.segment].assign(samples, Quaterniond(kNaN, kNaN, kNaN, kNaN));
  if (recordings.size() == 1) return add_point(std::string(Name(recordings[0].segment)));
  const auto first = U(problem.FirstOfArm());
  add_point(std::string(ProximalJointName(recordings[first].segment)));
  for (std::size_t i = first; i < recordings.size(); ++i)
    add_point(std::string(DistalJointName(recordings[i].segment)));
}

}  // namespace

void FillTrajectory(const ArmProblem& problem, const State& state, Estimate& estimate) {
  const auto& recordings = problem.observations().recordings;
  const auto& knots = problem.timeline().knots;
  const int sensors = problem.size().sensors, arm_root = problem.size().roots - 1;
  AddColumns(problem, estimate);
  std::size_t sample = 0;
  while (sample < estimate.time.size() && estimate.time[sample] < knots.front()) ++sample;
  for (int knot = 0; knot < problem.timeline().Intervals(); ++knot) {
    std::vector<AttitudeBetweenKnots> attitudes;
    for (int sensor = 0; sensor < sensors; ++sensor)
      attitudes.emplace_back(problem, state, knot, sensor);
    for (; sample < estimate.time.size() && estimate.time[sample] <= knots[U(knot) + 1]; ++sample) {
      const double time = estimate.time[sample];
      std::vector<Quaterniond> q_WB;
      for (int sensor = 0; sensor < sensors; ++sensor) {
        q_WB.push_back(attitudes[U(sensor)].At(time));
        estimate.q_WB[recordings[U(sensor)].segment][sample] = q_WB.back();
      }
      const Vector3d root = RootAt(problem, state, knot, arm_root, time);
      StoreJoints(problem, state, root, q_WB, sample, estimate);
    }
  }
}

}  // namespace brachium
