#include "solver/least_squares.h"

#include <algorithm>

namespace brachium {
namespace {

// The problem is nearly linear once initialised: start with Gauss-Newton steps, let the trust
// region shrink where that fails.
constexpr double kStartTrustRegion = 1e8;

bool IsGeometry(UnknownKind kind) {
  return kind == UnknownKind::kAccelScale || kind == UnknownKind::kGyroScale ||
         kind == UnknownKind::kSensorPosition || kind == UnknownKind::kJointVector;
}

}  // namespace

ceres::Solver::Summary Solve(const ArmProblem& problem, State& state, const CarriedPrior& prior,
                             int start_knot, int last_knot, const SolveOptions& options) {
  RotationManifold rotation;
  ceres::Problem::Options ownership;
  ownership.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ownership.manifold_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ownership.disable_all_safety_checks = true;
  ceres::Problem least_squares(ownership);

  std::vector<double*> values;
  const auto add = [&](TangentCost* cost, const std::vector<int>& unknowns) {
    values.clear();
    for (const int unknown : unknowns) values.push_back(problem.Value(state, unknown));
    least_squares.AddResidualBlock(cost, nullptr, values);
    for (std::size_t i = 0; i < unknowns.size(); ++i)
      if (problem.Describe(unknowns[i]).kind == UnknownKind::kAttitude &&
          !least_squares.HasManifold(values[i]))
        least_squares.SetManifold(values[i], &rotation);
    if (!options.hold_geometry) return;
    for (std::size_t i = 0; i < unknowns.size(); ++i)
      if (IsGeometry(problem.Describe(unknowns[i]).kind))
        least_squares.SetParameterBlockConstant(values[i]);
  };
  if (prior.cost != nullptr) add(prior.cost.get(), prior.unknowns);
  const auto& terms = problem.terms();
  auto term = std::lower_bound(terms.begin(), terms.end(), start_knot,
                               [](const Term& t, int knot) { return t.first_knot < knot; });
  for (; term != terms.end() && term->first_knot <= last_knot; ++term)
    if (term->last_knot <= last_knot) add(term->cost.get(), term->unknowns);

  ceres::Solver::Options settings;
  settings.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  settings.max_num_iterations = options.most_iterations;
  settings.function_tolerance = options.function_tolerance;
  settings.parameter_tolerance = options.step_tolerance;
  settings.gradient_tolerance = 0.0;
  settings.initial_trust_region_radius = kStartTrustRegion;
  settings.max_trust_region_radius = 1e16;
  settings.num_threads = options.threads;
  settings.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(settings, &least_squares, &summary);
  return summary;
}

}  // namespace brachium
