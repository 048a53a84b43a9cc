// The information of a run of terms as one dense matrix: the witness of the block elimination.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cmath>
#include <utility>
#include <vector>

#include "problems/arm_problem.h"
#include "problems/rotation.h"

namespace brachium {

// H = Σ JᵀJ and g = Σ Jᵀr over chosen terms at one point; unknown i holds the rows from offset[i].
struct DenseInformation {
  Eigen::MatrixXd H;
  Eigen::VectorXd g;
  std::vector<int> offset;

  DenseInformation(const ArmProblem& problem) {
    int dimension = 0;
    for (int unknown = 0; unknown < problem.unknowns(); ++unknown) {
      offset.push_back(dimension);
      dimension += problem.Describe(unknown).Tangent();
    }
    H = Eigen::MatrixXd::Zero(dimension, dimension);
    g = Eigen::VectorXd::Zero(dimension);
  }

  int OffsetOf(int unknown) const { return offset[static_cast<std::size_t>(unknown)]; }

  void Add(const TangentCost& cost, const std::vector<int>& unknowns, const ArmProblem& problem,
           State& state) {
    using Block = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    std::vector<const double*> values;
    std::vector<Block> J;
    for (const int unknown : unknowns) {
      values.push_back(problem.Value(state, unknown));
      J.emplace_back(cost.num_residuals(), TangentSize(problem.Describe(unknown).Size()));
    }
    std::vector<double*> jacobians;
    for (Block& block : J) jacobians.push_back(block.data());
    Eigen::VectorXd r(cost.num_residuals());
    cost.EvaluateTangent(values.data(), r.data(), jacobians.data());
    for (std::size_t i = 0; i < J.size(); ++i)
      if (problem.Describe(unknowns[i]).held) J[i].resize(J[i].rows(), 0);
    for (std::size_t i = 0; i < J.size(); ++i) {
      g.segment(OffsetOf(unknowns[i]), J[i].cols()) += J[i].transpose() * r;
      for (std::size_t j = 0; j < J.size(); ++j)
        H.block(OffsetOf(unknowns[i]), OffsetOf(unknowns[j]), J[i].cols(), J[j].cols()) +=
            J[i].transpose() * J[j];
    }
  }

  // Terms whose first knot lies in [start, end).
  void AddTerms(const ArmProblem& problem, State& state, int start, int end) {
    for (const Term& term : problem.terms())
      if (term.first_knot >= start && term.first_knot < end)
        Add(*term.cost, term.unknowns, problem, state);
  }

  // The rows of these unknowns, one after another.
  std::vector<int> RowsOf(const ArmProblem& problem, const std::vector<int>& unknowns) const {
    std::vector<int> rows;
    for (const int unknown : unknowns)
      for (int i = 0; i < problem.Describe(unknown).Tangent(); ++i)
        rows.push_back(OffsetOf(unknown) + i);
    return rows;
  }
};

// Solves H X = B for a positive definite H, its diagonal scaled to one and in long double: units
// differ by many orders of magnitude.
inline Eigen::MatrixXd SolvedInLongDouble(const Eigen::MatrixXd& H, const Eigen::MatrixXd& B) {
  using Long = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
  const Eigen::VectorXd scale = H.diagonal().cwiseSqrt().cwiseInverse();
  const Long scaled = (scale.asDiagonal() * H * scale.asDiagonal()).cast<long double>();
  const Eigen::LLT<Long> llt(scaled);
  const Long right = (scale.asDiagonal() * B).cast<long double>();
  return scale.asDiagonal() * llt.solve(right).cast<double>();
}

// What the error of a segment's attitude, in world axes, is made of: unknowns and derivatives, found
// by small changes of their values.
inline std::vector<std::pair<int, Eigen::Matrix3d>> TurnsOfSegment(const ArmProblem& problem,
                                                                   const State& state, int knot,
                                                                   int sensor) {
  constexpr double kStep = 1e-5;
  const Eigen::Quaterniond q_BW = problem.SegmentAttitude(state, knot, sensor).conjugate();
  std::vector<std::pair<int, Eigen::Matrix3d>> turns;
  for (const int unknown :
       {problem.Attitude(knot, sensor), problem.Constant(UnknownKind::kMounting, sensor)}) {
    if (problem.Describe(unknown).held) continue;
    Eigen::Matrix3d J;
    const auto turned = [&](const Eigen::Vector3d& step) -> Eigen::Vector3d {
      State other = state;
      double* x = problem.Value(other, unknown);
      if (problem.Describe(unknown).Size() == 4)
        Eigen::Map<Eigen::Quaterniond>{x} = Eigen::Map<Eigen::Quaterniond>(x) * Exp<double>(step);
      else
        Eigen::Map<Eigen::Vector3d>{x} += step;
      return Log<double>(problem.SegmentAttitude(other, knot, sensor) * q_BW);
    };
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(axis);
      J.col(axis) = (turned(step) - turned(-step)) / (2 * kStep);
    }
    turns.emplace_back(unknown, J);
  }
  return turns;
}

}  // namespace brachium
