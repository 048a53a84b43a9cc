#include "solver/step_values.h"

#include <algorithm>
#include <limits>

#include "problems/rotation_manifold.h"

namespace brachium {
namespace {

using Eigen::Vector3d;

std::size_t U(int i) { return static_cast<std::size_t>(i); }

// Share of a step over which the slope of the chain is taken.
constexpr double kNearby = 1e-3;

void Move(const FrontPlan::Variable& variable, const double* from, const double* d, double share) {
  if (variable.size == 4) {
    const double turn[3] = {share * d[0], share * d[1], share * d[2]};
    RotationManifold().Plus(from, turn, variable.value);
    return;
  }
  for (int i = 0; i < variable.size; ++i) variable.value[i] = from[i] + share * d[i];
}

}  // namespace

StepValues::StepValues(const ArmProblem& problem, const State& state, const FrontPlan& plan)
    : problem_(problem), state_(state), plan_(plan) {
  std::size_t size = 0;
  int first = std::numeric_limits<int>::max(), last = -1;
  for (const auto& variable : plan.variables()) {
    size += U(variable.size);
    const Unknown u = problem.Describe(variable.unknown);
    if (u.kind != UnknownKind::kPlace) continue;
    first = std::min(first, u.place);
    last = std::max(last, u.place);
  }
  saved_.resize(size);
  first_knot_ = first;
  knots_ = std::max(0, last - first + 1);
  for (Vectors* vectors : {&here_, &ahead_, &behind_, &bend_})
    vectors->assign(U(knots_ * problem.size().sensors), Vector3d::Zero());
}

void StepValues::Save() {
  double* to = saved_.data();
  for (const auto& variable : plan_.variables())
    to = std::copy_n(variable.value, variable.size, to);
}

void StepValues::Restore() const {
  const double* from = saved_.data();
  for (const auto& variable : plan_.variables()) {
    std::copy_n(from, variable.size, variable.value);
    from += variable.size;
  }
}

void StepValues::Set(const std::vector<double>& step, double share) {
  Restore();
  PlacesOnChain(here_);
  SetLinear(step, kNearby);
  PlacesOnChain(ahead_);
  SetLinear(step, -kNearby);
  PlacesOnChain(behind_);
  SetLinear(step, share);
  PlacesOnChain(bend_);
  for (std::size_t i = 0; i < bend_.size(); ++i)
    bend_[i] -= here_[i] + share / (2 * kNearby) * (ahead_[i] - behind_[i]);
  FollowTheChain();
}

void StepValues::SetLinear(const std::vector<double>& step, double share) const {
  const double* from = saved_.data();
  for (const auto& variable : plan_.variables()) {
    if (variable.tangent > 0) Move(variable, from, &step[U(variable.column)], share);
    from += variable.size;
  }
}

void StepValues::PlacesOnChain(Vectors& places) const {
  auto place = places.begin();
  for (int knot = first_knot_; knot < first_knot_ + knots_; ++knot)
    for (int sensor = 0; sensor < problem_.size().sensors; ++sensor)
      *place++ = problem_.PlaceOnChain(state_, knot, sensor);
}

void StepValues::FollowTheChain() const {
  const int sensors = problem_.size().sensors;
  const auto& time = problem_.timeline().knots;
  for (int k = 0; k < knots_; ++k) {
    const int before = std::max(k - 1, 0), after = std::min(k + 1, knots_ - 1);
    const double span = time[U(first_knot_ + after)] - time[U(first_knot_ + before)];
    for (int sensor = 0; sensor < sensors; ++sensor) {
      Add(problem_.Place(first_knot_ + k, sensor), bend_[U(k * sensors + sensor)]);
      if (span > 0.0)
        Add(problem_.Velocity(first_knot_ + k, sensor),
            (bend_[U(after * sensors + sensor)] - bend_[U(before * sensors + sensor)]) / span);
    }
  }
}

void StepValues::Add(int unknown, const Vector3d& more) const {
  const int index = plan_.IndexOf(unknown);
  if (index >= 0) Eigen::Map<Vector3d>(plan_.variables()[U(index)].value) += more;
}

}  // namespace brachium
