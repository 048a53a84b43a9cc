#include "solver/front_factor.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <array>
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
  std::vector<Kept> kept;

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
  // With the columns to eliminate in another place than the rest.
  int Factor() {
    const auto end = memory.begin() + pivots * stride;
    std::vector<double> E(memory.begin(), end);
    std::fill(memory.begin(), end, std::nan(""));
    const int raised = FactorFront(E.data(), memory.data(), stride, columns, pivots, least.data());
    std::copy(E.begin(), E.end(), memory.begin());
    kept.resize(E.size());
    Keep(E.data(), pivots * stride, kept.data());
    return raised;
  }
  // [L; B; yᵀ] as it is kept.
  MatrixXd KeptView() const {
    return Eigen::Map<const Eigen::MatrixX<Kept>>(kept.data(), stride, pivots).cast<double>();
  }
  MatrixXd KeptL() const { return KeptView().topRows(pivots).triangularView<Eigen::Lower>(); }
  MatrixXd KeptB() const { return KeptView().middleRows(pivots, columns - pivots); }
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

TEST_P(FrontFactor, IsKeptRoundedToSinglePrecision) {
  Front front(GetParam().columns, GetParam().pivots);
  front.Factor();
  const MatrixXd kept = front.KeptView();
  for (int k = 0; k < front.pivots; ++k)
    for (int i = k; i <= front.columns; ++i)
      EXPECT_EQ(kept(i, k), static_cast<float>(front.View()(i, k))) << i << " " << k;
}

TEST_P(FrontFactor, GivesTheStepsOfTheDenseSolution) {
  Front front(GetParam().columns, GetParam().pivots);
  front.Factor();
  const VectorXd y = front.View().row(front.columns).head(front.pivots);
  VectorXd expected = Random(front.columns, 1, 3);
  expected.head(front.pivots) = -front.KeptL().transpose().triangularView<Eigen::Upper>().solve(
      y + front.KeptB().transpose() * expected.tail(front.columns - front.pivots));
  constexpr int kSides = 7;  // multiples of one another: two threes and one more
  MatrixXd ys(y.size(), kSides), ds = MatrixXd::Constant(front.stride, kSides, std::nan(""));
  std::vector<const double*> y_of;
  std::vector<double*> d_of;
  for (int side = 0; side < kSides; ++side) {
    ys.col(side) = side * y;
    for (int i = front.pivots; i < front.columns; ++i) ds(i, side) = side * expected[i];
    y_of.push_back(ys.col(side).data());
    d_of.push_back(ds.col(side).data());
  }
  BackSubstitute(front.kept.data(), front.stride, front.columns, front.pivots, kSides, y_of.data(),
                 d_of.data());
  for (int side = 0; side < kSides; ++side)
    for (int i = 0; i < front.columns; ++i)
      EXPECT_NEAR(ds(i, side), side * expected[i], 1e-9) << i << " " << side;
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

// A term's blocks as AddSquare takes them, and J and r as matrices.
struct TermInFront {
  static constexpr int kGradientRow = 14, kStride = 16;
  static constexpr std::array<std::array<int, 2>, 4> kBlocks = {
      {{1, 3}, {4, 1}, {7, 2}, {9, 3}}};  // rows of the front, columns

  MatrixXd J, front = MatrixXd::Zero(kStride, kGradientRow + 1);  // one column of room
  std::vector<double> W;
  std::vector<FrontBlock> blocks;
  std::vector<double> squares, gradient;

  explicit TermInFront(int rows) : J(MatrixXd::Zero(rows, kGradientRow + 1)) {
    for (const auto& [row, columns] : kBlocks) {
      J.middleCols(row, columns) = Random(rows, columns, static_cast<unsigned>(row));
      Append(row, columns);
      blocks.push_back({columns, row, front.col(row).data()});
    }
    J.col(kGradientRow) = Random(rows, 1, 17);
    Append(kGradientRow, 1);
    squares.resize(kLane * blocks.size());
    gradient.resize(kLane * blocks.size());
  }

  void Append(int first, int columns) {
    for (int row = 0; row < J.rows(); ++row)
      for (int i = 0; i < kLane; ++i) W.push_back(i < columns ? J(row, first + i) : 0.0);
  }

  void Add() {
    AddSquare(W.data(), static_cast<int>(J.rows()), blocks, kGradientRow, kStride, squares.data(),
              gradient.data());
  }
};

TEST(AddSquare, AddsTheProductOfTheTransposeWithTheMatrixToALowerTriangle) {
  for (const int rows : {1, 2, 3, 6, 39}) {
    TermInFront term(rows);
    for (int times = 1; times <= 2; ++times) {
      term.Add();
      const MatrixXd expected = times * (term.J.transpose() * term.J);
      for (int j = 0; j < term.kGradientRow; ++j)
        for (int i = j; i <= term.kGradientRow; ++i)
          EXPECT_NEAR(term.front(i, j), expected(i, j), 1e-12) << rows << ": " << i << " " << j;
    }
  }
}

TEST(AddSquare, GivesTheDiagonalAndTheGradientOfTheTermAlone) {
  TermInFront term(6);
  term.Add();
  term.Add();
  const MatrixXd expected = term.J.transpose() * term.J;
  for (std::size_t b = 0; b < term.blocks.size(); ++b)
    for (int i = 0; i < term.blocks[b].columns; ++i) {
      const int column = term.blocks[b].row + i;
      const std::size_t at = b * kLane + static_cast<std::size_t>(i);
      EXPECT_NEAR(term.squares[at], expected(column, column), 1e-12);
      EXPECT_NEAR(term.gradient[at], expected(term.kGradientRow, column), 1e-12);
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
