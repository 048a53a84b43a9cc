#include "solver/stretch.h"

#include <algorithm>

#include "solver/initial_guess.h"

namespace brachium {
namespace {

std::size_t U(int i) { return static_cast<std::size_t>(i); }

bool OfContact(UnknownKind kind) {
  return kind == UnknownKind::kContactPlace || kind == UnknownKind::kContactHeight;
}

int ContactAt(const ArmProblem& problem, const std::string& place) {
  const auto& contacts = problem.observations().contacts;
  const auto found = std::ranges::find(contacts, place, &Contact::place);
  return static_cast<int>(found - contacts.begin());
}

// The unknown of a stretch that is the same thing at its first knot.
int IndexAtStart(const ArmProblem& problem, const Handover::Known& known) {
  const Unknown& u = known.unknown;
  switch (u.kind) {
    case UnknownKind::kAttitude:
      return problem.Attitude(0, u.sensor);
    case UnknownKind::kRoot:
      return problem.Root(0, u.sensor);
    case UnknownKind::kVelocity:
      return problem.Velocity(0, u.sensor);
    case UnknownKind::kPlace:
      return problem.Place(0, u.sensor);
    case UnknownKind::kSkin:
      return problem.Skin(0, u.sensor);
    case UnknownKind::kAdduction:
      return problem.Adduction(0);
    case UnknownKind::kGyroBias:
      return problem.GyroBias(0, u.sensor);
    default:
      return problem.Constant(u.kind,
                              OfContact(u.kind) ? ContactAt(problem, known.place) : u.sensor);
  }
}

}  // namespace

std::vector<double> Handover::Of(UnknownKind kind, int sensor) const {
  for (const Known& one : known)
    if (one.unknown.kind == kind && one.unknown.sensor == sensor) return one.value;
  return std::vector<double>(3, 0.0);
}

Handover HandOver(const ArmProblem& problem, State& state, const CarriedPrior& prior, int knot) {
  const auto& knots = problem.timeline().knots;
  Handover handover{.time = knots[U(knot)],
                    .touches_from = 0.5 * (knots[U(knot) - 1] + knots[U(knot)]),
                    .known = {},
                    .prior = prior.cost->Copy()};
  for (const int index : prior.unknowns) {
    const Unknown unknown = problem.Describe(index);
    const double* x = problem.Value(state, index);
    handover.known.push_back(
        {unknown,
         OfContact(unknown.kind) ? problem.observations().contacts[U(unknown.sensor)].place : "",
         {x, x + unknown.Size()}});
  }
  return handover;
}

void LetClocksDrift(Handover& handover, const std::vector<double>& steps, double sigma) {
  for (std::size_t i = 0; i < handover.known.size(); ++i) {
    Handover::Known& known = handover.known[i];
    if (known.unknown.kind != UnknownKind::kClockOffset) continue;
    const double step = steps[U(known.unknown.sensor)];
    known.value[0] += step;
    handover.prior->Step(i, step, sigma);
  }
}

CarriedPrior TakeOver(const Handover& handover, const ArmProblem& problem, State& state) {
  CarriedPrior prior{handover.prior->Copy(), {}};
  for (const Handover::Known& known : handover.known) {
    const int index = IndexAtStart(problem, known);
    std::ranges::copy(known.value, problem.Value(state, index));
    prior.unknowns.push_back(index);
  }
  HoldBias(problem, state, 0);
  return prior;
}

Observations ToldBetween(Observations told, const Handover* from, double end) {
  const auto outside = [&](const std::optional<HeldPose>& pose) {
    return pose && ((from != nullptr && pose->time < from->time) || pose->time >= end);
  };
  if (outside(told.start_pose)) told.start_pose.reset();
  if (outside(told.end_pose)) told.end_pose.reset();
  for (Contact& contact : told.contacts)
    std::erase_if(contact.times, [&](double time) {
      return (from != nullptr && time <= from->touches_from) || time > end;
    });
  std::erase_if(told.contacts, [](const Contact& contact) { return contact.times.empty(); });
  return told;
}

}  // namespace brachium
