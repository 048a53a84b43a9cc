#include "solver/unmodelled.h"

#include <algorithm>
#include <cmath>
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

// Draws and knots together give the trace to one or two percent.
constexpr int kDrawnKnots = 15000;

using Vectors = std::vector<std::vector<double>>;

// Deviations of all columns of a plan with the covariance of its last pass.
Vectors Draw(int draws, std::mt19937_64& random, ChainWorkspace& workspace) {
  Vectors signs(U(draws), std::vector<double>(U(workspace.plan.columns()))), deviations;
  for (std::vector<double>& row : signs)
    for (double& sign : row) sign = random() & 1 ? 1.0 : -1.0;
  workspace.sweep.Draw(workspace.plan, signs, deviations);
  return deviations;
}

// Takes terms one by one: r, J, and how far r moves with deviations of the unknowns.
class Residuals {
 public:
  Residuals(const ArmProblem& problem, State& state, const FrontPlan& plan, Vectors deviations)
      : problem_(problem), state_(state), plan_(plan), deviations_(std::move(deviations)) {}

  void Add(const Term& term, double& squares, double& redundancy) {
    Linearise(term);
    squares += r_.squaredNorm();
    double moved = 0.0;
    for (const std::vector<double>& deviation : deviations_)
      moved += Moved(term, deviation).squaredNorm();
    redundancy += static_cast<double>(r_.size()) - moved / static_cast<double>(deviations_.size());
  }

 private:
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  void Linearise(const Term& term) {
    r_.resize(term.cost->num_residuals());
    J_.resize(term.unknowns.size());
    values_.clear();
    pointers_.clear();
    for (std::size_t i = 0; i < term.unknowns.size(); ++i) {
      J_[i].resize(r_.size(), TangentSize(problem_.Describe(term.unknowns[i]).Size()));
      values_.push_back(problem_.Value(state_, term.unknowns[i]));
      pointers_.push_back(J_[i].data());
    }
    term.cost->EvaluateTangent(values_.data(), r_.data(), pointers_.data());
  }

  const Eigen::VectorXd& Moved(const Term& term, const std::vector<double>& deviation) {
    moved_.setZero(r_.size());
    for (std::size_t i = 0; i < term.unknowns.size(); ++i) {
      const auto& variable = plan_.variables()[U(plan_.IndexOf(term.unknowns[i]))];
      if (variable.tangent == 0) continue;
      moved_ += J_[i] *
                Eigen::Map<const Eigen::VectorXd>(&deviation[U(variable.column)], variable.tangent);
    }
    return moved_;
  }

  const ArmProblem& problem_;
  State& state_;
  const FrontPlan& plan_;
  Vectors deviations_;
  std::vector<const double*> values_;
  std::vector<double*> pointers_;
  std::vector<Rows> J_;
  Eigen::VectorXd r_, moved_;
};

}  // namespace

UnmodelledSums::UnmodelledSums(const ArmProblem& problem)
    : draws_(kDrawnKnots / problem.size().knots + 1),
      accelerations_(U(problem.size().sensors)),
      quivers_(accelerations_) {}

double UnmodelledSums::Spread::Ratio() const {
  return (squares + kPriorResiduals) / (redundancy + kPriorResiduals);
}

void UnmodelledSums::Add(const ArmProblem& problem, State& state, int first_knot, int last_knot,
                         ChainWorkspace& workspace) {
  Residuals residuals(problem, state, workspace.plan, Draw(draws_, random_, workspace));
  const auto& terms = problem.terms();
  auto term = std::lower_bound(terms.begin(), terms.end(), first_knot,
                               [](const Term& other, int knot) { return other.first_knot < knot; });
  for (; term != terms.end() && term->first_knot <= last_knot; ++term) {
    if (term->last_knot > last_knot) continue;
    const bool accelerates = term->kind == ResidualKind::kAccelerometer;
    if (!accelerates && term->kind != ResidualKind::kSegmentChain) continue;
    Spread& spread = (accelerates ? accelerations_ : quivers_)[U(term->sensor)];
    residuals.Add(*term, spread.squares, spread.redundancy);
  }
}

std::vector<Unmodelled> UnmodelledSums::Estimate(const ArmProblem& problem) const {
  std::vector<Unmodelled> unmodelled;
  const double memory = 2 * problem.options().unmodelled_correlation_s;
  for (std::size_t sensor = 0; sensor < quivers_.size(); ++sensor) {
    const Unmodelled& used = problem.unmodelled()[sensor];
    const double white =
        0.5 * std::pow(problem.observations().recordings[sensor].noise.accel_density, 2);
    const double density = white + memory * used.acceleration * used.acceleration;
    const double variance = (accelerations_[sensor].Ratio() * density - white) / memory;
    unmodelled.push_back(
        {std::sqrt(std::max(variance, kLeastAcceleration * kLeastAcceleration)),
         std::max(std::sqrt(quivers_[sensor].Ratio()) * used.quiver, kLeastQuiver)});
  }
  return unmodelled;
}

}  // namespace brachium
