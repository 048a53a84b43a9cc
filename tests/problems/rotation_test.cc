#include "problems/rotation.h"

#include <ceres/jet.h>
#include <gtest/gtest.h>

#include <numbers>

#include "tests/support/residual_values.h"

namespace brachium {
namespace {

using Eigen::AngleAxisd, Eigen::Matrix3d, Eigen::Quaterniond, Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;
// About where the series end, small, moderate, and close to half a turn.
constexpr double kAngles[] = {0.0,    1e-12,  1e-9,   0.9e-6,     1.1e-6,    2e-6,
                              0.9e-4, 1.1e-4, 1.9e-4, 2.1e-4,     1e-2,      0.3,
                              1.0,    2.0,    3.0,    kPi - 1e-3, kPi - 1e-7};

Vector3d Axis(std::mt19937& random) { return RandomVector(3, random).normalized(); }

TEST(Exp, TurnsAboutItsVectorByItsLength) {
  std::mt19937 random(1);
  for (const double angle : {0.0, 1e-9, 1.9e-4, 2.1e-4, 0.3, 2.0, 4.0, 9.0}) {
    const Vector3d axis = Axis(random);
    const Quaterniond expected(AngleAxisd(angle, axis));
    EXPECT_LT((Exp<double>(angle * axis).coeffs() - expected.coeffs()).norm(), 1e-15) << angle;
  }
}

TEST(Log, UndoesExpUpToHalfATurn) {
  std::mt19937 random(1);
  for (const double angle : kAngles) {
    const Vector3d phi = angle * Axis(random);
    EXPECT_LT((Log<double>(Exp<double>(phi)) - phi).norm(), 1e-14 * (1 + angle)) << angle;
  }
}

TEST(Log, TakesAQuaternionAndItsNegativeForTheSameRotation) {
  std::mt19937 random(1);
  for (int i = 0; i < 50; ++i) {
    const Quaterniond q = RandomRotation(random);
    EXPECT_LT((Log<double>(q) - Log<double>(Quaterniond(-q.coeffs()))).norm(), 1e-14);
    EXPECT_LE(Log<double>(q).norm(), kPi + 1e-14);
  }
}

TEST(Log, IsFiniteAtExactlyHalfATurn) {
  EXPECT_LT((Log<double>(Quaterniond(0.0, 0.0, 1.0, 0.0)) - Vector3d(0, kPi, 0)).norm(), 1e-15);
}

TEST(ExpAndLog, HaveDerivativesThroughZero) {
  using Jet = ceres::Jet<double, 3>;
  for (const double size : {0.0, 1e-9, 1e-5, 0.1}) {
    Vector3T<Jet> phi;
    for (int i = 0; i < 3; ++i) phi[i] = Jet(size * (i + 1), i);
    const Vector3T<Jet> back = Log<Jet>(Exp<Jet>(phi));
    for (int i = 0; i < 3; ++i)
      EXPECT_LT((back[i].v - Vector3d::Unit(i)).norm(), 1e-9) << "at " << size;
  }
}

TEST(Skew, IsTheCrossProduct) {
  const Vector3d a(1.0, -2.0, 3.0), b(0.5, 4.0, -1.0);
  EXPECT_LT((Skew<double>(a) * b - a.cross(b)).norm(), 1e-15);
}

TEST(RightJacobian, SaysHowExpChanges) {
  std::mt19937 random(1);
  for (const double angle : kAngles) {
    const Vector3d phi = angle * Axis(random);
    Matrix3d numeric;
    const double step = 1e-4;
    for (int i = 0; i < 3; ++i) {
      const Vector3d d = step * Vector3d::Unit(i);
      const Quaterniond q_inverse = Exp<double>(phi).conjugate();
      numeric.col(i) = (Log<double>(q_inverse * Exp<double>(phi + d)) -
                        Log<double>(q_inverse * Exp<double>(phi - d))) /
                       (2 * step);
    }
    EXPECT_LT((RightJacobian(phi) - numeric).norm(), 1e-8) << angle;
  }
}

TEST(InverseRightJacobian, IsTheInverse) {
  std::mt19937 random(1);
  for (const double angle : kAngles) {
    const Vector3d phi = angle * Axis(random);
    EXPECT_LT((InverseRightJacobian(phi) * RightJacobian(phi) - Matrix3d::Identity()).norm(), 1e-11)
        << angle;
  }
}

TEST(RotationBetween, TakesOneDirectionToTheOtherTheShortestWay) {
  const Vector3d a(1.0, 2.0, -0.5), b(-3.0, 0.2, 0.7);
  const Quaterniond q = RotationBetween(a, b);
  EXPECT_LT((q * a.normalized() - b.normalized()).norm(), 1e-14);
  EXPECT_NEAR(Log<double>(q).norm(), std::acos(a.normalized().dot(b.normalized())), 1e-14);
}

TEST(MeanRotation, IsTheMiddleWhateverTheSignsOfTheQuaternions) {
  const Eigen::Quaterniond middle = Exp<double>(Eigen::Vector3d(0.3, -2.0, 0.9));
  const Eigen::Vector3d turn(0.05, -0.02, 0.1);
  Eigen::Quaterniond before = middle * Exp<double>(Eigen::Vector3d(-turn));
  before.coeffs() = -before.coeffs();
  const Eigen::Quaterniond mean = MeanRotation({middle, before, middle * Exp<double>(turn)});
  EXPECT_LT(mean.angularDistance(middle), 1e-7);
}

}  // namespace
}  // namespace brachium
