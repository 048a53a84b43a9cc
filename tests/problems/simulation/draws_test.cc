#include "problems/simulation/draws.h"

#include <gtest/gtest.h>

#include <cmath>

namespace brachium {
namespace {

TEST(Draws, AreTheSameForTheSameSeedAndStream) {
  Draws a(7, "noise"), b(7, "noise");
  for (int i = 0; i < 100; ++i) EXPECT_EQ(a.Normal(), b.Normal());
}

TEST(Draws, DifferBetweenSeedsAndBetweenStreams) {
  const double value = Draws(7, "noise").Uniform(0.0, 1.0);
  EXPECT_NE(value, Draws(8, "noise").Uniform(0.0, 1.0));
  EXPECT_NE(value, Draws(7, "bias").Uniform(0.0, 1.0));
}

// The standard fixes the bits of std::mt19937_64, and with them those of the uniform made of it.
TEST(Draws, KeepTheirBitsOnEveryMachine) {
  Draws draws(1, "golden");
  EXPECT_EQ(draws.Uniform(0.0, 1.0), 0.34994999726969445);
}

TEST(Draws, NormalHasTheMomentsOfTheStandardNormal) {
  Draws draws(3, "moments");
  constexpr int kCount = 200000;
  double sum = 0.0, squares = 0.0, fourths = 0.0;
  for (int i = 0; i < kCount; ++i) {
    const double x = draws.Normal();
    sum += x;
    squares += x * x;
    fourths += x * x * x * x;
  }
  EXPECT_NEAR(sum / kCount, 0.0, 0.01);
  EXPECT_NEAR(squares / kCount, 1.0, 0.015);
  EXPECT_NEAR(fourths / kCount, 3.0, 0.1);
}

TEST(Draws, OfLengthAndOfRmsHaveExactlyThatSize) {
  Draws draws(5, "size");
  for (int i = 0; i < 10; ++i) {
    EXPECT_NEAR(draws.OfLength(0.005).norm(), 0.005, 1e-15);
    EXPECT_NEAR(std::sqrt(draws.OfRms(0.04).squaredNorm() / 3.0), 0.04, 1e-15);
  }
  EXPECT_EQ(draws.OfLength(0.0), Eigen::Vector3d::Zero());
}

}  // namespace
}  // namespace brachium
