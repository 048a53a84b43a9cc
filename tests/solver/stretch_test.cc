#include "solver/stretch.h"

#include <gtest/gtest.h>

#include "solver/initial_guess.h"
#include "solver/window.h"
#include "tests/support/simulated_trial.h"

namespace brachium {
namespace {

// Sd of the second sensor's attitude about an axis at every knot from `start` on, before which `prior`
// speaks.
std::vector<double> AttitudeSds(const ArmProblem& problem, State& state, const CarriedPrior& prior,
                                int start) {
  ChainWorkspace workspace(problem);
  const int knots = problem.size().knots;
  workspace.Linearise(problem, state, prior,
                      {.start_knot = start, .end_knot = knots, .last_knot = knots - 1});
  std::vector<double> sds(static_cast<std::size_t>(knots - start));
  Elimination(workspace).VisitCovariances(
      [&](int knot, const BlockIndex& index, const CovarianceView& covariance) {
        if (const int at = index.OffsetOf(problem.Attitude(knot, 1)); at >= 0)
          sds[static_cast<std::size_t>(knot - start)] = std::sqrt(covariance(at, at));
      });
  return sds;
}

// Two problems about the same 16 s: one from its start, one that begins at a bias node of the other.
class Stretches : public testing::Test {
 protected:
  Stretches() : state_(problem_.PriorState()) {
    SolveForward(problem_, state_, {}, {});
    ChainWorkspace workspace(problem_);
    knot_ = problem_.timeline().nodes[1];
    prior_ = Elimination(problem_, state_, {}, 0, knot_, workspace).Carry();
    handover_ = HandOver(problem_, state_, prior_, knot_);
  }

  Observations observations_ = Brisk(16).observations;
  ArmProblem problem_{observations_, {}, 0.1};
  State state_;
  int knot_ = 0;
  CarriedPrior prior_;
  Handover handover_;
};

// Of more fronts than are taken again at a time for covariances, so poorly measured that nine digits of
// these are left.
class LongStretch : public testing::Test {
 protected:
  LongStretch() : problem_(Poor(Brisk(65).observations), {}, 0.1), state_(problem_.PriorState()) {
    SetFirstKnot(problem_, state_);
    problem_.FixHeadings(state_);
    DeadReckon(problem_, state_, 0, problem_.timeline().Intervals());
  }

  static Observations Poor(Observations observations) {
    for (Recording& recording : observations.recordings) {
      recording.noise.gyro_density *= 100.0;
      recording.noise.gyro_bias_walk *= 100.0;
      recording.noise.accel_density *= 100.0;
    }
    return observations;
  }

  std::vector<double> Residuals(const CarriedPrior& prior) {
    std::vector<const double*> values;
    for (const int unknown : prior.unknowns) values.push_back(problem_.Value(state_, unknown));
    std::vector<double> r(static_cast<std::size_t>(prior.cost->num_residuals()));
    prior.cost->Evaluate(values.data(), r.data(), nullptr);
    return r;
  }

  ArmProblem problem_;
  State state_;
};

TEST_F(LongStretch, IsAsCertainWhereverItsBatchesOfFrontsBegin) {
  ChainWorkspace workspace(problem_);
  const int knot = problem_.timeline().nodes[1], knots = problem_.size().knots;
  const CarriedPrior prior = Elimination(problem_, state_, {}, 0, knot, workspace).Carry();
  const std::vector<double> all = AttitudeSds(problem_, state_, {}, 0),
                            rest = AttitudeSds(problem_, state_, prior, knot);
  for (int i = 0; i < knots - knot; ++i) {
    const double one = all[static_cast<std::size_t>(knot + i)];
    EXPECT_NEAR(rest[static_cast<std::size_t>(i)] / one, 1.0, 1e-7) << knot + i;
  }
}

TEST_F(LongStretch, HandsTheSameOnAfterItsCovariancesWereVisited) {
  ChainWorkspace workspace(problem_);
  const Elimination elimination(problem_, state_, {}, 0, 600, workspace);
  const CarriedPrior before = elimination.Carry();
  elimination.VisitCovariances([](int, const BlockIndex&, const CovarianceView&) {});
  const CarriedPrior after = elimination.Carry();
  EXPECT_EQ(after.unknowns, before.unknowns);
  EXPECT_EQ(Residuals(after), Residuals(before));
}

TEST_F(Stretches, KnowAfterAHandoverWhatTheOneProblemKnows) {
  ArmProblem next(ToldBetween(observations_, &handover_, HUGE_VAL), {}, 0.1, std::nullopt,
                  {.start = handover_.time, .clock_offset = {}, .gyro_bias = {}});
  State state = next.PriorState();
  const CarriedPrior prior = TakeOver(handover_, next, state);
  ASSERT_EQ(next.size().knots, problem_.size().knots - knot_);
  for (int sensor = 0; sensor < 2; ++sensor)
    EXPECT_TRUE(std::equal(state.Attitude(0, sensor), state.Attitude(0, sensor) + 4,
                           state_.Attitude(knot_, sensor)));
  for (int knot = 0; knot < next.size().knots; ++knot) {
    for (int sensor = 0; sensor < 2; ++sensor) {
      std::copy_n(state_.Attitude(knot_ + knot, sensor), 4, state.Attitude(knot, sensor));
      std::copy_n(state_.Velocity(knot_ + knot, sensor), 3, state.Velocity(knot, sensor));
      std::copy_n(state_.Place(knot_ + knot, sensor), 3, state.Place(knot, sensor));
    }
    std::copy_n(state_.Root(knot_ + knot, 0), 3, state.Root(knot, 0));
    *state.Adduction(knot) = *state_.Adduction(knot_ + knot);
  }
  for (int node = 0; node < next.size().nodes; ++node)
    for (int sensor = 0; sensor < 2; ++sensor)
      std::copy_n(state_.GyroBias(node + 1, sensor), 3, state.GyroBias(node, sensor));
  const auto one = AttitudeSds(problem_, state_, prior_, knot_);
  const auto two = AttitudeSds(next, state, prior, 0);
  ASSERT_EQ(one.size(), two.size());
  for (std::size_t i = 0; i < one.size(); ++i) EXPECT_NEAR(two[i] / one[i], 1.0, 0.02) << i;
}

TEST_F(Stretches, HandOverOnlyWhatIsAtTheKnotOrConstant) {
  for (const Handover::Known& known : handover_.known) {
    const Unknown& u = known.unknown;
    const int expected = u.kind == UnknownKind::kGyroBias ? 1 : knot_;
    EXPECT_TRUE(u.place < 0 || u.place == expected) << static_cast<int>(u.kind);
  }
}

TEST_F(Stretches, TakeEachContactAndPoseOnce) {
  Observations told = observations_;
  const double time = handover_.time;
  told.contacts = {{.place = "table", .segment = Segment::kForearm, .times = {1.0, time, time + 2}},
                   {.place = "cup", .segment = Segment::kForearm, .times = {2.0}}};
  told.end_pose.emplace().time = 15.0;
  const Observations before = ToldBetween(told, nullptr, time - 0.01);
  const Observations after = ToldBetween(told, &handover_, HUGE_VAL);
  ASSERT_EQ(before.contacts.size(), 2u);
  EXPECT_EQ(before.contacts[0].times, std::vector<double>{1.0});
  EXPECT_TRUE(before.start_pose && !before.end_pose);
  ASSERT_EQ(after.contacts.size(), 1u);
  EXPECT_EQ(after.contacts[0].times, (std::vector<double>{time, time + 2}));
  EXPECT_TRUE(!after.start_pose && after.end_pose);
}

}  // namespace
}  // namespace brachium
