#include "problems/timeline.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/smooth_motion.h"

namespace brachium {
namespace {

// What a timeline asks of a recording is its instants.
Preintegrator At(const std::vector<double>& times) {
  Recording recording;
  recording.time = times;
  recording.gyr_S.assign(times.size(), Eigen::Vector3d::Zero());
  recording.acc_S = recording.gyr_S;
  return Preintegrator(recording);
}

bool IsEdge(const Preintegrator& recording, double time) {
  return std::find(recording.edges().begin(), recording.edges().end(), time) !=
         recording.edges().end();
}

TEST(Timeline, HasAKnotAtEveryCellEdgeWhenNoSpacingIsAsked) {
  const auto recording = At(EvenTimes(3.0, 0.01, 200));
  EXPECT_TRUE(std::ranges::equal(MakeTimeline({recording}, 0.0, 1.0).knots, recording.edges()));
}

TEST(Timeline, PutsItsKnotsOnCellEdgesAtLeastTheSpacingApart) {
  const double spacing = 0.1, period = 0.016;  // the spacing is no multiple of the period
  const auto recording = At(EvenTimes(3.0, period, 500));
  const auto knots = MakeTimeline({recording}, spacing, 1.0).knots;
  for (std::size_t i = 0; i < knots.size(); ++i) {
    EXPECT_TRUE(IsEdge(recording, knots[i]));
    if (i == 0 || i + 1 == knots.size()) continue;
    EXPECT_GE(knots[i] - knots[i - 1], spacing * (1 - 1e-5));
    EXPECT_LT(knots[i] - knots[i - 1], spacing + period);
  }
  EXPECT_EQ(knots.front(), recording.Begin());
  EXPECT_EQ(knots.back(), recording.End());
}

TEST(Timeline, DoesNotLoseAKnotToRounding) {
  const auto knots = MakeTimeline({At(EvenTimes(0.1, 0.01, 1000))}, 0.05, 1.0).knots;
  EXPECT_EQ(knots.size(), 201u);
}

TEST(Timeline, CoversWhatAllRecordingsShareOnTheEdgesOfTheFirst) {
  const auto first = At(EvenTimes(0.0, 0.01, 300)), second = At(EvenTimes(0.123, 0.013, 200));
  const auto knots = MakeTimeline({first, second}, 0.05, 1.0).knots;
  EXPECT_EQ(knots.front(), second.Begin());
  EXPECT_EQ(knots.back(), second.End());
  for (std::size_t i = 1; i + 1 < knots.size(); ++i) EXPECT_TRUE(IsEdge(first, knots[i]));
}

TEST(Timeline, LeavesNoSliverOfAnIntervalAtTheEnds) {
  const auto first = At(EvenTimes(0.0, 0.01, 300));
  for (const double start : {0.1, 0.1001, 0.1049, 0.1051, 0.1099})
    for (const double spacing : {0.0, 0.05}) {
      const auto knots = MakeTimeline({first, At(EvenTimes(start, 0.01, 100))}, spacing, 1.0).knots;
      for (std::size_t i = 1; i < knots.size(); ++i) EXPECT_GT(knots[i] - knots[i - 1], 0.0049);
    }
}

TEST(Timeline, PutsBiasNodesOnKnotsFromTheFirstToTheLast) {
  const double spacing = 2.0;
  const auto timeline = MakeTimeline({At(EvenTimes(0.0, 0.01, 1130))}, 0.05, spacing);
  EXPECT_EQ(timeline.nodes.front(), 0);
  EXPECT_EQ(timeline.nodes.back(), timeline.Intervals());
  for (int node = 0; node + 1 < static_cast<int>(timeline.nodes.size()); ++node) {
    const double length = timeline.NodeTime(node + 1) - timeline.NodeTime(node);
    EXPECT_GE(length, 0.5 * spacing);
    EXPECT_LE(length, 1.5 * spacing + 0.06);
  }
}

TEST(Timeline, HasTwoNodesHoweverShortItIs) {
  const auto timeline = MakeTimeline({At(EvenTimes(0.0, 0.01, 2))}, 0.1, 5.0);
  EXPECT_EQ(timeline.knots.size(), 2u);
  EXPECT_EQ(timeline.nodes, (std::vector<int>{0, 1}));
}

TEST(Timeline, FindsTheNodesAboutATime) {
  const Timeline timeline{.knots = {0.0, 1.0, 2.0, 3.0, 5.0}, .nodes = {0, 2, 4}};
  EXPECT_EQ(timeline.NodeBefore(0.0), 0);
  EXPECT_EQ(timeline.NodeBefore(1.99), 0);
  EXPECT_EQ(timeline.NodeBefore(2.0), 1);
  EXPECT_EQ(timeline.NodeBefore(5.0), 1);
  EXPECT_DOUBLE_EQ(timeline.NodeFraction(0.5), 0.25);
  EXPECT_DOUBLE_EQ(timeline.NodeFraction(2.0), 0.0);
  EXPECT_DOUBLE_EQ(timeline.NodeFraction(4.4), 0.8);
  EXPECT_DOUBLE_EQ(timeline.NodeFraction(5.0), 1.0);
  EXPECT_DOUBLE_EQ(timeline.NodeFraction(9.0), 1.0);
}

TEST(Timeline, FindsTheKnotBeforeATime) {
  const Timeline timeline{.knots = {0.0, 1.0, 2.0}, .nodes = {0, 2}};
  EXPECT_EQ(timeline.KnotBefore(-1.0), 0);
  EXPECT_EQ(timeline.KnotBefore(0.99), 0);
  EXPECT_EQ(timeline.KnotBefore(1.0), 1);
  EXPECT_EQ(timeline.KnotBefore(7.0), 2);
}

}  // namespace
}  // namespace brachium
