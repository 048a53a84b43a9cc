#include "solver/unmodelled.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

namespace brachium {
namespace {

std::size_t U(int i) { return static_cast<std::size_t>(i); }

constexpr double kPriorResiduals = 30.0;

// No model of a worn sensor is better than this. A quiver far below the gyroscope's own noise at the
// end of a lever arm would make fast, tiny vibration outvote slow movement, and since the rates that
// it is predicted from are noisy themselves, shrink the lever arms.
constexpr double kLeastAcceleration = 1e-3;  // [m/s²]
constexpr double kLeastQuiver = 1e-4;        // [m]

// Draws and knots together give the trace to two percent: the residuals of a minute tell their own
// variance no better.
constexpr int kDrawnKnots = 6000;

constexpr std::size_t kMostColumns = 3;  // of a block's Jacobian

double SquaredNorm(const std::vector<double>& numbers) {
  return std::inner_product(numbers.begin(), numbers.end(), numbers.begin(), 0.0);
}

using Vectors = std::vector<std::vector<double>>;

// Deviations of all columns of a plan with the covariance of its last pass.
Vectors Draw(int draws, std::mt19937_64& random, ChainWorkspace& workspace) {
  Vectors signs(U(draws), std::vector<double>(U(workspace.plan.columns()))), deviations;
  std::uint64_t bits = 0;
  int left = 0;
  for (std::vector<double>& row : signs)
    for (double& sign : row) {
      if (left == 0) bits = random(), left = std::mt19937_64::word_size;
      sign = bits >> --left & 1 ? 1.0 : -1.0;
    }
  workspace.sweep.Draw(workspace.plan, signs, deviations);
  return deviations;
}

// Takes terms one by one: r, J, and how far r moves with deviations of the unknowns.
class Residuals {
 public:
  Residuals(const FrontPlan& plan, Vectors deviations)
      : plan_(plan), deviations_(std::move(deviations)) {}

  void Add(const Term& term, double& squares, double& redundancy) {
    Linearise(term);
    squares += SquaredNorm(r_);
    double moved = 0.0;
    for (const std::vector<double>& deviation : deviations_) moved += MovedSquared(deviation);
    redundancy += static_cast<double>(r_.size()) - moved / static_cast<double>(deviations_.size());
  }

 private:
  void Linearise(const Term& term) {
    const auto rows = static_cast<std::size_t>(term.cost->num_residuals());
    const std::size_t blocks = term.unknowns.size();
    r_.resize(rows);
    values_.resize(blocks);
    variables_.resize(blocks);
    pointers_.resize(blocks);
    jacobians_.resize(rows * kMostColumns * blocks);
    for (std::size_t i = 0; i < blocks; ++i) {
      variables_[i] = &plan_.variables()[U(plan_.IndexOf(term.unknowns[i]))];
      values_[i] = variables_[i]->value;
      pointers_[i] = &jacobians_[rows * kMostColumns * i];
    }
    term.cost->EvaluateTangent(values_.data(), r_.data(), pointers_.data());
  }

  // |J ξ|².
  double MovedSquared(const std::vector<double>& deviation) {
    moved_.assign(r_.size(), 0.0);
    for (std::size_t i = 0; i < variables_.size(); ++i) {
      const int columns = variables_[i]->tangent;
      if (columns == 0) continue;
      const double *J = pointers_[i], *d = &deviation[U(variables_[i]->column)];
      if (columns == 3)
        for (double& moved : moved_) moved += J[0] * d[0] + J[1] * d[1] + J[2] * d[2], J += 3;
      else
        for (double& moved : moved_)
          for (int column = 0; column < columns; ++column) moved += *J++ * d[column];
    }
    return SquaredNorm(moved_);
  }

  const FrontPlan& plan_;
  Vectors deviations_;
  std::vector<const double*> values_;
  std::vector<const FrontPlan::Variable*> variables_;
  std::vector<double*> pointers_;
  std::vector<double> jacobians_, r_, moved_;
};

}  // namespace

UnmodelledSums::Densities::Densities(const ArmProblem& problem)
    : memory(2 * problem.options().unmodelled_correlation_s) {
  for (const Recording& recording : problem.observations().recordings)
    white.push_back(0.5 * recording.noise.accel_density * recording.noise.accel_density);
}

double UnmodelledSums::Densities::Of(std::size_t sensor, double acceleration) const {
  return white[sensor] + memory * acceleration * acceleration;
}

double UnmodelledSums::Densities::AccelerationOf(std::size_t sensor, double density) const {
  const double variance = (density - white[sensor]) / memory;
  return std::sqrt(std::max(variance, kLeastAcceleration * kLeastAcceleration));
}

UnmodelledSums::UnmodelledSums(const ArmProblem& problem)
    : densities_(problem), draws_(kDrawnKnots / problem.size().knots + 1) {
  for (std::size_t sensor = 0; sensor < problem.unmodelled().size(); ++sensor) {
    const Unmodelled& guess = problem.unmodelled()[sensor];
    const double density = densities_.Of(sensor, guess.acceleration);
    accelerations_.push_back({kPriorResiduals * density, kPriorResiduals});
    quivers_.push_back({kPriorResiduals * guess.quiver * guess.quiver, kPriorResiduals});
  }
}

// Draws through a factor that is nearly singular may leave less than was thrown in, or nothing.
double UnmodelledSums::Spread::Variance() const {
  return squares / (redundancy > kPriorResiduals ? redundancy : kPriorResiduals);
}

void UnmodelledSums::Add(const ArmProblem& problem, int start_knot, int end_knot,
                         ChainWorkspace& workspace) {
  Residuals residuals(workspace.plan, Draw(draws_, random_, workspace));
  const auto& terms = problem.terms();
  auto term = std::lower_bound(terms.begin(), terms.end(), start_knot,
                               [](const Term& other, int knot) { return other.first_knot < knot; });
  for (; term != terms.end() && term->first_knot < end_knot; ++term) {
    const bool accelerates = term->kind == ResidualKind::kAccelerometer;
    if (!accelerates && term->kind != ResidualKind::kSegmentChain) continue;
    const std::size_t sensor = U(term->sensor);
    const Unmodelled& used = problem.unmodelled()[sensor];
    const double variance =
        accelerates ? densities_.Of(sensor, used.acceleration) : used.quiver * used.quiver;
    Spread& spread = (accelerates ? accelerations_ : quivers_)[sensor];
    double squares = 0.0;
    residuals.Add(*term, squares, spread.redundancy);
    spread.squares += squares * variance;
  }
}

std::vector<Unmodelled> UnmodelledSums::Estimate() const {
  std::vector<Unmodelled> unmodelled;
  for (std::size_t sensor = 0; sensor < quivers_.size(); ++sensor)
    unmodelled.push_back({densities_.AccelerationOf(sensor, accelerations_[sensor].Variance()),
                          std::max(std::sqrt(quivers_[sensor].Variance()), kLeastQuiver)});
  return unmodelled;
}

}  // namespace brachium
