#include "solver/chain_solver.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "io/trial_folder.h"
#include "solver/elimination.h"
#include "solver/initial_guess.h"
#include "solver/window.h"
#include "tests/support/longer_chain.h"
#include "tests/support/simulated_trial.h"

namespace brachium {
namespace {

namespace fs = std::filesystem;

using Eigen::MatrixXd, Eigen::VectorXd;

constexpr SolveOptions kByChain{.most_iterations = 100, .step_in_sd = 3e-5};
constexpr SolveOptions kByCeres{
    .solver = SolverKind::kCeres, .most_iterations = 100, .step_in_sd = 3e-5};

// The largest difference of two states, number by number, as a share of its sd at the first.
double LargestShareOfSd(const ArmProblem& problem, State& state, State& other) {
  ChainWorkspace workspace(problem);
  const Elimination elimination(problem, state, {}, 0, problem.size().knots, workspace);
  double share = 0.0;
  elimination.VisitCovariances([&](int, const BlockIndex& index, const CovarianceView& covariance) {
    for (std::size_t i = 0; i < index.unknowns.size(); ++i) {
      const Unknown u = problem.Describe(index.unknowns[i]);
      const double* a = problem.Value(state, index.unknowns[i]);
      const double* b = problem.Value(other, index.unknowns[i]);
      VectorXd difference(u.Tangent());
      if (u.kind == UnknownKind::kAttitude)
        RotationManifold().Minus(b, a, difference.data());
      else
        for (int k = 0; k < u.Tangent(); ++k) difference[k] = b[k] - a[k];
      const VectorXd sd = covariance.diagonal().segment(index.offset[i], u.Tangent()).cwiseSqrt();
      share = std::max(share, difference.cwiseQuotient(sd).cwiseAbs().maxCoeff());
    }
  });
  return share;
}

// A trial whose windows have been solved: where the search over the whole begins.
struct Started {
  ArmProblem problem;
  State state;

  explicit Started(const Observations& observations, double knot_spacing = 0.1)
      : problem(observations, {}, knot_spacing), state(problem.PriorState()) {
    SolveForward(problem, state, {.only_a_start = true}, {});
  }
  int Last() const { return problem.timeline().Intervals(); }

  void ExpectTheSameMinimumByBothSolvers() {
    State by_chain = state, by_ceres = state;
    const SolveSummary chain = Solve(problem, by_chain, {}, 0, Last(), kByChain);
    const SolveSummary ceres = Solve(problem, by_ceres, {}, 0, Last(), kByCeres);
    EXPECT_TRUE(chain.converged) << chain.message;
    EXPECT_TRUE(ceres.converged) << ceres.message;
    EXPECT_NEAR(chain.initial_cost / ceres.initial_cost, 1.0, 1e-12);
    EXPECT_NEAR(chain.final_cost / ceres.final_cost, 1.0, 1e-9);
    EXPECT_LT(LargestShareOfSd(problem, by_chain, by_ceres), 1e-3);
  }
};

struct Simulated {
  std::string scenario;
  SimulationOptions options;
};

class BothSolvers : public testing::TestWithParam<Simulated> {};

TEST_P(BothSolvers, ReachTheSameMinimum) {
  const Scenario scenario =
      MakeScenario({.name = GetParam().scenario, .seed = 5, .duration = 16.0});
  Started(Simulate(scenario, GetParam().options).trial.observations)
      .ExpectTheSameMinimumByBothSolvers();
}

SimulationOptions OnSkin() {
  SimulationOptions options;
  options.soft_tissue = TypicalSoftTissue();
  return options;
}

INSTANTIATE_TEST_SUITE_P(Simulated, BothSolvers,
                         testing::Values(Simulated{"daily_brisk", {}}, Simulated{"daily_slow", {}},
                                         Simulated{"daily_brisk", OnSkin()},
                                         Simulated{"daily_brisk", NoErrors()}));

TEST(BothSolvers, ReachTheSameMinimumOfOneSensor) {
  Trial trial = Brisk(16);
  trial.observations.recordings.erase(trial.observations.recordings.begin());
  trial.observations.recordings[0].mounting.reset();
  Started(trial.observations).ExpectTheSameMinimumByBothSolvers();
}

TEST(BothSolvers, ReachTheSameMinimumOfALongerChain) {
  const Scenario scenario = MakeScenario(BriskScenario(16));
  Trial trial = Simulate(scenario, {}).trial;
  AddHand(scenario, trial);
  Started(trial.observations).ExpectTheSameMinimumByBothSolvers();
}

TEST(BothSolvers, ReachTheSameMinimumWithPosesAtBothEndsAndContacts) {
  ScenarioOptions options{.name = "nine_hole_peg_test", .seed = 5};
  options.duration = UsualDuration(options);
  SimulationOptions errors;
  errors.tell_end_pose = errors.tell_contacts = true;
  Started(Simulate(MakeScenario(options), errors).trial.observations)
      .ExpectTheSameMinimumByBothSolvers();
}

class BothSolversOnARig : public testing::TestWithParam<std::string> {};

TEST_P(BothSolversOnARig, ReachTheSameMinimum) {
  const fs::path folder = fs::path(BRACHIUM_SOURCE_DIR) / "../shared/data/trials" / GetParam();
  if (!fs::is_directory(folder)) GTEST_SKIP() << "no recordings at hand";
  Started(ReadTrial(folder.string()).trial.observations, 0.05).ExpectTheSameMinimumByBothSolvers();
}

INSTANTIATE_TEST_SUITE_P(, BothSolversOnARig,
                         testing::Values("diodem_trial1_rigid_seg1_seg2", "jhu_test01_upper_middle",
                                         "foot_dead_reckoning"),
                         [](const auto& name) { return name.param; });

// A short stretch, dead reckoned from a first guess whose forearm is turned about the vertical.
struct Turned {
  ArmProblem problem;
  State state;

