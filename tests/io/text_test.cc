#include "io/text.h"

#include <gtest/gtest.h>

#include <array>

namespace brachium {
namespace {

constexpr std::array<std::string_view, 4> kKnown = {"length_m", "length_sigma_m", "side", "file"};

TEST(Text, SpellsNumbersAsShortAsTheyReadBack) {
  EXPECT_EQ(Shortest(0.1), "0.1");
  EXPECT_EQ(Shortest(-3.0), "-3");
  EXPECT_EQ(Fixed(2.0 / 3.0, 2), "0.67");
}

TEST(Text, FindsTheNameThatWasMeant) {
  EXPECT_EQ(NearestName("lenght_m", kKnown), "length_m");
  EXPECT_EQ(NearestName("lengthsigma_m", kKnown), "length_sigma_m");
  EXPECT_EQ(NearestName("Side", kKnown), "side");
}

TEST(Text, FindsNothingWhenNoNameIsNear) {
  EXPECT_EQ(NearestName("temperature", kKnown), "");
  EXPECT_EQ(NearestName(std::string(100, 'x'), kKnown), "");
  EXPECT_EQ(DidYouMean("temperature", kKnown), "");
}

}  // namespace
}  // namespace brachium
