#include "problems/residuals/in_body_axes.h"

#include <gtest/gtest.h>

#include "problems/residuals/shoulder_process.h"
#include "problems/residuals/zero_velocity.h"
#include "tests/support/jacobian_check.h"

namespace brachium {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;

const ShoulderProcess kShoulder(FirstOrderStep::Over(0.1, 0.03, 10.0));
const ZeroVelocity kRest(FirstOrderStep::Over(0.1, 0.005, 0.5), 0.9);

BlockValues SomeShoulder() {
  std::mt19937 random(3);
  return RandomValues(InBodyAxes<ShoulderProcess>::Blocks(), random);
}

TEST(InBodyAxes, SaysAsMuchAsTheResidualOfTheWorld) {
  const BlockValues x = SomeShoulder();
  EXPECT_NEAR(ResidualAt(InBodyAxes(kShoulder), x).norm(),
              ResidualAt(kShoulder, {x.begin() + 1, x.end()}).norm(), 1e-9);
}

TEST(InBodyAxes, DoesNotChangeAsTheWorldTurns) {
  BlockValues x = SomeShoulder();
  const Eigen::VectorXd r = ResidualAt(InBodyAxes(kShoulder), x);
  x = TurnedWorld(Quaterniond(Eigen::AngleAxisd(0.7, Vector3d::UnitZ())), x,
                  {false, true, true, true});
  EXPECT_LT((ResidualAt(InBodyAxes(kShoulder), x) - r).norm(), 1e-9);
}

TEST(InBodyAxes, DerivativesAgree) {
  EXPECT_TRUE(DerivativesAgreeAtRandomPoints(InBodyAxes(kShoulder)));
  EXPECT_TRUE(DerivativesAgreeAtRandomPoints(InBodyAxes(kRest)));
}

}  // namespace
}  // namespace brachium
