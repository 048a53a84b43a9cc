#include "solver/elimination.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "solver/initial_guess.h"
#include "tests/support/dense_information.h"
#include "tests/support/simulated_trial.h"

namespace brachium {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

// A stretch of movement that is small enough for dense matrices, dead reckoned. Its gyroscopes are
// so poor that the information is conditioned well enough to be compared to nine digits and more.
struct Stretch {
  ArmProblem problem;
  State state;
  ChainWorkspace workspace{problem};

  Stretch() : problem(CutTrial(), {.bias_node_spacing_s = 0.3}, 0.1), state(problem.PriorState()) {
    SetFirstKnot(problem, state);
    problem.FixHeadings(state);
    DeadReckon(problem, state, 0, problem.timeline().Intervals());
  }

  // No velocities, and all sensors at the root: what is told in world axes vanishes, and so does not
  // change as the world turns.
  void Halt() {
    for (int sensor = 0; sensor < problem.size().sensors; ++sensor) {
      for (int knot = 0; knot < problem.size().knots; ++knot) {
        std::fill_n(state.Velocity(knot, sensor), 3, 0.0);
        std::fill_n(state.Place(knot, sensor), 3, 0.0);
      }
      for (const UnknownKind lever : {UnknownKind::kSensorPosition, UnknownKind::kJointVector})
        std::fill_n(state.Constant(lever, sensor), 3, 0.0);
    }
    for (int contact = 0; contact < problem.size().contacts; ++contact)
      std::fill_n(state.Constant(UnknownKind::kContactPlace, contact), 3, 0.0);
  }

  Elimination Eliminated(const CarriedPrior& prior, int start, int end) {
    return Elimination(problem, state, prior, start, end, workspace);
  }

 private:
  static Observations CutTrial() {
    Observations observations = Brisk(16).observations;
    for (Recording& recording : observations.recordings) {
      recording = Cut(recording, 6.9, 8.1);
      recording.noise.gyro_density *= 30.0;
      recording.noise.gyro_bias_walk = 0.3 * kDegree;
    }
    observations.start_pose.reset();
    // Before, within and after the first steps: a place waits for them, a length outlasts them.
    observations.contacts = {
        {.place = "cup", .segment = Segment::kForearm, .times = {7.1, 7.3, 7.8}, .sigma = 0.1},
        {.place = "desk", .segment = Segment::kUpperArm, .times = {7.2, 7.5}, .height_only = true}};
    return observations;
  }
};

// What terms of knots in [0, end) say about the unknowns that stay, by one dense Schur complement.
struct DenseMarginal {
  MatrixXd H;
  VectorXd g;

