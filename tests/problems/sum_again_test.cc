// Whose clock is the true time, and what changes where the others' are taken to be somewhere else.
#include <gtest/gtest.h>

#include <algorithm>

#include "problems/arm_problem.h"
#include "tests/support/overstretched.h"
#include "tests/support/simulated_trial.h"

namespace brachium {
namespace {

constexpr double kBehind = 0.2;  // [s]

ArmProblem SummedAgain() {
  ArmProblem problem(Brisk(16).observations, {}, 0.1);
  problem.SumAgain(problem.PriorState(), {0.0, kBehind});
  return problem;
}

// The residuals of one kind over an interval of the second sensor, as if it lay still.
Eigen::VectorXd Said(const ArmProblem& problem, ResidualKind kind, int knot) {
  State state = Overstretched(problem);
  *state.Constant(UnknownKind::kClockOffset, 1) = kBehind;
  for (const Term& term : problem.terms()) {
    if (term.kind != kind || term.sensor != 1 || term.first_knot != knot) continue;
    std::vector<const double*> x;
    for (const int unknown : term.unknowns) x.push_back(problem.Value(state, unknown));
    Eigen::VectorXd r(term.cost->num_residuals());
    term.cost->Evaluate(x.data(), r.data(), nullptr);
    return r;
  }
  return {};
}

// When a sensor begins to rest, by the knots at which its velocity is held first [s].
std::vector<double> RestStarts(const ArmProblem& problem, int sensor) {
  std::vector<double> starts;
  for (const Term& term : problem.terms())
    if (term.kind == ResidualKind::kZeroVelocity && term.sensor == sensor &&
        term.first_knot == term.last_knot)
      starts.push_back(problem.timeline().knots[static_cast<std::size_t>(term.first_knot)]);
  return starts;
}

TEST(ArmProblem, TakesTheClockOfTheSegmentThatItIsToldForTheTrueTime) {
  const Observations observations = Brisk(16).observations;
  const auto is_held = [](const ArmProblem& problem, int sensor) {
    return problem.Describe(problem.Constant(UnknownKind::kClockOffset, sensor)).held;
  };
  const ArmProblem first(observations, {}, 0.1), other(observations, {}, 0.1, Segment::kForearm);
  for (const int sensor : {0, 1}) {
    EXPECT_EQ(is_held(first, sensor), sensor == 0);
    EXPECT_EQ(is_held(other, sensor), sensor == 1);
  }
}

TEST(SumAgain, TakesEachSensorsSamplesWhereItsClockIs) {
  const ArmProblem before(Brisk(16).observations, {}, 0.1), again = SummedAgain();
  for (const int knot : {0, 40, before.timeline().Intervals() - 1}) {
    EXPECT_EQ(again.Interval(knot, 0).dv, before.Interval(knot, 0).dv);
    EXPECT_EQ(again.Interval(knot, 1).clock_offset, kBehind);
    EXPECT_NE(again.Interval(knot, 1).dv, before.Interval(knot, 1).dv);
    for (const ResidualKind kind : {ResidualKind::kGyroscope, ResidualKind::kAccelerometer})
      EXPECT_NE(Said(again, kind, knot), Said(before, kind, knot)) << Name(kind);
  }
}

// The other sensor is on for less long, so that the clock does not move the knots.
TEST(SumAgain, SaysWhatAProblemAboutThatClockSaysFromTheStart) {
  Observations observations = Brisk(16).observations;
  observations.recordings[0] = Cut(observations.recordings[0], 1.0, 15.0);
  ArmProblem again(observations, {}, 0.1);
  again.SumAgain(again.PriorState(), {0.0, kBehind});
  Stretch whole;
  whole.clock_offset = {0.0, kBehind};
  const ArmProblem start(observations, {}, 0.1, std::nullopt, whole);
  for (const int knot : {0, 40, start.timeline().Intervals() - 1})
    for (const ResidualKind kind : {ResidualKind::kGyroscope, ResidualKind::kAccelerometer})
      EXPECT_LT((Said(again, kind, knot) - Said(start, kind, knot)).norm(),
                1e-9 * Said(start, kind, knot).norm())
          << Name(kind) << " " << knot;
}

TEST(SumAgain, MovesTheRestsOfASensorByItsClock) {
  const ArmProblem before(Brisk(16).observations, {}, 0.1), again = SummedAgain();
  EXPECT_EQ(RestStarts(again, 0), RestStarts(before, 0));
  const std::vector<double> earlier = RestStarts(before, 1), later = RestStarts(again, 1);
  ASSERT_GT(earlier.size(), 2u);
  ASSERT_EQ(later.size(), earlier.size());
  for (std::size_t rest = 0; rest < later.size(); ++rest)
    EXPECT_NEAR(later[rest] - earlier[rest], kBehind, 0.11);
}

TEST(SumAgain, KeepsTheTermsInOrderAndAsMany) {
  const ArmProblem before(Brisk(16).observations, {}, 0.1), again = SummedAgain();
  const auto earlier = [](const Term& a, const Term& b) { return a.first_knot < b.first_knot; };
  EXPECT_TRUE(std::is_sorted(again.terms().begin(), again.terms().end(), earlier));
  const auto measured = [](const ArmProblem& problem) {
    return std::count_if(problem.terms().begin(), problem.terms().end(), [](const Term& term) {
      return term.kind != ResidualKind::kZeroVelocity && term.kind != ResidualKind::kGyroBiasRest;
    });
  };
  EXPECT_EQ(measured(again), measured(before));
}

}  // namespace
}  // namespace brachium
