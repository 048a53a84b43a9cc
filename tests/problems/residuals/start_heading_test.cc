#include "problems/residuals/start_heading.h"

#include <gtest/gtest.h>

#include "tests/support/jacobian_check.h"

namespace brachium {
namespace {

using Eigen::AngleAxisd, Eigen::Quaterniond, Eigen::Vector3d;

double Residual(const Quaterniond& q_start, const Quaterniond& q) {
  return ResidualAt(HeadingGauge(q_start), {q.coeffs()})[0];
}

TEST(HeadingGauge, IsZeroAtTheStartGuess) {
  std::mt19937 random(1);
  const Quaterniond q = RandomRotation(random);
  EXPECT_NEAR(Residual(q, q), 0.0, 1e-9);
}

TEST(HeadingGauge, IsOneForATurnOfAMilliradianAboutTheVertical) {
  std::mt19937 random(1);
  for (int i = 0; i < 20; ++i) {
    const Quaterniond q = RandomRotation(random);
    const Quaterniond turned = AngleAxisd(1e-3, Vector3d::UnitZ()) * q;
    EXPECT_NEAR(Residual(q, turned), 1.0, 1e-9);
  }
}

TEST(HeadingGauge, IsBlindToAChangeOfInclination) {
  std::mt19937 random(1);
  for (int i = 0; i < 20; ++i) {
    const Quaterniond q = RandomRotation(random);
    const Vector3d horizontal(std::cos(i), std::sin(i), 0.0);
    EXPECT_NEAR(Residual(q, AngleAxisd(0.5, horizontal) * q), 0.0, 1e-9);
  }
}

TEST(HeadingGauge, DerivativesAgreeNearTheStartGuessAndFarFromIt) {
  std::mt19937 random(1);
  for (int i = 0; i < 60; ++i) {
    const Quaterniond q_start = RandomRotation(random);
    const double angle = std::pow(10.0, -8.0 + 0.14 * i);  // up to 2.6 rad
    EXPECT_TRUE(
        DerivativesAgree(HeadingGauge(q_start, 0.1), {Near(q_start, angle, random).coeffs()}))
        << angle;
  }
}

TEST(RelativeStartHeading, SeesATurnOfOneSegmentAndNotOneOfTheWhole) {
  std::mt19937 random(1);
  for (int i = 0; i < 20; ++i) {
    const Quaterniond a = RandomRotation(random), b = RandomRotation(random);
    const Quaterniond q_turn(AngleAxisd(0.5, Vector3d::UnitZ()));
    const RelativeStartHeading residual(a, b, 2.0);
    const Quaterniond turned_a = q_turn * a, turned_b = q_turn * b;
    EXPECT_NEAR(ResidualAt(residual, {turned_a.coeffs(), turned_b.coeffs()})[0], 0.0, 1e-9);
    EXPECT_NEAR(ResidualAt(residual, {a.coeffs(), turned_b.coeffs()})[0], 0.25, 1e-9);
    EXPECT_NEAR(ResidualAt(residual, {turned_a.coeffs(), b.coeffs()})[0], -0.25, 1e-9);
  }
}

TEST(RelativeStartHeading, DerivativesAgree) {
  std::mt19937 random(1);
  const Quaterniond a = RandomRotation(random), b = RandomRotation(random);
  EXPECT_TRUE(DerivativesAgreeAtRandomPoints(RelativeStartHeading(a, b, 2.0)));
  EXPECT_TRUE(DerivativesAgree(RelativeStartHeading(a, b, 2.0),
                               {Near(a, 0.3, random).coeffs(), Near(b, 1.0, random).coeffs()}));
}

}  // namespace
}  // namespace brachium
