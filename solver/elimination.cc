#include "solver/elimination.h"

#include <algorithm>

#include "solver/front_factor.h"

namespace brachium {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

std::size_t U(int i) { return static_cast<std::size_t>(i); }

void FillIndex(const FrontPlan& plan, const FrontPlan::Front& front, BlockIndex& index) {
  index.unknowns.clear();
  index.offset.clear();
  index.dimension = front.columns;
  for (const FrontPlan::Member& member : plan.Members(front)) {
    index.unknowns.push_back(plan.variables()[U(member.variable)].unknown);
    index.offset.push_back(member.column);
  }
}

// Σ_SS of a front out of the covariance of the next, by the runs with which that took over.
void TakeOver(std::span<const FrontPlan::Run> runs, const double* next, int stride_next,
              const FrontPlan::Front& front, double* covariance) {
  const int stride = front.Stride();
  for (const FrontPlan::Run& run : runs)
    for (int i = 0; i < run.length; ++i) {
      double* to = covariance + (run.from + i) * stride;
      for (const FrontPlan::Run& other : runs)
        std::copy_n(next + (run.to + i) * stride_next + other.to, other.length, to + other.from);
      std::fill(to + front.columns, to + stride, 0.0);
    }
}

}  // namespace

int BlockIndex::OffsetOf(int unknown) const {
  const auto found = std::find(unknowns.begin(), unknowns.end(), unknown);
  return found == unknowns.end() ? -1 : offset[U(static_cast<int>(found - unknowns.begin()))];
}

Elimination::Elimination(const ArmProblem& problem, State& state, const CarriedPrior& prior,
                         int start_knot, int end_knot, ChainWorkspace& workspace)
    : plan_(workspace.plan), sweep_(workspace.sweep) {
  workspace.Linearise(problem, state, prior,
                      {.start_knot = start_knot,
                       .end_knot = end_knot,
                       .last_knot = problem.size().knots,
                       .hand_on = true});
}

// L of what comes last: L Lᵀ is the information that is left about it, and L y its gradient.
CarriedPrior Elimination::Carry() const {
  const FrontPlan::Front& last = plan_.fronts().back();
  const int kept = plan_.handed_on(), first = last.columns - kept;
  std::vector<int> unknowns, sizes;
  std::vector<double> point;
  for (const FrontPlan::Member& member : plan_.Members(last)) {
    if (member.column < first) continue;
    const FrontPlan::Variable& variable = plan_.variables()[U(member.variable)];
    unknowns.push_back(variable.unknown);
    sizes.push_back(variable.size);
    point.insert(point.end(), variable.value, variable.value + variable.size);
  }
  const Eigen::Map<const MatrixXd, 0, Eigen::OuterStride<>> factor(
      sweep_.LastFactor(), last.Stride(), last.columns, Eigen::OuterStride<>(last.Stride()));
  MatrixXd J = factor.block(first, first, kept, kept).transpose().triangularView<Eigen::Upper>();
  VectorXd r = factor.row(last.columns).segment(first, kept);
  for (int i = 0; i < kept; ++i) {
    if (!sweep_.IsLost(last.first_column + first + i)) continue;
    J.row(i).setZero();
    r[i] = 0.0;
  }
  const Eigen::Map<const VectorXd> point_vector(point.data(),
                                                static_cast<Eigen::Index>(point.size()));
  return {std::make_unique<MarginalPrior>(sizes, point_vector, J, r), unknowns};
}

int Elimination::eliminated() const { return plan_.columns() - plan_.handed_on(); }

void Elimination::VisitCovariances(const Visitor& visit) const {
  const std::size_t widest = U(plan_.widest_stride());
  std::vector<double> here(widest * widest), next(widest * widest), scratch(2 * widest * widest);
  BlockIndex index;
  std::span<const FrontPlan::Run> runs;  // with which the next front took over
  int stride_next = 0;
  sweep_.VisitBackwards(plan_, [&](const FrontPlan::Front& front, const double* L) {
    TakeOver(runs, next.data(), stride_next, front, here.data());
    ExtendCovariance(L, front.Stride(), front.columns, front.eliminated, here.data(),
                     scratch.data());
    FillIndex(plan_, front, index);
    visit(front.knot, index,
          CovarianceView(here.data(), front.columns, front.columns,
                         Eigen::OuterStride<>(front.Stride())));
    runs = plan_.Runs(front);
    stride_next = front.Stride();
    std::swap(here, next);
  });
}

}  // namespace brachium
