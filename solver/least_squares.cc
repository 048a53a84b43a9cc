#include "solver/least_squares.h"

#include "solver/ceres_solver.h"
#include "solver/chain_solver.h"

namespace brachium {

std::optional<SolverKind> SolverNamed(std::string_view name) {
  if (name == "chain") return SolverKind::kChain;
  if (name == "ceres") return SolverKind::kCeres;
  return std::nullopt;
}

SolveSummary Solve(const ArmProblem& problem, State& state, const CarriedPrior& prior,
                   int start_knot, int last_knot, const SolveOptions& options,
                   ChainWorkspace* workspace) {
  const TermRange range{.start_knot = start_knot,
                        .end_knot = options.hand_on ? last_knot : last_knot + 1,
                        .last_knot = last_knot,
                        .hand_on = options.hand_on,
                        .hold_geometry = options.hold_geometry};
  if (options.solver == SolverKind::kCeres) {
    const SolveSummary summary = SolveByCeres(problem, state, prior, range, options);
    if (workspace != nullptr) workspace->Linearise(problem, state, prior, range);
    return summary;
  }
  std::optional<ChainWorkspace> own;
  if (workspace == nullptr) workspace = &own.emplace(problem);
  return SolveChain(problem, state, prior, range, options, *workspace);
}

}  // namespace brachium
