// A small version of benchmarks/uncertainty_campaign.cc.
#include <gtest/gtest.h>

#include "tests/support/normalised_errors.h"

namespace brachium {
namespace {

TEST(Uncertainty, IsThatOfErrorsDrawnAsStated) {
  NormalisedErrors errors;
  for (const char* scenario : {"daily_brisk", "daily_slow"})
    for (std::uint64_t seed = 1; seed <= 6; ++seed)
      Append(NormalisedErrorsOf(DrawnAsStated(scenario, seed, 30.0), {0.3, 0.6, 0.9}), errors);
  const std::vector<double> pool = Pooled(errors);
  EXPECT_GT(Covered(pool), 0.90);
  EXPECT_GT(RmsOf(pool), 0.75);
  EXPECT_LT(RmsOf(pool), 1.25);
  for (const auto& [quantity, values] : errors) EXPECT_LT(RmsOf(values), 1.5) << quantity;
}

TEST(Uncertainty, IsTooSmallWhereMountingsAreTakenForExactAndAreNot) {
  NormalisedErrors errors;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    UncertainCase drawn = DrawnAsStated("daily_brisk", seed, 30.0);
    drawn.smoother.model.estimate_mountings = false;
    Append(NormalisedErrorsOf(drawn, {0.3, 0.6, 0.9}), errors);
  }
  EXPECT_GT(RmsOf(Pooled(errors)), 2.0);
}

}  // namespace
}  // namespace brachium
