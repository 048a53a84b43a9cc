#include "solver/residual_sums.h"

#include <cmath>

namespace brachium {
namespace {

std::string NameOf(const ArmProblem& problem, const Term& term) {
  std::string name(Name(term.kind));
  if (term.sensor < 0) return name;
  const Recording& recording =
      problem.observations().recordings[static_cast<std::size_t>(term.sensor)];
  return name.append("/").append(Name(recording.segment));
}

}  // namespace

void ResidualSums::Add(const ArmProblem& problem, State& state, int start_knot, int end_knot) {
  std::vector<const double*> values;
  std::vector<double> r;
  for (const Term& term : problem.terms()) {
    if (term.first_knot < start_knot) continue;
    if (term.first_knot >= end_knot) break;
    values.clear();
    for (const int unknown : term.unknowns) values.push_back(problem.Value(state, unknown));
    r.resize(static_cast<std::size_t>(term.cost->num_residuals()));
    term.cost->Evaluate(values.data(), r.data(), nullptr);
    Sum& sum = sums_[{term.kind, term.sensor}];
    if (sum.count == 0) sum.name = NameOf(problem, term);
    sum.count += r.size();
    for (const double value : r) sum.squares += value * value;
  }
}

void ResidualSums::Add(const ResidualSums& others) {
  for (const auto& [of, other] : others.sums_) {
    Sum& sum = sums_[of];
    sum.name = other.name;
    sum.count += other.count;
    sum.squares += other.squares;
  }
}

std::vector<ResidualStatistics> ResidualSums::Statistics() const {
  std::vector<ResidualStatistics> statistics;
  for (const auto& [of, sum] : sums_)
    statistics.push_back(
        {sum.name, sum.count, std::sqrt(sum.squares / static_cast<double>(sum.count))});
  return statistics;
}

double ResidualScale(const std::vector<ResidualStatistics>& residuals, double unknowns) {
  double count = 0.0, squares = 0.0;
  for (const ResidualStatistics& kind : residuals) {
    count += static_cast<double>(kind.count);
    squares += static_cast<double>(kind.count) * kind.rms * kind.rms;
  }
  return count > unknowns ? std::sqrt(squares / (count - unknowns)) : 1.0;
}

}  // namespace brachium
