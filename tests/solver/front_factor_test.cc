#include "solver/front_factor.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <random>
#include <vector>

namespace brachium {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

MatrixXd Random(int rows, int columns, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  return MatrixXd::NullaryExpr(rows, columns, [&] { return normal(random); });
}

MatrixXd PositiveDefinite(int size, unsigned seed) {
  const MatrixXd J = Random(size + 3, size, seed);
  return J.transpose() * J;
}

// A front as memory: H's lower triangle, the gradient as one more row, NaN where nothing counts.
struct Front {
  int columns, pivots, stride;
  MatrixXd H;
  VectorXd g;
  std::vector<double> memory;
  std::vector<double> least;

  Front(int columns_, int pivots_)
      : columns(columns_),
        pivots(pivots_),
        stride(Padded(columns_ + 1)),
        H(PositiveDefinite(columns_, static_cast<unsigned>(columns_))),
        g(Random(columns_, 1, 7)),
        memory(static_cast<std::size_t>(columns_ * stride), 0.0),
        least(static_cast<std::size_t>(pivots_), 0.0) {
    for (int j = 0; j < columns; ++j) {
      for (int i = 0; i < j; ++i) View()(i, j) = std::nan("");
      for (int i = j; i < columns; ++i) View()(i, j) = H(i, j);
      View()(columns, j) = g[j];
    }
  }
  Eigen::Map<MatrixXd> View() { return {memory.data(), stride, columns}; }
  int Factor() { return FactorFront(memory.data(), stride, columns, pivots, least.data()); }
};

struct Size {
  int columns, pivots;
};

class FrontFactor : public testing::TestWithParam<Size> {};

TEST_P(FrontFactor, IsThatOfTheDenseCholeskyFactorisation) {
  Front front(GetParam().columns, GetParam().pivots);
  EXPECT_EQ(front.Factor(), 0);
  const int n = front.columns, e = front.pivots, s = n - e;
  const MatrixXd L = Eigen::LLT<MatrixXd>(front.H).matrixL();
  const VectorXd y = L.triangularView<Eigen::Lower>().solve(front.g);
  const MatrixXd rest = L.bottomRightCorner(s, s) * L.bottomRightCorner(s, s).transpose();
  const VectorXd g_rest = front.g.tail(s) - L.bottomLeftCorner(s, e) * y.head(e);
  for (int j = 0; j < n; ++j) {
    for (int i = j; i < n; ++i)
      EXPECT_NEAR(front.View()(i, j), j < e ? L(i, j) : rest(i - e, j - e), 1e-11) << i << " " << j;
    EXPECT_NEAR(front.View()(n, j), j < e ? y[j] : g_rest[j - e], 1e-10) << j;
  }
}

TEST_P(FrontFactor, GivesTheStepOfTheDenseSolution) {
  Front front(GetParam().columns, GetParam().pivots);
  front.Factor();
  const VectorXd expected = -front.H.llt().solve(front.g);
  const VectorXd y = front.View().row(front.columns).head(front.pivots);
  std::vector<double> d(static_cast<std::size_t>(front.stride), std::nan(""));
  for (int i = front.pivots; i < front.columns; ++i) d[static_cast<std::size_t>(i)] = expected[i];
  BackSubstitute(front.memory.data(), front.stride, front.columns, front.pivots, y.data(),
                 d.data());
  for (int i = 0; i < front.columns; ++i)
    EXPECT_NEAR(d[static_cast<std::size_t>(i)], expected[i], 1e-9) << i;
}

TEST_P(FrontFactor, ExtendsTheCovarianceToThatOfTheDenseInverse) {
  Front front(GetParam().columns, GetParam().pivots);
  front.Factor();
  const int n = front.columns, e = front.pivots, s = n - e;
  const MatrixXd expected = front.H.inverse();
  MatrixXd S = MatrixXd::Constant(front.stride, n, std::nan(""));
  S.block(e, e, s, s) = expected.bottomRightCorner(s, s);
  S.bottomRightCorner(front.stride - n, s).setZero();
  std::vector<double> scratch(static_cast<std::size_t>(2 * e * front.stride));
  ExtendCovariance(front.memory.data(), front.stride, n, e, S.data(), scratch.data());
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < front.stride; ++i)
      EXPECT_NEAR(S(i, j), i < n ? expected(i, j) : 0.0, 1e-9) << i << " " << j;
}

INSTANTIATE_TEST_SUITE_P(, FrontFactor,
                         testing::Values(Size{1, 1}, Size{5, 0}, Size{6, 3}, Size{7, 7}, Size{8, 4},
                                         Size{23, 5}, Size{70, 16}, Size{71, 22}, Size{75, 23}),
                         [](const auto& size) {
                           return std::to_string(size.param.columns) + "columns" +
                                  std::to_string(size.param.pivots) + "pivots";
                         });

TEST(SquareColumns, IsTheProductOfTheTransposeWithTheMatrix) {
  for (const int rows : {1, 2, 3, 4, 5, 6, 7, 9, 54})
    for (const int columns : {1, 4, 13, 44}) {
      const int stride = Padded(columns);
      MatrixXd W = MatrixXd::Zero(stride, rows);  // a row of W is a column here
      W.topRows(columns) = Random(columns, rows, 3);
      MatrixXd P = MatrixXd::Constant(stride, columns, std::nan(""));
      SquareColumns(W.data(), rows, columns, P.data());
      const MatrixXd expected = W * W.transpose();
      for (int j = 0; j < columns; ++j)
        for (int i = j; i < columns; ++i) EXPECT_NEAR(P(i, j), expected(i, j), 1e-12);
    }
}

TEST(FactorFront, RaisesPivotsThatAreNotAboveTheLeastAndCountsThem) {
  Front front(9, 6);
  front.least[4] = 1e3;  // above any pivot of this front
  EXPECT_EQ(front.Factor(), 1);
  EXPECT_NEAR(front.View()(4, 4), std::sqrt(kRaised * 1e3), 1e-9);
  Front indefinite(9, 6);
  indefinite.View()(2, 2) = -1.0;
  for (double& least : indefinite.least) least = 1e-13;
  EXPECT_GE(indefinite.Factor(), 1);
  EXPECT_TRUE(std::isfinite(indefinite.View()(8, 8)));
}

}  // namespace
}  // namespace brachium
