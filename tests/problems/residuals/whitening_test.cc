#include "problems/residuals/whitening.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

namespace brachium {
namespace {

using Eigen::Matrix2d, Eigen::Matrix3d;

// Information of a first-order process at its ends, its middle summed out where it has one.
Matrix2d InOneStep(double duration, double sigma, double tau) {
  const auto step = FirstOrderStep::Over(duration, sigma, tau);
  Matrix2d J;
  J << FirstOrderStep::Start(sigma).weight, 0.0, -step.weight * step.rho, step.weight;
  return J.transpose() * J;
}

Matrix2d InTwoSteps(double first, double second, double sigma, double tau) {
  const auto a = FirstOrderStep::Over(first, sigma, tau);
  const auto b = FirstOrderStep::Over(second, sigma, tau);
  Matrix3d J;                                          // columns: begin, end, middle
  J << FirstOrderStep::Start(sigma).weight, 0.0, 0.0,  //
      -a.weight * a.rho, 0.0, a.weight,                //
      0.0, b.weight, -b.weight * b.rho;
  const Matrix3d H = J.transpose() * J;
  return H.topLeftCorner<2, 2>() - H.topRightCorner<2, 1>() * H.bottomLeftCorner<1, 2>() / H(2, 2);
}

TEST(FirstOrderStep, SaysTheSameAboutTheEndsHoweverTheWayIsCut) {
  for (const double duration : {0.01, 0.3, 2.0, 20.0})
    for (const double cut : {0.5, 0.1}) {
      const Matrix2d whole = InOneStep(duration, 0.09, 2.0);
      const Matrix2d parts = InTwoSteps(cut * duration, (1 - cut) * duration, 0.09, 2.0);
      EXPECT_LT((parts - whole).norm(), 1e-12 * whole.norm()) << duration;
    }
}

TEST(FirstOrderStep, GivesEveryInstantTheSigmaAndNeighboursTheirCorrelation) {
  const Matrix2d covariance = InOneStep(0.7, 0.09, 2.0).inverse();
  EXPECT_NEAR(covariance(0, 0), 0.09 * 0.09, 1e-15);
  EXPECT_NEAR(covariance(1, 1), 0.09 * 0.09, 1e-15);
  EXPECT_NEAR(covariance(0, 1), 0.09 * 0.09 * std::exp(-0.35), 1e-15);
}

TEST(FirstOrderStep, KeepsItsDigitsOverAVeryShortStep) {
  const auto step = FirstOrderStep::Over(1e-12, 0.5, 1.0);
  EXPECT_NEAR(step.weight, 1 / (0.5 * std::sqrt(2e-12)), 1e-9 * step.weight);
}

TEST(Whitening2, MakesTheCovarianceTheIdentity) {
  Matrix2d C;
  C << 4.0, -1.5, -1.5, 9.0;
  const auto w = Whitening2::FromCovariance(C);
  Matrix2d W;
  W << w.vv, 0.0, w.pv, w.pp;
  EXPECT_LT((W * C * W.transpose() - Matrix2d::Identity()).norm(), 1e-14);
}

TEST(Whitening2, AppliesTheSameWeightsToEveryAxis) {
  const Whitening2 w{2.0, 3.0, 5.0};
  Eigen::Matrix<double, 6, 1> r, expected;
  w.Apply(Eigen::Vector3d(1.0, 10.0, 100.0), Eigen::Vector3d(0.1, 0.2, 0.3), r.data());
  expected << 2.0, 20.0, 200.0, 3.5, 31.0, 301.5;
  EXPECT_TRUE(r.isApprox(expected));
}

// Adding up many short intervals of independent acceleration gives the covariance of the long one.
TEST(WhiteAccelerationCovariance, IsTheSumOverShorterIntervals) {
  const double S = 0.02, D = 0.4;
  const int parts = 7;
  const double h = D / parts;
  Matrix2d sum = Matrix2d::Zero(), forward;
  forward << 1.0, 0.0, h, 1.0;
  for (int i = 0; i < parts; ++i)
    sum = forward * sum * forward.transpose() + WhiteAccelerationCovariance(S, h);
  EXPECT_LT((sum - WhiteAccelerationCovariance(S, D)).norm(), 1e-15);
}

TEST(WhiteAccelerationCovariance, TiesVelocityAndPlaceByAFixedCorrelation) {
  const Matrix2d C = WhiteAccelerationCovariance(3.0, 0.05);
  EXPECT_NEAR(C(0, 1) / std::sqrt(C(0, 0) * C(1, 1)), std::sqrt(3.0) / 2, 1e-12);
}

}  // namespace
}  // namespace brachium
