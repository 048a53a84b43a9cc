#include "solver/covariance.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "solver/elimination.h"

namespace brachium {
namespace {

std::size_t U(int i) { return static_cast<std::size_t>(i); }

// Of the turn about the vertical of one sensor's segment against the one before it, at the first
// knot, from the covariance of a front that holds both [rad].
double RelativeHeadingSd(const ArmProblem& problem, const State& state, int sensor,
                         const BlockIndex& index, const CovarianceView& covariance) {
  double variance = 0.0;
  for (const int a : {sensor - 1, sensor})
    for (const int b : {sensor - 1, sensor}) {
      const auto up = [&](int i) -> Eigen::Vector3d {
        const Eigen::Map<const Eigen::Quaterniond> q_WB(state.Attitude(0, i));
        return q_WB.conjugate() * Eigen::Vector3d::UnitZ();
      };
      const auto block = covariance.block<3, 3>(index.OffsetOf(problem.Attitude(0, a)),
                                                index.OffsetOf(problem.Attitude(0, b)));
      variance += (a == b ? 1.0 : -1.0) * up(a).dot(block * up(b));
    }
  return std::sqrt(std::max(variance, 0.0));
}

constexpr int kDraws = 50;

}  // namespace

double DrawnSd(ChainWorkspace& workspace, int unknown) {
  const int index = workspace.plan.IndexOf(unknown);
  if (index < 0 || workspace.plan.variables()[U(index)].tangent == 0) return 0.0;
  std::mt19937_64 random(1);
  std::vector<std::vector<double>> signs(1, std::vector<double>(U(workspace.plan.columns()))),
      deviation;
  double squares = 0.0;
  for (int draw = 0; draw < kDraws; ++draw) {
    for (double& sign : signs[0]) sign = random() & 1 ? 1.0 : -1.0;
    workspace.sweep.Draw(workspace.plan, signs, deviation);
    const double moved = deviation[0][U(workspace.plan.variables()[U(index)].column)];
    squares += moved * moved;
  }
  return std::sqrt(squares / kDraws);
}

Certainty AssessCertainty(const ArmProblem& problem, const State& state, ChainWorkspace& workspace,
                          PoseCovariance* poses) {
  const Elimination elimination(workspace);
  Certainty certainty;
  certainty.singular = elimination.singular();
  certainty.root_sd.assign(U(problem.size().knots), 0.0);
  certainty.start_heading_sd.assign(U(problem.size().sensors), 0.0);
  elimination.VisitCovariances(
      [&](int knot, const BlockIndex& index, const CovarianceView& covariance) {
        for (const int unknown : index.unknowns) {
          const Unknown u = problem.Describe(unknown);
          const auto variance = covariance.diagonal().segment(index.OffsetOf(unknown), u.Tangent());
          if (u.place < 0 || u.kind == UnknownKind::kGyroBias)
            certainty.constant_sd.try_emplace(unknown, variance.cwiseSqrt());
          if (u.kind == UnknownKind::kRoot && u.sensor == problem.size().roots - 1)
            certainty.root_sd[U(u.place)] = std::sqrt(variance.maxCoeff());
        }
        if (poses != nullptr) poses->Collect(knot, index, covariance);
        for (int sensor = 1; knot == 0 && sensor < problem.size().sensors; ++sensor)
          certainty.start_heading_sd[U(sensor)] =
              RelativeHeadingSd(problem, state, sensor, index, covariance);
      });
  return certainty;
}

}  // namespace brachium