  explicit Turned(double heading) : problem(CutTrial(), {}, 0.1), state(problem.PriorState()) {
    SetFirstKnot(problem, state);
    problem.FixHeadings(state);
    TurnFirstKnot(state, 1, heading);
    DeadReckon(problem, state, 0, Last());
  }
  int Last() const { return problem.timeline().Intervals(); }

  // To attitudes from which full steps lead nowhere.
  void ThrowForearmAbout(double about) {
    for (int knot = 0; knot < problem.size().knots; ++knot) {
      Eigen::Map<Eigen::Quaterniond> q(state.Attitude(knot, 1));
      q = q * Exp<double>(Eigen::Vector3d(about * std::sin(knot), about * std::cos(2 * knot), 0.0));
    }
  }

  double Cost(State& at) const {
    double cost = 0.0;
    for (const Term& term : problem.terms()) {
      std::vector<const double*> x;
      for (const int unknown : term.unknowns) x.push_back(problem.Value(at, unknown));
      VectorXd r(term.cost->num_residuals());
      term.cost->Evaluate(x.data(), r.data(), nullptr);
      double rho[3] = {r.squaredNorm(), 1.0, 0.0};
      if (term.loss != nullptr) term.loss->Evaluate(r.squaredNorm(), rho);
      cost += 0.5 * rho[0];
    }
    return cost;
  }

 private:
  static Observations CutTrial() {
    Observations observations = Brisk(16).observations;
    for (Recording& recording : observations.recordings) recording = Cut(recording, 0.0, 6.0);
    observations.start_pose.reset();
    return observations;
  }
};

TEST(ChainSolver, NeverRaisesTheCostAndLeavesTheStateWhoseCostItTells) {
  bool refused = false;
  for (const double about : {2.0, 5.0, 8.0, 20.0}) {
    Turned start(0.0);
    start.ThrowForearmAbout(about);
    double before = start.Cost(start.state);
    for (int most = 0; most < 15; ++most) {
      State state = start.state;
      const SolveSummary summary = Solve(start.problem, state, {}, 0, start.Last(),
                                         {.most_iterations = most, .step_in_sd = 1e-6});
      EXPECT_NEAR(summary.final_cost / start.Cost(state), 1.0, 1e-9) << most;
      EXPECT_LE(summary.iterations, most);
      EXPECT_LE(summary.final_cost, before * (1 + 1e-12)) << most;
      refused = refused || (most > 0 && !summary.converged && summary.final_cost == before);
      before = summary.final_cost;
    }
  }
  EXPECT_TRUE(refused);  // so a step was taken back on the way
}

TEST(ChainSolver, SaysThatItStoppedBeforeTheMinimum) {
  Turned start(0.3);
  const SolveSummary summary =
      Solve(start.problem, start.state, {}, 0, start.Last(), {.most_iterations = 1});
  EXPECT_FALSE(summary.converged);
  EXPECT_EQ(summary.iterations, 1);
}

TEST(ChainSolver, RefusesAStartWithoutAFiniteCost) {
  Turned start(0.0);
  start.state.Velocity(3, 0)[1] = std::nan("");
  const SolveSummary summary = Solve(start.problem, start.state, {}, 0, start.Last(), {});
  EXPECT_FALSE(summary.converged);
  EXPECT_EQ(summary.iterations, 0);
}

TEST(ChainSolver, GivesTheSameBitsInUsedMemory) {
  Turned start(0.3);
  ChainWorkspace workspace(start.problem);
  State first = start.state, second = start.state;
  Solve(start.problem, first, {}, 0, start.Last(), {});
  Solve(start.problem, start.state, {}, 5, 20, {}, &workspace);
  Solve(start.problem, second, {}, 0, start.Last(), {}, &workspace);
  for (int unknown = 0; unknown < start.problem.unknowns(); ++unknown)
    for (int i = 0; i < start.problem.Describe(unknown).Size(); ++i)
      EXPECT_EQ(start.problem.Value(first, unknown)[i], start.problem.Value(second, unknown)[i]);
}

TEST(Loss, BoundsWhatATermSaysAlikeInBothSolvers) {
  double believed = HUGE_VAL;
  for (const bool bounded : {false, true}) {
    Turned start(0.0);
    Term& term = const_cast<Term&>(*std::find_if(
        start.problem.terms().begin(), start.problem.terms().end(), [](const Term& other) {
          return other.kind == ResidualKind::kAccelerometer && other.first_knot == 40;
        }));
    if (bounded) term.loss = std::make_shared<ceres::CauchyLoss>(0.01);
    State by_chain = start.state, by_ceres = start.state;
    const SolveSummary chain = Solve(start.problem, by_chain, {}, 0, start.Last(), kByChain);
    const SolveSummary ceres = Solve(start.problem, by_ceres, {}, 0, start.Last(), kByCeres);
    EXPECT_TRUE(chain.converged) << chain.message;
    EXPECT_NEAR(chain.initial_cost / ceres.initial_cost, 1.0, 1e-12);
    EXPECT_NEAR(chain.final_cost / start.Cost(by_chain), 1.0, 1e-9);
    EXPECT_LT(LargestShareOfSd(start.problem, by_chain, by_ceres), 1e-3);
    EXPECT_LT(chain.final_cost, believed);
    believed = chain.final_cost;
  }
}

}  // namespace
}  // namespace brachium
