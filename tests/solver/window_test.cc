#include "solver/window.h"

#include <gtest/gtest.h>

#include <optional>

#include "problems/simulation/worn_sensor.h"
#include "solver/initial_guess.h"
#include "tests/support/simulated_trial.h"

namespace brachium {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;
using Attitude = Eigen::Map<Quaterniond>;
using Vector = Eigen::Map<Vector3d>;

constexpr SolveOptions kToTheEnd{.most_iterations = 100};

// The largest difference of attitudes at one knot, axis by axis, as a share of its sd at `state`.
double LargestShareOfSd(const ArmProblem& problem, State& state, const State& other, int knot) {
  ChainWorkspace workspace(problem);
  const Elimination elimination(problem, state, {}, 0, problem.size().knots, workspace);
  std::optional<double> share;
  elimination.VisitCovariances([&](int, const BlockIndex& index, const CovarianceView& covariance) {
    if (share || index.OffsetOf(problem.Attitude(knot, 0)) < 0) return;
    share = 0.0;
    for (int sensor = 0; sensor < problem.size().sensors; ++sensor) {
      const Eigen::Map<const Quaterniond> q(state.Attitude(knot, sensor));
      const Eigen::Map<const Quaterniond> q_other(other.Attitude(knot, sensor));
      const int at = index.OffsetOf(problem.Attitude(knot, sensor));
      const Vector3d sd = covariance.diagonal().segment<3>(at).cwiseSqrt();
      const Vector3d difference = Log<double>(q.conjugate() * q_other);
      share = std::max(*share, difference.cwiseQuotient(sd).cwiseAbs().maxCoeff());
    }
  });
  return share.value();
}

// The state after the forward windows, and after the whole trial was solved from there.
struct Solved {
  ArmProblem problem;
  State windows, whole;
  WindowReport report;