  DenseMarginal(Stretch& stretch, int end, const std::vector<int>& kept) {
    DenseInformation all(stretch.problem);
    all.AddTerms(stretch.problem, stretch.state, 0, end);
    const std::vector<int> K = all.RowsOf(stretch.problem, kept);
    const std::set<int> stays(K.begin(), K.end());
    std::vector<int> E;
    for (int row = 0; row < all.H.rows(); ++row)
      if (all.H(row, row) > 0.0 && !stays.contains(row)) E.push_back(row);
    const MatrixXd solved = SolvedInLongDouble(
        all.H(E, E), (MatrixXd(E.size(), K.size() + 1) << all.H(E, K), all.g(E)).finished());
    const auto columns = static_cast<Eigen::Index>(K.size());
    H = all.H(K, K) - all.H(K, E) * solved.leftCols(columns);
    g = all.g(K) - all.H(K, E) * solved.col(columns);
  }
};

// H and g of a carried prior alone, over its own unknowns.
DenseInformation InformationOf(const CarriedPrior& prior, Stretch& stretch) {
  DenseInformation information(stretch.problem);
  information.Add(*prior.cost, prior.unknowns, stretch.problem, stretch.state);
  return information;
}

double LargestScaled(const MatrixXd& difference, const VectorXd& diagonal) {
  const VectorXd scale = diagonal.cwiseSqrt().cwiseInverse();
  return (scale.asDiagonal() * difference * scale.asDiagonal()).cwiseAbs().maxCoeff();
}

TEST(Elimination, CarriesOnWhatTheSchurComplementOfAllThatLeftSays) {
  Stretch stretch;
  const CarriedPrior prior = stretch.Eliminated({}, 0, 6).Carry();
  const DenseMarginal expected(stretch, 6, prior.unknowns);
  const DenseInformation carried = InformationOf(prior, stretch);
  const std::vector<int> K = carried.RowsOf(stretch.problem, prior.unknowns);
  EXPECT_LT(LargestScaled(carried.H(K, K) - expected.H, expected.H.diagonal()), 1e-9);
  const VectorXd unit = expected.H.diagonal().cwiseSqrt();
  const VectorXd g = expected.g.cwiseQuotient(unit), g_carried = carried.g(K).cwiseQuotient(unit);
  EXPECT_LT((g_carried - g).cwiseAbs().maxCoeff(), 1e-9 * g.cwiseAbs().maxCoeff());
}

TEST(Elimination, KeepsOnlyWhatLaterTermsTouch) {
  Stretch stretch;
  const CarriedPrior prior = stretch.Eliminated({}, 0, 6).Carry();
  const std::vector<int>& nodes = stretch.problem.timeline().nodes;
  for (const int unknown : prior.unknowns) {
    const Unknown u = stretch.problem.Describe(unknown);
    if (u.place < 0) continue;
    if (u.kind == UnknownKind::kGyroBias)
      EXPECT_GT(nodes[std::min(static_cast<std::size_t>(u.place) + 1, nodes.size() - 1)], 6);
    else
      EXPECT_EQ(u.place, 6);
  }
  for (int sensor = 0; sensor < 2; ++sensor)
    EXPECT_EQ(std::count(prior.unknowns.begin(), prior.unknowns.end(),
                         stretch.problem.Attitude(6, sensor)),
              1);
}

TEST(Elimination, InTwoStepsGivesTheStepOfSolvingAllAtOnce) {
  Stretch stretch;
  const ArmProblem& problem = stretch.problem;
  const int end = problem.size().knots;
  DenseInformation all(problem), rest(problem);
  all.AddTerms(problem, stretch.state, 0, end);
  CarriedPrior prior = stretch.Eliminated({}, 0, 3).Carry();
  prior = stretch.Eliminated(prior, 3, 7).Carry();
  rest.Add(*prior.cost, prior.unknowns, problem, stretch.state);
  rest.AddTerms(problem, stretch.state, 7, end);

  std::vector<int> rows, K;
  for (int row = 0; row < all.H.rows(); ++row) {
    if (all.H(row, row) > 0.0) rows.push_back(row);
    if (rest.H(row, row) > 0.0) K.push_back(row);
  }
  ASSERT_LT(K.size(), rows.size());
  const auto step = [](const DenseInformation& information, const std::vector<int>& of) {
    VectorXd dx = VectorXd::Zero(information.g.size());
    dx(of) = SolvedInLongDouble(information.H(of, of), information.g(of));
    return dx;
  };
  const VectorXd expected = step(all, rows), found = step(rest, K);
  const auto n = static_cast<Eigen::Index>(K.size());
  const VectorXd sd =
      SolvedInLongDouble(rest.H(K, K), MatrixXd::Identity(n, n)).diagonal().cwiseSqrt();
  const VectorXd error = (found(K) - expected(K)).cwiseQuotient(sd);
  const VectorXd size = VectorXd(expected(K)).cwiseQuotient(sd);
  EXPECT_LT(error.cwiseAbs().maxCoeff(), 1e-9 * size.cwiseAbs().maxCoeff());
}

// d/dψ of all attitudes as the world turns by ψ about the vertical.
VectorXd HeadingDirection(Stretch& stretch, const std::vector<int>& unknowns) {
  DenseInformation layout(stretch.problem);
  VectorXd d = VectorXd::Zero(layout.g.size());
  for (const int unknown : unknowns)
    if (stretch.problem.Describe(unknown).kind == UnknownKind::kAttitude)
      d.segment<3>(layout.OffsetOf(unknown)) =
          Eigen::Map<const Eigen::Quaterniond>(stretch.problem.Value(stretch.state, unknown))
              .conjugate() *
          Eigen::Vector3d::UnitZ();
  return d;
}

double HeadingInformation(Stretch& stretch, int end) {
  const CarriedPrior prior = stretch.Eliminated({}, 0, end).Carry();
  const VectorXd d = HeadingDirection(stretch, prior.unknowns);
  return d.dot(InformationOf(prior, stretch).H * d);
}

// The gauge's σ and the spread V that the gyroscopes add on the way leave 1 / (σ² + V), where V is
// the variance of the first heading with the gauge left out and everything that stays held still.
TEST(Elimination, CarriesOnOfTheHeadingOnlyTheShareOfTheGauge) {
  Stretch stretch;
  stretch.Halt();
  constexpr int kEnd = 6;
  const CarriedPrior prior = stretch.Eliminated({}, 0, kEnd).Carry();
  DenseInformation without(stretch.problem);
  for (const Term& term : stretch.problem.terms())
    if (term.first_knot < kEnd && !(term.kind == ResidualKind::kHeadingGauge))
      without.Add(*term.cost, term.unknowns, stretch.problem, stretch.state);
  const std::vector<int> K = without.RowsOf(stretch.problem, prior.unknowns);
  const std::set<int> stays(K.begin(), K.end());
  std::vector<int> E;
  for (int row = 0; row < without.H.rows(); ++row)
    if (without.H(row, row) > 0.0 && !stays.contains(row)) E.push_back(row);
  const VectorXd up = HeadingDirection(stretch, {stretch.problem.Attitude(0, 0)})(E);
  const double V = up.dot(SolvedInLongDouble(without.H(E, E), up).col(0));
  const double share = 1.0 / (1e-6 + V);
  EXPECT_LT(share, 1e6);
  EXPECT_NEAR(HeadingInformation(stretch, kEnd) / share, 1.0, 1e-9);
}

// d/dψ of all unknowns, in world axes, as the whole arm turns with the places that it touches.
VectorXd TurnOfTheWhole(Stretch& stretch) {
  std::vector<int> all;
  for (int unknown = 0; unknown < stretch.problem.unknowns(); ++unknown) all.push_back(unknown);
  VectorXd d = HeadingDirection(stretch, all);
  DenseInformation layout(stretch.problem);
  const std::set<UnknownKind> in_world = {UnknownKind::kRoot, UnknownKind::kVelocity,
                                          UnknownKind::kPlace, UnknownKind::kShoulderMean,
                                          UnknownKind::kContactPlace};
  for (const int unknown : all)
    if (in_world.contains(stretch.problem.Describe(unknown).kind))
      d.segment<3>(layout.OffsetOf(unknown)) = Eigen::Vector3d::UnitZ().cross(
          Eigen::Map<const Eigen::Vector3d>(stretch.problem.Value(stretch.state, unknown)));
  return d;
}

TEST(Information, OfATurnOfTheWholeArmIsThatOfTheGaugeThoughItTouches) {
  Stretch stretch;
  stretch.state.Constant(UnknownKind::kContactPlace, 0)[1] += 0.2;  // nor does it as it misses
  DenseInformation all(stretch.problem), contacts(stretch.problem);
  all.AddTerms(stretch.problem, stretch.state, 0, stretch.problem.size().knots);
  for (const Term& term : stretch.problem.terms())
    if (term.kind == ResidualKind::kContact)
      contacts.Add(*term.cost, term.unknowns, stretch.problem, stretch.state);
  const VectorXd turn = TurnOfTheWhole(stretch);
  EXPECT_GT(contacts.H.norm(), 100.0);
  EXPECT_LT(turn.dot(contacts.H * turn), 1e-9);
  EXPECT_NEAR(turn.dot(all.H * turn) / 1e6, 1.0, 1e-9);
}

TEST(Elimination, CarriesOnNothingOfTheHeadingWithoutAGauge) {
  Stretch stretch;
  stretch.Halt();
  const double with = HeadingInformation(stretch, 6);
  stretch.problem = ArmProblem(stretch.problem.observations(), stretch.problem.options(), 0.1);
  EXPECT_NEAR(HeadingInformation(stretch, 6) / with, 0.0, 1e-9);
}

TEST(Elimination, VisitsTheCovariancesOfTheDenseInverse) {
  Stretch stretch;
  const int knots = stretch.problem.size().knots;
  DenseInformation all(stretch.problem);
  all.AddTerms(stretch.problem, stretch.state, 0, knots);
  std::vector<int> rows;
  for (int row = 0; row < all.H.rows(); ++row)
    if (all.H(row, row) > 0.0) rows.push_back(row);
  const auto n = static_cast<Eigen::Index>(rows.size());
  MatrixXd expected = MatrixXd::Zero(all.H.rows(), all.H.rows());
  expected(rows, rows) = SolvedInLongDouble(all.H(rows, rows), MatrixXd::Identity(n, n));

  const Elimination elimination = stretch.Eliminated({}, 0, knots);
  EXPECT_TRUE(elimination.singular().empty());
  int visited = 0;
  std::set<int> seen;
  elimination.VisitCovariances(
      [&](int knot, const BlockIndex& index, const CovarianceView& covariance) {
        EXPECT_EQ(knot, knots - 1 - visited++);
        seen.insert(index.unknowns.begin(), index.unknowns.end());
        const std::vector<int> of = all.RowsOf(stretch.problem, index.unknowns);
        const MatrixXd dense = expected(of, of);
        EXPECT_LT(LargestScaled(covariance - dense, dense.diagonal()), 1e-9) << "knot " << knot;
      });
  EXPECT_EQ(visited, knots);
  for (int unknown = 0; unknown < stretch.problem.unknowns(); ++unknown)
    EXPECT_NE(seen.contains(unknown), stretch.problem.Describe(unknown).held) << unknown;
}

TEST(Elimination, NamesTheUnknownsThatNothingDetermines) {
  Stretch stretch;
  stretch.problem = ArmProblem(stretch.problem.observations(), stretch.problem.options(), 0.1);
  const std::vector<int> singular =
      stretch.Eliminated({}, 0, stretch.problem.size().knots).singular();
  EXPECT_TRUE(std::any_of(singular.begin(), singular.end(), [&](int unknown) {
    return stretch.problem.Describe(unknown).kind == UnknownKind::kAttitude;
  }));
}

TEST(BlockIndex, KnowsWhichUnknownsItHolds) {
  const BlockIndex index{.unknowns = {4, 9}, .offset = {0, 3}, .dimension = 6};
  EXPECT_EQ(index.OffsetOf(9), 3);
  EXPECT_EQ(index.OffsetOf(5), -1);
}

// ξ = L⁻ᵀ z: over all unit vectors z, the ξ ξᵀ add up to the covariance. L is kept in single precision.
TEST(FrontSweep, DrawsDeviationsOfTheCovariance) {
  Stretch stretch;
  const int knots = stretch.problem.size().knots;
  FrontPlan& plan = stretch.workspace.plan;
  plan.Build(stretch.problem, stretch.state, {}, {.end_knot = knots, .last_knot = knots});
  stretch.workspace.sweep.Prepare(plan);
  stretch.workspace.sweep.Run(plan, 0.0);
  MatrixXd draws(plan.columns(), plan.columns());
  const auto columns = static_cast<std::size_t>(plan.columns());
  std::vector<std::vector<double>> signs(columns, std::vector<double>(columns, 0.0)), deviations;
  for (std::size_t column = 0; column < columns; ++column) signs[column][column] = 1.0;
  stretch.workspace.sweep.Draw(plan, signs, deviations);
  for (int column = 0; column < plan.columns(); ++column)
    draws.col(column) = Eigen::Map<const VectorXd>(
        deviations[static_cast<std::size_t>(column)].data(), plan.columns());
  const VectorXd sd = (draws * draws.transpose()).diagonal().cwiseSqrt();
  DenseInformation all(stretch.problem);
  all.AddTerms(stretch.problem, stretch.state, 0, knots);
  const MatrixXd dense = SolvedInLongDouble(all.H, MatrixXd::Identity(all.H.rows(), all.H.cols()));
  for (const FrontPlan::Variable& variable : plan.variables())
    for (int i = 0; i < variable.tangent; ++i) {
      const auto row = all.OffsetOf(variable.unknown) + i;
      EXPECT_NEAR(sd[variable.column + i] / std::sqrt(dense(row, row)), 1.0, 1e-6);
    }
}

}  // namespace
}  // namespace brachium
