#include "problems/residuals/marginal_prior.h"

#include <gtest/gtest.h>

#include "tests/support/jacobian_check.h"

namespace brachium {
namespace {

using Eigen::MatrixXd, Eigen::Quaterniond, Eigen::Vector3d, Eigen::VectorXd;

// Over an attitude, a vector, the carrying angle and another attitude: 11 tangent columns.
const std::vector<int> kSizes{4, 3, 2, 4};
constexpr int kRows = 5, kColumns = 11;

struct Example {
  std::mt19937 random{1};
  MatrixXd J = MatrixXd(kRows, kColumns);
  VectorXd r = RandomVector(kRows, random), point{13};
  BlockValues at = RandomValues(std::integer_sequence<int, 4, 3, 2, 4>(), random);

  Example() {
    for (int i = 0; i < kColumns; ++i) J.col(i) = RandomVector(kRows, random);
    point << at[0], at[1], at[2], at[3];
  }
  MarginalPrior Prior() const { return {kSizes, point, J, r}; }
};

VectorXd ValueAt(const MarginalPrior& prior, const BlockValues& x) {
  VectorXd r(kRows);
  EXPECT_TRUE(prior.Evaluate(Pointers(x).data(), r.data(), nullptr));
  return r;
}

TEST(MarginalPrior, SaysAtItsPointWhatItWasToldThere) {
  const Example example;
  EXPECT_LT((ValueAt(example.Prior(), example.at) - example.r).norm(), 1e-12);
  VectorXd r;
  const JacobianBlocks J = TangentJacobians(example.Prior(), example.at, &r);
  EXPECT_LT((J[0] - example.J.leftCols(3)).norm(), 1e-12);
  EXPECT_LT((J[1] - example.J.middleCols(3, 3)).norm(), 1e-12);
  EXPECT_LT((J[2] - example.J.middleCols(6, 2)).norm(), 1e-12);
  EXPECT_LT((J[3] - example.J.rightCols(3)).norm(), 1e-12);
}

TEST(MarginalPrior, IsLinearInTheStepFromItsPointHoweverLong) {
  Example example;
  VectorXd step = RandomVector(kColumns, example.random, 0.7);
  BlockValues x = example.at;
  const auto turn = [](VectorXd& block, const Vector3d& by) {
    block = (Quaterniond(Eigen::Vector4d(block)) * Exp<double>(by)).coeffs();
  };
  turn(x[0], step.head<3>());
  x[1] += step.segment<3>(3);
  x[2] += step.segment<2>(6);
  turn(x[3], step.tail<3>());
  EXPECT_LT((ValueAt(example.Prior(), x) - example.r - example.J * step).norm(), 1e-12);
}

TEST(MarginalPrior, TakesAQuaternionAndItsNegativeForTheSameAttitude) {
  Example example;
  BlockValues x = RandomValues(std::integer_sequence<int, 4, 3, 2, 4>(), example.random);
  const VectorXd r = ValueAt(example.Prior(), x);
  x[0] = -x[0];
  EXPECT_LT((ValueAt(example.Prior(), x) - r).norm(), 1e-12);
}

TEST(MarginalPrior, KeepsItsInformationAlongADirectionWherePartOfItPointsElsewhere) {
  // J of one row along the vertical: turning about any other axis leaves r as it is.
  std::mt19937 random(1);
  const Quaterniond q = RandomRotation(random);
  const Eigen::RowVector3d up_B = (q.conjugate() * Vector3d::UnitZ()).transpose();
  const MarginalPrior prior({4}, q.coeffs(), 1000 * up_B, VectorXd::Zero(1));
  const auto value = [&](const Vector3d& axis_W) {
    const Quaterniond turned = Quaterniond(Eigen::AngleAxisd(0.3, axis_W)) * q;
    double r = 0.0;
    const double* x = turned.coeffs().data();
    EXPECT_TRUE(prior.Evaluate(&x, &r, nullptr));
    return r;
  };
  EXPECT_NEAR(value(Vector3d::UnitX()), 0.0, 1e-9);
  EXPECT_NEAR(value(Vector3d::UnitZ()), 300.0, 1e-9);
}

TEST(MarginalPrior, LeavesOutTheJacobiansThatNobodyAsksFor) {
  const Example example;
  VectorXd r(kRows);
  JacobianBlocks J{MatrixXd::Zero(kRows, 3)};
  double* pointers[] = {nullptr, J[0].data(), nullptr, nullptr};
  ASSERT_TRUE(example.Prior().Evaluate(Pointers(example.at).data(), r.data(), pointers));
  EXPECT_LT((J[0] - example.J.middleCols(3, 3)).norm(), 1e-12);
}

TEST(MarginalPrior, DerivativesAgreeAtItsPointAndFarFromIt) {
  Example example;
  const MarginalPrior prior = example.Prior();
  EXPECT_TRUE(CostDerivativesAgree(prior, example.at));
  for (int i = 0; i < 50; ++i) {
    BlockValues x = example.at;
    const double angle = std::pow(10.0, -6.0 + 0.125 * i);  // up to 1.3 rad
    for (const std::size_t attitude : {0u, 3u})
      x[attitude] = Near(Quaterniond(Eigen::Vector4d(x[attitude])), angle, example.random).coeffs();
    x[1] = RandomVector(3, example.random);
    EXPECT_TRUE(CostDerivativesAgree(prior, x)) << angle;
  }
}

// Over three numbers, one of which takes a random step.
TEST(MarginalPrior, GrowsByTheCovarianceOfAStepAndMovesByItsMean) {
  std::mt19937 random(4);
  MatrixXd J(3, 3);
  for (int i = 0; i < 3; ++i) J.col(i) = RandomVector(3, random);
  const VectorXd r = RandomVector(3, random), point = VectorXd::Zero(3);
  constexpr double kMean = 0.3, kSigma = 0.7;
  MarginalPrior prior({1, 1, 1}, point, J, r);
  const auto sound = prior.Copy();
  prior.Step(1, kMean, kSigma);
  const auto mean_and_covariance = [&](const MarginalPrior& of) {
    const double zeros[] = {0.0, 0.0, 0.0};
    const double* x[] = {&zeros[0], &zeros[1], &zeros[2]};
    Vector3d residual, columns[3];
    double* jacobians[] = {columns[0].data(), columns[1].data(), columns[2].data()};
    of.EvaluateTangent(x, residual.data(), jacobians);
    Eigen::Matrix3d jacobian;
    jacobian << columns[0], columns[1], columns[2];
    const Eigen::Matrix3d covariance = (jacobian.transpose() * jacobian).inverse();
    return std::pair<Vector3d, Eigen::Matrix3d>(-covariance * jacobian.transpose() * residual,
                                                covariance);
  };
  auto [mean, covariance] = mean_and_covariance(*sound);
  const auto [loose_mean, loose_covariance] = mean_and_covariance(prior);
  mean[1] += kMean;
  covariance(1, 1) += kSigma * kSigma;
  EXPECT_LT((loose_mean - mean).norm(), 1e-9);
  EXPECT_LT((loose_covariance - covariance).norm(), 1e-9 * covariance.norm());
}

}  // namespace
}  // namespace brachium