  explicit Solved(const Observations& observations, const WindowOptions& options = {})
      : problem(observations, {}, 0.05), windows(problem.PriorState()) {
    report = SolveForward(problem, windows, options, {});
    whole = windows;
    Solve(problem, whole, {}, 0, Last(), kToTheEnd);
  }
  int Last() const { return problem.timeline().Intervals(); }
};

constexpr WindowOptions kShort{.length = 5.0, .advance = 2.5};

// Marginal priors are linearised where the windows stood, which costs some thousandths of a
// standard deviation even without noise.
TEST(ForwardWindows, EndWithinATenthOfAStandardDeviationOfTheWholeTrialsLastKnot) {
  for (const SimulationOptions& options : {NoErrors(), SimulationOptions{}}) {
    Solved solved(Brisk(20, options).observations, kShort);
    EXPECT_GT(solved.report.windows, 4);
    EXPECT_LT(LargestShareOfSd(solved.problem, solved.whole, solved.windows, solved.Last()), 0.1);
  }
}

// Without adduction, slope or moving shoulder the truth leaves next to no residual.
TEST(ForwardWindows, EndWhereTheWholeTrialEndsIfTheModelHoldsExactly) {
  ScenarioOptions exact = BriskScenario(20);
  exact.adduction_rms = exact.carrying_slope = exact.shoulder_rms = 0.0;
  Solved solved(Simulate(MakeScenario(exact), NoErrors()).trial.observations, kShort);
  for (int sensor = 0; sensor < 2; ++sensor) {
    const Eigen::Map<Eigen::Quaterniond> q_whole(solved.whole.Attitude(solved.Last(), sensor)),
        q_windows(solved.windows.Attitude(solved.Last(), sensor));
    EXPECT_LT(q_whole.angularDistance(q_windows), 1e-6);
  }
}

TEST(ForwardWindows, OfTheWholeLengthAreTheWholeTrial) {
  Solved solved(Brisk(16).observations, {.length = 100.0, .advance = 50.0});
  EXPECT_EQ(solved.report.windows, 1);
  for (const int knot : {0, solved.Last() / 2, solved.Last()})
    EXPECT_LT(LargestShareOfSd(solved.problem, solved.whole, solved.windows, knot), 1e-2);
}

TEST(ForwardWindows, SayHowFarTheyAre) {
  const Observations observations = Brisk(16).observations;
  ArmProblem problem(observations, {}, 0.1);
  State state = problem.PriorState();
  std::vector<double> done;
  SolveForward(problem, state, {}, [&](const std::string& stage, double share) {
    EXPECT_EQ(stage, "windows");
    done.push_back(share);
  });
  EXPECT_TRUE(std::is_sorted(done.begin(), done.end()));
  EXPECT_NEAR(done.back(), 1.0, 1e-12);
}

// The motion that was really made, in the world of the problem's heading gauge.
State TrueState(const ArmProblem& problem, const Scenario& scenario, const SimulatedTrial& trial,
                const State& guess) {
  State state = problem.PriorState();
  const auto true_heading = scenario.At(problem.timeline().knots[0]).upper_arm.turning.q_AB;
  const Quaterniond q_turn =
      Eigen::Map<const Quaterniond>(guess.Attitude(0, 0)) * true_heading.conjugate();
  const Quaterniond q_WV(
      Eigen::AngleAxisd(2 * std::atan2(q_turn.z(), q_turn.w()), Vector3d::UnitZ()));
  const Vector3d p_start = scenario.At(problem.timeline().knots[0]).upper_arm.joint_W.p;
  for (int knot = 0; knot < problem.size().knots; ++knot) {
    const ArmMotion arm = scenario.At(problem.timeline().knots[static_cast<std::size_t>(knot)]);
    Vector{state.Root(knot, 0)} = q_WV * (arm.upper_arm.joint_W.p - p_start);
    for (int sensor = 0; sensor < 2; ++sensor) {
      const Segment segment = sensor == 0 ? Segment::kUpperArm : Segment::kForearm;
      const std::vector<double>& p = trial.True(std::string(Name(segment)) + ".p_BS_m");
      const MovingPoint point = PointOn(arm[segment], {.p = {p[0], p[1], p[2]}});
      Attitude{state.Attitude(knot, sensor)} = q_WV * arm[segment].turning.q_AB;
      Vector{state.Velocity(knot, sensor)} = q_WV * point.v;
      Vector{state.Place(knot, sensor)} = q_WV * (point.p - p_start);
    }
  }
  return state;
}

TEST(WholeTrial, HasTheSameMinimumFromTheWindowsAsFromTheTruth) {
  const Scenario scenario = MakeScenario(BriskScenario(16));
  const SimulatedTrial trial = Simulate(scenario, {});
  Solved solved(trial.trial.observations);
  State from_truth = TrueState(solved.problem, scenario, trial, solved.windows);
  Solve(solved.problem, from_truth, {}, 0, solved.Last(), kToTheEnd);
  for (const int knot : {0, solved.Last() / 3, 2 * solved.Last() / 3, solved.Last()})
    EXPECT_LT(LargestShareOfSd(solved.problem, solved.whole, from_truth, knot), 1e-3) << knot;
}

TEST(StartHeadings, LeadToTheSameMinimumWhateverTheFirstGuess) {
  Observations observations = Brisk(16).observations;
  observations.start_pose.reset();
  std::optional<State> first;
  for (const double turn : {0.0, 1.9, -1.3, std::numbers::pi}) {
    ArmProblem problem(observations, {}, 0.05);
    State state = problem.PriorState();
    SetFirstKnot(problem, state);
    problem.FixHeadings(state);
    TurnFirstKnot(state, 1, turn);
    WindowReport report;
    ChooseStartHeadings(problem, state, {}, report);
    EXPECT_GE(report.settling_span, 5.0);
    const int settled = problem.timeline().KnotBefore(report.settling_span - 0.01);
    DeadReckon(problem, state, settled, problem.timeline().Intervals());
    Solve(problem, state, {}, 0, problem.timeline().Intervals(), kToTheEnd);
    if (!first) first = state;
    for (const int knot : {0, problem.timeline().Intervals() / 2})
      EXPECT_LT(LargestShareOfSd(problem, *first, state, knot), 1e-3) << turn;
  }
}

TEST(StartHeadings, AreNotTriedWhereTheStartPoseSettlesThem) {
  Observations observations = Brisk(16).observations;
  for (const bool told : {true, false}) {
    if (!told) observations.start_pose.reset();
    ArmProblem problem(observations, {}, 0.1);
    State state = problem.PriorState();
    SetFirstKnot(problem, state);
    problem.FixHeadings(state);
    WindowReport report;
    ChooseStartHeadings(problem, state, {}, report);
    EXPECT_EQ(report.iterations == 0, told);
  }
}

}  // namespace
}  // namespace brachium
