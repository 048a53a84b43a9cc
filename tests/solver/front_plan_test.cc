#include "solver/front_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/support/simulated_trial.h"

namespace brachium {
namespace {

std::size_t U(int i) { return static_cast<std::size_t>(i); }

struct Planned {
  ArmProblem problem;
  State state;
  FrontPlan plan;

  explicit Planned(const TermRange& range)
      : problem(CutTrial(), {.bias_node_spacing_s = 0.4}, 0.1),
        state(problem.PriorState()),
        plan(problem) {
    plan.Build(problem, state, {}, range);
  }

 private:
  static Observations CutTrial() {
    Observations observations = Brisk(16).observations;
    for (Recording& recording : observations.recordings) recording = Cut(recording, 0.0, 4.0);
    return observations;
  }
};

constexpr TermRange kWhole{.end_knot = 1000, .last_knot = 1000};

TEST(FrontPlan, EliminatesEveryUnknownOnceAndInOrder) {
  const Planned planned(kWhole);
  int column = 0;
  for (const FrontPlan::Front& front : planned.plan.fronts()) {
    EXPECT_EQ(front.first_column, column);
    column += front.eliminated;
  }
  EXPECT_EQ(column, planned.plan.columns());
  EXPECT_EQ(planned.plan.variables().size(), U(planned.problem.unknowns()));
}

TEST(FrontPlan, PlacesEveryBlockWhereItsUnknownStandsInTheFront) {
  const Planned planned(kWhole);
  const FrontPlan& plan = planned.plan;
  std::size_t terms = 0;
  for (const FrontPlan::Front& front : plan.fronts())
    for (const FrontPlan::PlannedTerm& planned_term : plan.Terms(front)) {
      const Term& term = planned.problem.terms()[terms++];
      const auto blocks = plan.Blocks(planned_term);
      ASSERT_EQ(blocks.size(), term.unknowns.size());
      EXPECT_EQ(front.knot, term.first_knot);
      for (std::size_t i = 0; i < blocks.size(); ++i) {
        EXPECT_EQ(plan.variables()[U(blocks[i].variable)].unknown, term.unknowns[i]);
        if (planned.problem.Describe(term.unknowns[i]).held) continue;
        const auto members = plan.Members(front);
        EXPECT_TRUE(std::any_of(members.begin(), members.end(), [&](const auto& member) {
          return member.variable == blocks[i].variable && member.column == blocks[i].column;
        }));
        for (const TermBlock& other : blocks) {
          if (other.place < 0) continue;
          EXPECT_EQ(other.place < blocks[i].place, other.column < blocks[i].column);
        }
      }
    }
  EXPECT_EQ(terms, planned.problem.terms().size());
}

TEST(FrontPlan, TakesOverWhatTheLastFrontHandsOnWithItsOrderKept) {
  const Planned planned(kWhole);
  const auto& fronts = planned.plan.fronts();
  for (std::size_t i = 1; i < fronts.size(); ++i) {
    int from = fronts[i - 1].eliminated, to = 0;
    for (const FrontPlan::Run& run : planned.plan.Runs(fronts[i])) {
      EXPECT_EQ(run.from, from);
      EXPECT_GE(run.to, to);
      from = run.from + run.length;
      to = run.to + run.length;
    }
    EXPECT_EQ(from, fronts[i - 1].columns);
    EXPECT_LE(to, fronts[i].columns);
  }
}

TEST(FrontPlan, LeavesInPlaceOnlyWhatStandsThereInTheLastFrontAlready) {
  const Planned planned(kWhole);
  int staying = 0;
  for (const FrontPlan::Front& front : planned.plan.fronts()) {
    EXPECT_GE(front.first_staying, front.eliminated);
    if (front.first_staying == front.columns) continue;
    ++staying;
    EXPECT_EQ((&front - 1)->columns, front.columns);
    for (const FrontPlan::Run& run : planned.plan.Runs(front))
      EXPECT_TRUE(run.to < front.eliminated ||
                  (run.to == run.from && run.to == front.first_staying));
  }
  EXPECT_GT(staying, 20);  // of 40 fronts: no longer so where bias nodes come and go
}

TEST(FrontPlan, PutsLastWhatLaterTermsTouchAndNothingElse) {
  const Planned planned({.end_knot = 10, .last_knot = 1000, .hand_on = true});
  std::set<int> later;
  for (const Term& term : planned.problem.terms())
    if (term.first_knot >= 10) later.insert(term.unknowns.begin(), term.unknowns.end());
  const FrontPlan::Front& last = planned.plan.fronts().back();
  EXPECT_EQ(last.columns, last.eliminated);
  bool is_later = false;
  for (const FrontPlan::Member& member : planned.plan.Members(last)) {
    const bool was_later = is_later;
    const FrontPlan::Variable& variable = planned.plan.variables()[U(member.variable)];
    is_later = later.contains(variable.unknown);
    EXPECT_GE(is_later, was_later);
    EXPECT_EQ(U(variable.last_front) >= planned.plan.fronts().size(), is_later);
  }
  EXPECT_TRUE(is_later);
}

TEST(FrontPlan, LeavesOutTheStopsOfJointsWhenAskedTo) {
  const auto terms = [](const TermRange& range) {
    std::size_t sum = 0;
    const Planned planned(range);
    for (const FrontPlan::Front& front : planned.plan.fronts()) sum += front.terms;
    return sum;
  };
  TermRange without = kWhole;
  without.leave_stops = true;
  const auto stops = static_cast<std::size_t>(Planned(kWhole).problem.size().knots);
  EXPECT_EQ(terms(without) + stops, terms(kWhole));
}

TEST(FrontPlan, LeavesOutTermsThatReachBeyondTheLastKnot) {
  const Planned planned({.end_knot = 11, .last_knot = 10});
  for (const FrontPlan::Variable& variable : planned.plan.variables()) {
    const Unknown u = planned.problem.Describe(variable.unknown);
    EXPECT_TRUE(u.place <= 10 || u.kind == UnknownKind::kGyroBias);
  }
  EXPECT_EQ(planned.plan.fronts().back().columns, planned.plan.fronts().back().eliminated);
}

TEST(FrontPlan, GivesHeldGeometryNoColumns) {
  const Planned planned({.end_knot = 1000, .last_knot = 1000, .hold_geometry = true});
  std::set<UnknownKind> held;
  for (const FrontPlan::Variable& variable : planned.plan.variables())
    if (variable.tangent == 0) held.insert(planned.problem.Describe(variable.unknown).kind);
  EXPECT_EQ(held, (std::set<UnknownKind>{UnknownKind::kSkin, UnknownKind::kGyroScale,
                                         UnknownKind::kAccelScale, UnknownKind::kSensorPosition,
                                         UnknownKind::kJointVector, UnknownKind::kClockOffset,
                                         UnknownKind::kMounting}));
  for (const FrontPlan::Front& front : planned.plan.fronts())
    for (const FrontPlan::PlannedTerm& term : planned.plan.Terms(front))
      for (const TermBlock& block : planned.plan.Blocks(term))
        EXPECT_EQ(block.place < 0, planned.plan.variables()[U(block.variable)].tangent == 0);
}

TEST(FrontPlan, IsTheSameWhenMadeAgainInTheSameMemory) {
  Planned planned(kWhole);
  const std::size_t storage = planned.plan.storage(), fronts = planned.plan.fronts().size();
  planned.plan.Build(planned.problem, planned.state, {}, {.end_knot = 9, .last_knot = 9});
  EXPECT_LT(planned.plan.storage(), storage);
  planned.plan.Build(planned.problem, planned.state, {}, kWhole);
  EXPECT_EQ(planned.plan.storage(), storage);
  EXPECT_EQ(planned.plan.fronts().size(), fronts);
}

}  // namespace
}  // namespace brachium
