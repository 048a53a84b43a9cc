// From a residual (an equation and its derivatives) to a cost function of Ceres.
//
// A residual class R has
//   R::kResiduals      the number of whitened, unitless residuals,
//   R::Blocks          std::integer_sequence<int, ...>, sizes of its blocks; 4: rotation [x y z w],
//   operator()         template <T> void (const T* const* x, T* r) const: the equation,
//   Differentiate      void (const double* const* x, double* const* J) const: its derivatives, one
//                      row-major matrix a block, in the tangent space (3 columns for a rotation).
#pragma once

#include <ceres/autodiff_cost_function.h>
#include <ceres/cost_function.h>

#include <array>
#include <tuple>
#include <utility>

#include "problems/rotation_manifold.h"

namespace brachium {

constexpr int TangentSize(int block) { return block == 4 ? 3 : block; }

template <int kRows, int kColumns>
using RowMajor =
    Eigen::Matrix<double, kRows, kColumns, kColumns == 1 ? Eigen::ColMajor : Eigen::RowMajor>;

// A cost function that also knows its Jacobians in the tangent space.
class TangentCost : public ceres::CostFunction {
 public:
  // r: num_residuals(). J[i]: row-major, num_residuals() x tangent size of block i; none may be
  // null.
  virtual void EvaluateTangent(const double* const* x, double* r, double* const* J) const = 0;
};

template <typename Residual, int... kBlocks>
class AnalyticCost final : public TangentCost {
 public:
  explicit AnalyticCost(Residual residual) : residual_(std::move(residual)) {
    set_num_residuals(Residual::kResiduals);
    *mutable_parameter_block_sizes() = {kBlocks...};
  }

  void EvaluateTangent(const double* const* x, double* r, double* const* J) const override {
    residual_(x, r);
    residual_.Differentiate(x, J);
  }

  bool Evaluate(const double* const* x, double* r, double** J) const override {
    residual_(x, r);
    if (J == nullptr) return true;
    std::tuple<RowMajor<Residual::kResiduals, TangentSize(kBlocks)>...> tangent;
    std::apply(
        [&](auto&... block) {
          const std::array<double*, sizeof...(kBlocks)> pointers{block.data()...};
          residual_.Differentiate(x, pointers.data());
        },
        tangent);
    Lift(tangent, x, J, std::make_index_sequence<sizeof...(kBlocks)>());
    return true;
  }

 private:
  template <typename Tuple, std::size_t... I>
  static void Lift(const Tuple& tangent, const double* const* x, double** J,
                   std::index_sequence<I...>) {
    (LiftBlock<kBlocks>(std::get<I>(tangent), x[I], J[I]), ...);
  }

  // ∂r/∂q = ∂r/∂φ · ∂φ/∂q.
  template <int kBlock, typename Matrix>
  static void LiftBlock(const Matrix& tangent, const double* x, double* J) {
    if (J == nullptr) return;
    Eigen::Map<RowMajor<Residual::kResiduals, kBlock>> ambient(J);
    if constexpr (kBlock == 4) {
      RowMajor<3, 4> minus;
      RotationManifold().MinusJacobian(x, minus.data());
      ambient.noalias() = tangent * minus;
    } else {
      ambient = tangent;
    }
  }

  Residual residual_;
};

// Shows a residual to Ceres' automatic differentiation: the witness of the analytic derivatives.
template <typename Residual>
class AutomaticFunctor {
 public:
  explicit AutomaticFunctor(Residual residual) : residual_(std::move(residual)) {}

  template <typename T, typename... Pointers>
  bool operator()(const T* first, Pointers... others) const {
    const std::array<const T*, 1 + sizeof...(others)> x{first, others...};  // the last is r
    residual_(x.data(), std::get<sizeof...(others) - 1>(std::tie(others...)));
    return true;
  }

 private:
  Residual residual_;
};

template <typename Residual, int... kBlocks>
ceres::CostFunction* MakeAutomaticCost(Residual residual, std::integer_sequence<int, kBlocks...>) {
  using Functor = AutomaticFunctor<Residual>;
  return new ceres::AutoDiffCostFunction<Functor, Residual::kResiduals, kBlocks...>(
      new Functor(std::move(residual)));
}

template <typename Residual, int... kBlocks>
TangentCost* MakeAnalyticCost(Residual residual, std::integer_sequence<int, kBlocks...>) {
  return new AnalyticCost<Residual, kBlocks...>(std::move(residual));
}

// The one way a residual becomes a cost function of the estimator.
template <typename Residual>
TangentCost* MakeCost(Residual residual) {
  return MakeAnalyticCost(std::move(residual), typename Residual::Blocks());
}

}  // namespace brachium
