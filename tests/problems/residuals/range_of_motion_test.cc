#include "problems/residuals/range_of_motion.h"

#include <gtest/gtest.h>

#include "problems/arm_model.h"
#include "problems/joint_angles.h"
#include "tests/support/jacobian_check.h"

namespace brachium {
namespace {

using Eigen::Quaterniond;

constexpr Side kSides[] = {Side::kRight, Side::kLeft};
constexpr double kLower = -5 * kDegree, kUpper = 160 * kDegree, kSigma = 5 * kDegree;
const ElbowRangeOfMotion kElbow(kLower, kUpper, kSigma);

BlockValues Elbow(const ElbowAngles& angles, Side side, std::mt19937& random) {
  const Quaterniond q_WU = RandomRotation(random);
  return {q_WU.coeffs(), (q_WU * ElbowRotation(angles, side)).coeffs()};
}

double Residual(double flexion, Side side) {
  std::mt19937 random(1);
  return ResidualAt(kElbow, Elbow({flexion, 0.2, 1.3}, side, random))[0];
}

TEST(ElbowRangeOfMotion, SaysNothingInsideTheRange) {
  for (const Side side : kSides)
    for (double flexion = -4 * kDegree; flexion < 159 * kDegree; flexion += 10 * kDegree)
      EXPECT_EQ(Residual(flexion, side), 0.0);
}

TEST(ElbowRangeOfMotion, IsOneAtOneSigmaBeyondEitherStop) {
  for (const Side side : kSides) {
    EXPECT_NEAR(Residual(kUpper + kSigma, side), 1.0, 1e-10);
    EXPECT_NEAR(Residual(kLower - kSigma, side), -1.0, 1e-10);
  }
}

// A hinge that satisfies the adduction constraint also does so half a turn further: bent backwards.
TEST(ElbowRangeOfMotion, TellsAnElbowFromOneBentBackwards) {
  for (const Side side : kSides) {
    EXPECT_EQ(Residual(90 * kDegree, side), 0.0);
    EXPECT_NEAR(Residual(-90 * kDegree, side), -17.0, 1e-10);
  }
}

TEST(ElbowRangeOfMotion, DerivativesAgreeInsideAndOutside) {
  std::mt19937 random(4);
  for (const Side side : kSides)
    for (const auto& [least, most] :
         {std::pair{-2.9, kLower - 0.02}, {kLower + 0.02, kUpper - 0.02}, {kUpper + 0.02, 3.1}}) {
      std::uniform_real_distribution<double> flexion(least, most), other(-1.2, 1.2);
      for (int i = 0; i < 50; ++i)
        EXPECT_TRUE(DerivativesAgree(
            kElbow, Elbow({flexion(random), other(random), other(random)}, side, random), 1e-7));
    }
}

}  // namespace
}  // namespace brachium
