#include "io/plot/envelope.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace brachium {
namespace {

using testing::Contains, testing::ElementsAre, testing::Not;

TEST(Envelope, KeepsAllOfAShortSeries) {
  EXPECT_THAT(EnvelopeOf({3, 1, 2}, {3, 1, 2}, 6), ElementsAre(0, 1, 2));
  EXPECT_TRUE(EnvelopeOf({}, {}, 6).empty());
}

TEST(Envelope, KeepsEndsPeaksAndGapsOfALongOne) {
  std::vector<double> low(10000, 1.0), high(10000, 2.0);
  low[4321] = 0.5;
  high[7654] = 9.0;
  low[5000] = high[5000] = std::nan("");
  const auto kept = EnvelopeOf(low, high, 100);
  EXPECT_LE(kept.size(), 100u);
  for (const std::size_t index : {0, 4321, 5000, 7654, 9999}) EXPECT_THAT(kept, Contains(index));
  EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end()));
  EXPECT_EQ(At(kept, high).size(), kept.size());
}

}  // namespace
}  // namespace brachium
