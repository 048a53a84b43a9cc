#include "problems/residuals/skin.h"

#include <gtest/gtest.h>

#include "problems/arm_model.h"
#include "tests/support/jacobian_check.h"

namespace brachium {
namespace {

using Eigen::Vector3d;

constexpr double kSigma = 3 * kDegree;
const SkinProcess kProcess(FirstOrderStep::Over(0.05, kSigma, 0.2));

TEST(SkinStart, IsOneAtOneSigmaAboutTheLongAxisAndSoonerAboutTheOthers) {
  const SkinStart start(kSigma);
  EXPECT_NEAR(ResidualAt(start, {Vector3d(0.0, kSigma, 0.0)}).norm(), 1.0, 1e-12);
  for (const int axis : {0, 2})
    EXPECT_NEAR(ResidualAt(start, {kTilt * kSigma * Vector3d::Unit(axis)}).norm(), 1.0, 1e-12);
}

TEST(SkinProcess, LetsATurnComeBack) {
  const Vector3d turn(0.01, 0.05, -0.02);
  EXPECT_LT(ResidualAt(kProcess, {turn, std::exp(-0.05 / 0.2) * turn}).norm(), 1e-12);
  EXPECT_GT(ResidualAt(kProcess, {turn, turn}).norm(), 0.2);
}

TEST(SkinProcess, KeepsTheSizeOfTheSkinsTurn) {
  const double rho = std::exp(-0.05 / 0.2);
  const Vector3d step(0.0, std::sqrt(1 - rho * rho) * kSigma, 0.0);
  EXPECT_NEAR(ResidualAt(kProcess, {Vector3d::Zero(), step}).norm(), 1.0, 1e-12);
}

TEST(Skin, DerivativesAgree) {
  EXPECT_TRUE(DerivativesAgreeAtRandomPoints(kProcess));
  EXPECT_TRUE(DerivativesAgreeAtRandomPoints(SkinStart(kSigma)));
}

}  // namespace
}  // namespace brachium
