#include "solver/ceres_solver.h"

#include <ceres/ceres.h>

#include <algorithm>

namespace brachium {
namespace {

// The problem is nearly linear once initialised: start with Gauss-Newton steps, let the trust
// region shrink where that fails.
constexpr double kStartTrustRegion = 1e8;

// Ends the search by the size of the step in standard deviations: half its square is what the cost
// was foretold to fall by.
class StepInStandardDeviations final : public ceres::IterationCallback {
 public:
  explicit StepInStandardDeviations(const SolveOptions& options) : options_(options) {}

  ceres::CallbackReturnType operator()(const ceres::IterationSummary& iteration) override {
    if (iteration.iteration == 0 || !iteration.step_is_successful ||
        iteration.trust_region_radius < kStartTrustRegion)
      return ceres::SOLVER_CONTINUE;
    const double foretold = iteration.cost_change / iteration.relative_decrease;
    const bool is_last = 2 * foretold <= options_.step_in_sd * options_.step_in_sd ||
                         foretold <= options_.least_decrease * iteration.cost;
    return is_last ? ceres::SOLVER_TERMINATE_SUCCESSFULLY : ceres::SOLVER_CONTINUE;
  }

 private:
  const SolveOptions& options_;
};

class CeresProblem {
 public:
  CeresProblem(const ArmProblem& problem, State& state, bool hold_geometry)
      : problem_(problem),
        state_(state),
        hold_geometry_(hold_geometry),
        least_squares_(OwnedElsewhere()) {}

  void Add(TangentCost* cost, ceres::LossFunction* loss, const std::vector<int>& unknowns) {
    values_.clear();
    for (const int unknown : unknowns) values_.push_back(problem_.Value(state_, unknown));
    least_squares_.AddResidualBlock(cost, loss, values_);
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
      const Unknown unknown = problem_.Describe(unknowns[i]);
      if (unknown.kind == UnknownKind::kAttitude && !least_squares_.HasManifold(values_[i]))
        least_squares_.SetManifold(values_[i], &rotation_);
      if (unknown.held || (hold_geometry_ && IsGeometry(unknown.kind)))
        least_squares_.SetParameterBlockConstant(values_[i]);
    }
  }

  ceres::Problem* get() { return &least_squares_; }

 private:
  static ceres::Problem::Options OwnedElsewhere() {
    ceres::Problem::Options options;
    options.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    options.manifold_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    options.disable_all_safety_checks = true;
    return options;
  }

  const ArmProblem& problem_;
  State& state_;
  bool hold_geometry_;
  RotationManifold rotation_;
  ceres::Problem least_squares_;
  std::vector<double*> values_;
};

}  // namespace

SolveSummary SolveByCeres(const ArmProblem& problem, State& state, const CarriedPrior& prior,
                          const TermRange& range, const SolveOptions& options) {
  CeresProblem least_squares(problem, state, range.hold_geometry);
  if (prior.cost != nullptr) least_squares.Add(prior.cost.get(), nullptr, prior.unknowns);
  const auto& terms = problem.terms();
  auto term = std::lower_bound(terms.begin(), terms.end(), range.start_knot,
                               [](const Term& other, int knot) { return other.first_knot < knot; });
  for (; term != terms.end() && term->first_knot < range.end_knot; ++term)
    if (term->last_knot <= range.last_knot)
      least_squares.Add(term->cost.get(), term->loss.get(), term->unknowns);

  StepInStandardDeviations small_step(options);
  ceres::Solver::Options settings;
  settings.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  settings.max_num_iterations = options.most_iterations;
  settings.callbacks.push_back(&small_step);
  settings.function_tolerance = 1e-15;
  settings.parameter_tolerance = 1e-12;
  settings.gradient_tolerance = 0.0;
  settings.initial_trust_region_radius = kStartTrustRegion;
  settings.max_trust_region_radius = 1e16;
  settings.num_threads = options.threads;
  settings.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(settings, least_squares.get(), &summary);
  return {.iterations = static_cast<int>(summary.iterations.size()) - 1,
          .initial_cost = summary.initial_cost,
          .final_cost = summary.final_cost,
          .gradient_norm =
              summary.iterations.empty() ? 0.0 : summary.iterations.back().gradient_max_norm,
          .converged = summary.termination_type == ceres::CONVERGENCE ||
                       summary.termination_type == ceres::USER_SUCCESS,
          .message = summary.message};
}

}  // namespace brachium
