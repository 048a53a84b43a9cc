#include "solver/clocks.h"

#include <gtest/gtest.h>

#include "solver/window.h"
#include "tests/support/simulated_trial.h"

namespace brachium {
namespace {

// A short trial whose forearm runs on another clock, solved with its samples summed as told.
struct Solved {
  ArmProblem problem;
  State state;
  ClocksFound clocks;

  Solved(const Observations& observations, const ModelOptions& model)
      : problem(observations, model, 0.1), state(problem.PriorState()) {
    SolveForward(problem, state, {}, {});
    ChainWorkspace workspace(problem);
    Solve(problem, state, {}, 0, problem.timeline().Intervals(), {}, &workspace);
    workspace.Linearise(problem, state);
    clocks = FindClocks(problem, state, workspace);
  }
  double Clock() const { return *state.Constant(UnknownKind::kClockOffset, 1); }
};

SimulatedTrial OnTwoClocks(const std::string& scenario, double offset) {
  SimulationOptions errors;
  errors.clock_offset = offset;
  return Simulate(MakeScenario({.name = scenario, .seed = 3, .duration = 45}), errors);
}

TEST(Clocks, AreFollowedWhereMovementTellsThemFarAway) {
  const SimulatedTrial brisk = OnTwoClocks("daily_brisk", 0.03);
  const Solved solved(brisk.trial.observations, {});
  EXPECT_TRUE(solved.clocks.far);
  ASSERT_EQ(solved.clocks.offsets.size(), 2u);
  EXPECT_EQ(solved.clocks.offsets[0], 0.0);
  EXPECT_EQ(solved.clocks.offsets[1], solved.Clock());
  EXPECT_NEAR(solved.Clock(), brisk.True("forearm.clock_offset_s").at(0), 3e-3);
}

TEST(Clocks, AreTakenAsFoundWithoutSummingAgainWhereTheyAreNear) {
  const Solved solved(OnTwoClocks("daily_brisk", 0.003).trial.observations, {});
  EXPECT_GT(std::abs(solved.Clock()), 2e-3);
  EXPECT_FALSE(solved.clocks.far);
  EXPECT_EQ(solved.clocks.offsets[1], solved.Clock());
}

TEST(Clocks, AreNotFollowedWhereMovementDoesNotTellThem) {
  const Observations slow = OnTwoClocks("daily_slow", 0.15).trial.observations;
  const Solved untold(slow, {});
  EXPECT_GT(std::abs(untold.Clock()), 6e-3);
  EXPECT_FALSE(untold.clocks.far);
  EXPECT_EQ(untold.clocks.offsets[1], 0.0);
  // The same movement tells a clock of which less was known.
  ModelOptions model;
  model.clock_offset_sigma_s = 0.1;
  EXPECT_TRUE(Solved(slow, model).clocks.far);
}

TEST(ClockRates, GoOnAsClocksWentSoFar) {
  ClockRates rates;
  for (const double time : {100.0, 160.0, 20100.0}) rates.Add(time, {0.0, 1e-3 + 2e-5 * time});
  const std::vector<double> steps = rates.Steps(60.0);
  ASSERT_EQ(steps.size(), 2u);
  EXPECT_EQ(steps[0], 0.0);
  EXPECT_NEAR(steps[1] / (2e-5 * 60.0), 1.0, 0.02);
}

TEST(ClockRates, AreNotTakenFromTwoFindingsThatLieCloseTogether) {
  ClockRates rates;
  rates.Add(80.0, {0.0, 1e-3});
  EXPECT_EQ(rates.Steps(60.0)[1], 0.0);
  rates.Add(140.0, {0.0, 4e-3});
  EXPECT_LT(rates.Steps(60.0)[1], 1.5e-3);
}

}  // namespace
}  // namespace brachium
