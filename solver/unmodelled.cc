#include "solver/unmodelled.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

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
constexpr int kDrawnKnots = 30000;

// Deviations of all columns of a plan with the covariance of its last pass.
std::vector<std::vector<double>> Draw(ChainWorkspace& workspace) {
  const int draws = kDrawnKnots / std::max(1, static_cast<int>(workspace.plan.fronts().size())) + 1;
  std::mt19937_64 random(1);
  std::vector<double> signs(U(workspace.plan.columns()));
  std::vector<std::vector<double>> deviations(U(draws));
  for (std::vector<double>& deviation : deviations) {
    for (double& sign : signs) sign = random() & 1 ? 1.0 : -1.0;
    workspace.sweep.Draw(workspace.plan, signs, deviation);
  }
  return deviations;
}

// Weighted residuals of one kind: their squares, and how many of them the unknowns do not take up.
struct Spread {
  double squares = 0.0, redundancy = 0.0;

  // Estimated over assumed variance.
  double Ratio() const { return (squares + kPriorResiduals) / (redundancy + kPriorResiduals); }
};

// Takes terms one by one: r, J, and how far r moves with deviations of the unknowns.
class Residuals {
 public:
  Residuals(const ArmProblem& problem, State& state, ChainWorkspace& workspace)
      : problem_(problem), state_(state), plan_(workspace.plan), deviations_(Draw(workspace)) {}

  void Add(const Term& term, Spread& spread) {
    Linearise(term);
    spread.squares += r_.squaredNorm();
    double moved = 0.0;
    for (const std::vector<double>& deviation : deviations_)
      moved += Moved(term, deviation).squaredNorm();
    spread.redundancy +=
        static_cast<double>(r_.size()) - moved / static_cast<double>(deviations_.size());
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
  std::vector<std::vector<double>> deviations_;
  std::vector<const double*> values_;
  std::vector<double*> pointers_;
  std::vector<Rows> J_;
  Eigen::VectorXd r_, moved_;
};

// Of one sensor, given what was assumed.
Unmodelled Estimated(const ArmProblem& problem, int sensor, const Spread& acceleration,
                     const Spread& quiver) {
  const double white =
      0.5 * std::pow(problem.observations().recordings[U(sensor)].noise.accel_density, 2);
  const Unmodelled& used = problem.unmodelled()[U(sensor)];
  const double memory = 2 * problem.options().unmodelled_correlation_s;
  const double density = white + memory * used.acceleration * used.acceleration;
  const double variance = (acceleration.Ratio() * density - white) / memory;
  return {std::sqrt(std::max(variance, kLeastAcceleration * kLeastAcceleration)),
          std::max(std::sqrt(quiver.Ratio()) * used.quiver, kLeastQuiver)};
}

}  // namespace

std::vector<Unmodelled> EstimateUnmodelled(const ArmProblem& problem, State& state,
                                           ChainWorkspace& workspace) {
  Residuals residuals(problem, state, workspace);
  std::vector<Spread> accelerations(U(problem.size().sensors)), quivers(accelerations);
  for (const Term& term : problem.terms()) {
    if (term.kind == ResidualKind::kAccelerometer)
      residuals.Add(term, accelerations[U(term.sensor)]);
    if (term.kind == ResidualKind::kSegmentChain) residuals.Add(term, quivers[U(term.sensor)]);
  }
  std::vector<Unmodelled> unmodelled;
  for (int sensor = 0; sensor < problem.size().sensors; ++sensor)
    unmodelled.push_back(Estimated(problem, sensor, accelerations[U(sensor)], quivers[U(sensor)]));
  return unmodelled;
}

}  // namespace brachium
