// Holds the derivatives of a residual against each other: written by hand, by automatic
// differentiation, and by differences of the residual's values.
//
// All in the tangent space, a block at a time, relative to the block's norm: a zero by structure
// has no relative error of its own.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "problems/residuals/cost.h"
#include "tests/support/residual_values.h"

namespace brachium {

using JacobianBlocks =
    std::vector<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;

inline Eigen::VectorXd Moved(const Eigen::VectorXd& block, int direction, double step) {
  if (block.size() != 4) return block + step * Eigen::VectorXd::Unit(block.size(), direction);
  Eigen::VectorXd moved(4);
  const Eigen::Vector3d turn = step * Eigen::Vector3d::Unit(direction);
  RotationManifold().Plus(block.data(), turn.data(), moved.data());
  return moved;
}

// Central differences of fourth order.
inline JacobianBlocks NumericJacobians(const ceres::CostFunction& cost, const BlockValues& x,
                                       double step = 1e-3) {
  const auto value = [&](std::size_t block, int direction, double by) {
    BlockValues moved = x;
    moved[block] = Moved(x[block], direction, by);
    Eigen::VectorXd r(cost.num_residuals());
    EXPECT_TRUE(cost.Evaluate(Pointers(moved).data(), r.data(), nullptr));
    return r;
  };
  JacobianBlocks J;
  for (std::size_t block = 0; block < x.size(); ++block) {
    J.emplace_back(cost.num_residuals(), TangentSize(static_cast<int>(x[block].size())));
    for (int i = 0; i < J.back().cols(); ++i)
      J.back().col(i) = (8 * (value(block, i, step) - value(block, i, -step)) -
                         (value(block, i, 2 * step) - value(block, i, -2 * step))) /
                        (12 * step);
  }
  return J;
}

// What Evaluate says, brought to the tangent space by the manifold's PlusJacobian.
inline JacobianBlocks LoweredJacobians(const ceres::CostFunction& cost, const BlockValues& x,
                                       Eigen::VectorXd* r) {
  JacobianBlocks J;
  std::vector<double*> pointers;
  for (const Eigen::VectorXd& block : x) J.emplace_back(cost.num_residuals(), block.size());
  for (auto& block : J) pointers.push_back(block.data());
  r->resize(cost.num_residuals());
  EXPECT_TRUE(cost.Evaluate(Pointers(x).data(), r->data(), pointers.data()));
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (x[i].size() != 4) continue;
    RowMajor<4, 3> plus;
    RotationManifold().PlusJacobian(x[i].data(), plus.data());
    J[i] = (J[i] * plus).eval();
  }
  return J;
}

inline JacobianBlocks TangentJacobians(const TangentCost& cost, const BlockValues& x,
                                       Eigen::VectorXd* r) {
  JacobianBlocks J;
  std::vector<double*> pointers;
  for (const Eigen::VectorXd& block : x)
    J.emplace_back(cost.num_residuals(), TangentSize(static_cast<int>(block.size())));
  for (auto& block : J) pointers.push_back(block.data());
  r->resize(cost.num_residuals());
  cost.EvaluateTangent(Pointers(x).data(), r->data(), pointers.data());
  return J;
}

inline ::testing::AssertionResult BlocksAgree(const JacobianBlocks& J, const JacobianBlocks& other,
                                              double tolerance, const std::string& name) {
  for (std::size_t i = 0; i < J.size(); ++i)
    if (!((J[i] - other[i]).norm() <= tolerance * std::max(1.0, other[i].norm())))  // NaN too
      return ::testing::AssertionFailure() << "block " << i << " is\n"
                                           << J[i] << "\n"
                                           << name << " is\n"
                                           << other[i];
  return ::testing::AssertionSuccess();
}

// The cost's two ways of evaluation agree with each other and with differences of its values.
inline ::testing::AssertionResult CostDerivativesAgree(const TangentCost& cost,
                                                       const BlockValues& x,
                                                       double tolerance = 1e-8) {
  Eigen::VectorXd r_tangent, r;
  const JacobianBlocks tangent = TangentJacobians(cost, x, &r_tangent);
  const auto lowered = BlocksAgree(LoweredJacobians(cost, x, &r), tangent, 1e-12, "in the tangent");
  if (!lowered) return lowered;
  if (r != r_tangent) return ::testing::AssertionFailure() << "the residuals differ";
  return BlocksAgree(tangent, NumericJacobians(cost, x), tolerance, "the numeric one");
}

// The same, and automatic differentiation agrees as well.
template <typename Residual>
::testing::AssertionResult DerivativesAgree(const Residual& residual, const BlockValues& x,
                                            double tolerance = 1e-8) {
  const std::unique_ptr<TangentCost> cost(MakeCost(residual));
  const std::unique_ptr<ceres::CostFunction> automatic(
      MakeAutomaticCost(residual, typename Residual::Blocks()));
  Eigen::VectorXd r, r_automatic;
  const auto agree =
      BlocksAgree(TangentJacobians(*cost, x, &r), LoweredJacobians(*automatic, x, &r_automatic),
                  1e-10, "the automatic one");
  if (!agree) return agree;
  if (!((r - r_automatic).norm() <= 1e-12 * std::max(1.0, r.norm())))
    return ::testing::AssertionFailure() << "the residuals differ";
  return CostDerivativesAgree(*cost, x, tolerance);
}

// At `points` random values of all blocks.
template <typename Residual>
::testing::AssertionResult DerivativesAgreeAtRandomPoints(const Residual& residual,
                                                          double tolerance = 1e-8,
                                                          int points = 50) {
  std::mt19937 random(1);
  for (int i = 0; i < points; ++i) {
    auto agree =
        DerivativesAgree(residual, RandomValues(typename Residual::Blocks(), random), tolerance);
    if (!agree) return agree << "\nat point " << i;
  }
  return ::testing::AssertionSuccess();
}

}  // namespace brachium
