#include "problems/residuals/linear.h"

#include <gtest/gtest.h>

#include "tests/support/jacobian_check.h"

namespace brachium {
namespace {

struct TwoOfThree : Linear<3, 2> {
  using Blocks = std::integer_sequence<int, 3, 3>;
  TwoOfThree() : Linear({-2.0, 5.0}, Vector(1.0, 2.0, 3.0)) {}
};

TEST(Linear, IsTheWeightedSumLessTheConstant) {
  const Eigen::Vector3d a(1.0, 10.0, 100.0), b(0.1, 0.2, 0.3);
  EXPECT_TRUE(ResidualAt(TwoOfThree(), {a, b}).isApprox(Eigen::Vector3d(-2.5, -21.0, -201.5)));
}

TEST(Linear, DerivativesAgree) { EXPECT_TRUE(DerivativesAgreeAtRandomPoints(TwoOfThree())); }

}  // namespace
}  // namespace brachium
