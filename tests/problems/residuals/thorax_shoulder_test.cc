#include "problems/residuals/thorax_shoulder.h"

#include <gtest/gtest.h>

#include "tests/support/jacobian_check.h"

namespace brachium {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;

constexpr double kSigma = 0.03, kTau = 10.0, kStep = 0.1;
const Vector3d kShoulder(0.02, 0.35, 0.17);  // p_shoulder_T
const auto kFirstOrder = FirstOrderStep::Over(kStep, kSigma, kTau);

// A thorax somewhere, and a shoulder that is `away` from where the thorax carries it.
struct Torso {
  Quaterniond q_WT;
  Vector3d p_thorax, p_shoulder;

  Torso(std::mt19937& random, const Vector3d& away_T)
      : q_WT(RandomRotation(random)),
        p_thorax(RandomVector(3, random)),
        p_shoulder(p_thorax + q_WT * (kShoulder + away_T)) {}
};

BlockValues Values(const Torso& a) { return {a.q_WT.coeffs(), a.p_thorax, a.p_shoulder}; }

BlockValues Values(const Torso& a, const Torso& b) {
  return {a.q_WT.coeffs(), a.p_thorax, a.p_shoulder, b.q_WT.coeffs(), b.p_thorax, b.p_shoulder};
}

TEST(ThoraxShoulder, IsZeroWhereTheThoraxCarriesTheShoulderAlong) {
  std::mt19937 random(1);
  const Torso before(random, Vector3d::Zero()), after(random, Vector3d::Zero());
  EXPECT_LT(ResidualAt(ThoraxShoulder(kShoulder, kFirstOrder), Values(before, after)).norm(),
            1e-12);
  EXPECT_LT(ResidualAt(ThoraxShoulderStart(kShoulder, kSigma), Values(before)).norm(), 1e-12);
}

TEST(ThoraxShoulder, IsZeroWhileAShrugDiesAwayInThoraxAxes) {
  std::mt19937 random(1);
  const Vector3d shrug(0.01, 0.04, -0.02);
  const Torso before(random, shrug), after(random, std::exp(-kStep / kTau) * shrug);
  EXPECT_LT(ResidualAt(ThoraxShoulder(kShoulder, kFirstOrder), Values(before, after)).norm(),
            1e-11);
}

TEST(ThoraxShoulder, IsOneAtOneSigma) {
  std::mt19937 random(1);
  const Torso start(random, kSigma * Vector3d::UnitY());
  EXPECT_NEAR(ResidualAt(ThoraxShoulderStart(kShoulder, kSigma), Values(start)).norm(), 1.0, 1e-12);
  const Torso before(random, Vector3d::Zero());
  const Torso after(random, Vector3d::UnitX() / kFirstOrder.weight);
  EXPECT_NEAR(ResidualAt(ThoraxShoulder(kShoulder, kFirstOrder), Values(before, after)).norm(), 1.0,
              1e-10);
}

TEST(ThoraxShoulder, IsBlindToThePoseOfTheBody) {
  std::mt19937 random(1);
  const ThoraxShoulder residual(kShoulder, kFirstOrder);
  const BlockValues x = RandomValues(ThoraxShoulder::Blocks(), random);
  BlockValues moved = TurnedWorld(RandomRotation(random), x, std::vector<bool>(x.size(), true));
  const Vector3d shift = RandomVector(3, random);
  for (const std::size_t place : {1u, 2u, 4u, 5u}) moved[place] += shift;
  EXPECT_LT((ResidualAt(residual, moved) - ResidualAt(residual, x)).norm(), 1e-10);
}

TEST(ThoraxShoulder, DerivativesAgree) {
  EXPECT_TRUE(DerivativesAgreeAtRandomPoints(ThoraxShoulder(kShoulder, kFirstOrder)));
  EXPECT_TRUE(DerivativesAgreeAtRandomPoints(ThoraxShoulderStart(kShoulder, kSigma)));
}

}  // namespace
}  // namespace brachium
