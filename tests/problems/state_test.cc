#include "problems/state.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>
#include <vector>

namespace brachium {
namespace {

constexpr StateSize kSize{.sensors = 3, .roots = 2, .knots = 4, .nodes = 2, .contacts = 2};

// Every block of a state: where it lies and how many numbers it holds.
std::vector<std::pair<double*, int>> Blocks(State& state) {
  std::vector<std::pair<double*, int>> blocks;
  const StateSize& size = state.size();
  for (int sensor = 0; sensor < size.sensors; ++sensor) {
    for (int knot = 0; knot < size.knots; ++knot) {
      blocks.push_back({state.Attitude(knot, sensor), 4});
      blocks.push_back({state.Velocity(knot, sensor), 3});
      blocks.push_back({state.Place(knot, sensor), 3});
      blocks.push_back({state.Skin(knot, sensor), 3});
    }
    for (int node = 0; node < size.nodes; ++node)
      blocks.push_back({state.GyroBias(node, sensor), 3});
    for (const auto kind :
         {UnknownKind::kGyroScale, UnknownKind::kAccelBias, UnknownKind::kAccelScale,
          UnknownKind::kSensorPosition, UnknownKind::kJointVector, UnknownKind::kMounting})
      blocks.push_back({state.Constant(kind, sensor), 3});
    blocks.push_back({state.Constant(UnknownKind::kClockOffset, sensor), 1});
  }
  for (int knot = 0; knot < size.knots; ++knot) {
    for (int root = 0; root < size.roots; ++root) blocks.push_back({state.Root(knot, root), 3});
    blocks.push_back({state.Adduction(knot), 1});
  }
  blocks.push_back({state.Constant(UnknownKind::kShoulderMean, -1), 3});
  blocks.push_back({state.Constant(UnknownKind::kCarryingAngle, -1), 2});
  for (int contact = 0; contact < size.contacts; ++contact)
    blocks.push_back({state.Constant(UnknownKind::kContactPlace, contact), 3});
  return blocks;
}

TEST(State, GivesEveryUnknownAPlaceOfItsOwnInOnePiece) {
  State state(kSize);
  std::set<double*> places;
  std::size_t numbers = 0;
  for (const auto& [block, size] : Blocks(state))
    for (int i = 0; i < size; ++i, ++numbers) places.insert(block + i);
  EXPECT_EQ(places.size(), numbers);
  EXPECT_EQ(*places.rbegin() - *places.begin(), static_cast<std::ptrdiff_t>(numbers) - 1);
}

TEST(State, StartsWithUnitAttitudesAndZeros) {
  State state(kSize);
  for (const auto& [block, size] : Blocks(state))
    for (int i = 0; i < size; ++i) EXPECT_EQ(block[i], size == 4 && i == 3 ? 1.0 : 0.0);
}

TEST(State, IsAValue) {
  State state(kSize);
  const State copy = state;
  state.Velocity(2, 1)[0] = 7.0;
  EXPECT_EQ(copy.Velocity(2, 1)[0], 0.0);
  EXPECT_EQ(std::as_const(state).Velocity(2, 1)[0], 7.0);
}

}  // namespace
}  // namespace brachium
