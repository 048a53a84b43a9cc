#include "problems/residuals/elbow_adduction.h"

#include <gtest/gtest.h>

#include "problems/arm_model.h"
#include "problems/joint_angles.h"
#include "tests/support/jacobian_check.h"

namespace brachium {
namespace {

using Eigen::AngleAxisd, Eigen::Quaterniond, Eigen::Vector2d, Eigen::Vector3d;

constexpr Side kSides[] = {Side::kRight, Side::kLeft};
constexpr double kSigma = 5 * kDegree;
const Vector2d kCarrying(0.2, 0.0), kCarryingWithSlope(0.2, 0.1);

double Residual(Side side, const Quaterniond& q_WU, const Quaterniond& q_WF,
                const Vector2d& carrying = kCarrying, double slow = 0.0) {
  return ResidualAt(ElbowAdduction(side, kSigma),
                    {q_WU.coeffs(), q_WF.coeffs(), carrying, Eigen::Matrix<double, 1, 1>(slow)})[0];
}

TEST(ElbowAdduction, IsZeroAtTheCarryingAngleForEveryFlexionAndPronationOnBothSides) {
  std::mt19937 random(1);
  const Quaterniond q_WU = RandomRotation(random);
  for (const Side side : kSides)
    for (double flexion = -0.1; flexion < 2.7; flexion += 0.2)
      for (double pronation = -0.2; pronation < 3.0; pronation += 0.4) {
        const Quaterniond q_UF = ElbowRotation({flexion, kCarrying[0], pronation}, side);
        EXPECT_NEAR(Residual(side, q_WU, q_WU * q_UF), 0.0, 1e-12);
      }
}

TEST(ElbowAdduction, LetsTheCarryingAngleVaryWithFlexion) {
  std::mt19937 random(1);
  const Quaterniond q_WU = RandomRotation(random);
  for (const Side side : kSides)
    for (double flexion = 0.0; flexion < 2.7; flexion += 0.2) {
      double carrying = 0.2;  // the fixed point of k0 + k1 cos(flexion) cos(carrying)
      for (int i = 0; i < 60; ++i) carrying = 0.2 + 0.1 * std::cos(flexion) * std::cos(carrying);
      const Quaterniond q_UF = ElbowRotation({flexion, carrying, 1.0}, side);
      EXPECT_NEAR(Residual(side, q_WU, q_WU * q_UF, kCarryingWithSlope), 0.0, 1e-10);
    }
}

TEST(ElbowAdduction, IsOneAtOneSigmaOfVarusOnBothSides) {
  for (const Side side : kSides)
    for (const double flexion : {0.0, 1.0, 2.0}) {
      const Quaterniond q_UF = ElbowRotation({flexion, kCarrying[0] - kSigma, 0.5}, side);
      EXPECT_NEAR(Sign(side) * Residual(side, Quaterniond::Identity(), q_UF), 1.0, 0.02);
    }
}

TEST(ElbowAdduction, IsZeroWhereTheSlowDeviationAccountsForTheElbow) {
  for (const Side side : kSides) {
    const double varus = 0.1;
    const Quaterniond q_UF = ElbowRotation({0.4, -varus, 0.3}, side);
    EXPECT_NEAR(Residual(side, Quaterniond::Identity(), q_UF, Vector2d::Zero(),
                         Sign(side) * std::sin(varus)),
                0.0, 1e-12);
  }
}

TEST(ElbowAdduction, IsBlindToARotationCommonToBothSegments) {
  std::mt19937 random(1);
  const ElbowAdduction residual(Side::kLeft, kSigma);
  const BlockValues x = RandomValues(ElbowAdduction::Blocks(), random, 0.2);
  const BlockValues turned = TurnedWorld(RandomRotation(random), x, std::vector<bool>(4, false));
  EXPECT_NEAR(ResidualAt(residual, turned)[0], ResidualAt(residual, x)[0], 1e-10);
}

// The forearm turned about the vertical by δ while the upper arm hangs.
double TurnedForearm(Side side, double flexion, double heading) {
  const Quaterniond hanging(AngleAxisd(90 * kDegree, Vector3d::UnitX()));  // y up
  const Quaterniond q_WF =
      AngleAxisd(heading, Vector3d::UnitZ()) * hanging * ElbowRotation({flexion, 0.0, 1.0}, side);
  return Residual(side, hanging, q_WF, Vector2d::Zero());
}

TEST(ElbowAdduction, CannotSeeTheRelativeHeadingOfAStraightHangingArm) {
  for (const Side side : kSides)
    for (const double heading : {-2.0, 0.1, 0.7, 3.0})
      EXPECT_NEAR(TurnedForearm(side, 0.0, heading), 0.0, 1e-12);
}

TEST(ElbowAdduction, SeesTheRelativeHeadingInFullWhereTheElbowIsAtARightAngle) {
  for (const Side side : kSides) {
    EXPECT_NEAR(std::abs(TurnedForearm(side, 90 * kDegree, kSigma)), 1.0, 0.01);
    EXPECT_NEAR(std::abs(TurnedForearm(side, 30 * kDegree, kSigma)), 0.5, 0.01);
  }
}

TEST(ElbowAdduction, DerivativesAgree) {
  std::mt19937 random(2);
  for (const Side side : kSides)
    for (int i = 0; i < 50; ++i)
      EXPECT_TRUE(DerivativesAgree(ElbowAdduction(side, kSigma),
                                   RandomValues(ElbowAdduction::Blocks(), random, 0.2)));
}

TEST(AdductionProcess, LetsADeviationDieAwayAndIsOneAtOneSigmaOfItsStep) {
  using Number = Eigen::Matrix<double, 1, 1>;
  const auto step = FirstOrderStep::Over(0.1, kSigma, 10.0);
  const AdductionProcess process(step);
  const double before = 0.1, after = std::exp(-0.01) * before;
  EXPECT_NEAR(ResidualAt(process, {Number(before), Number(after)})[0], 0.0, 1e-12);
  EXPECT_NEAR(ResidualAt(process, {Number(before), Number(after + 1 / step.weight)})[0], 1.0,
              1e-12);
  EXPECT_TRUE(DerivativesAgreeAtRandomPoints(process));
}

}  // namespace
}  // namespace brachium
