#include "solver/covariance.h"

#include <algorithm>
#include <cmath>

#include "solver/elimination.h"

namespace brachium {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

std::size_t U(int i) { return static_cast<std::size_t>(i); }

// The estimate of an unmodelled acceleration starts as if this many residuals had confirmed the
// first guess: a short or poorly linked trial keeps it.
constexpr double kPriorResiduals = 30.0;

// No model of a worn sensor is better than this. A quiver far below the gyroscope's own noise at the
// end of a lever arm would make fast, tiny vibration outvote slow movement, and since the rates that
// it is predicted from are noisy themselves, shrink the lever arms.
constexpr double kLeastAcceleration = 1e-3;  // [m/s²]
constexpr double kLeastQuiver = 1e-4;        // [m]

// Weighted residuals of one kind: their squares, and how many of them the unknowns do not take up.
struct Spread {
  double squares = 0.0, redundancy = 0.0;

  // Estimated over assumed variance.
  double Ratio() const { return (squares + kPriorResiduals) / (redundancy + kPriorResiduals); }
};

// r and the trace of J Σ Jᵀ of one term, Σ being the covariance of a front that holds it.
void AddTerm(const ArmProblem& problem, State& state, const Term& term, const BlockIndex& index,
             const MatrixXd& covariance, Spread& spread) {
  const int rows = term.cost->num_residuals();
  std::vector<const double*> values;
  std::vector<int> offsets, sizes;
  int columns = 0;
  for (const int unknown : term.unknowns) {
    values.push_back(problem.Value(state, unknown));
    sizes.push_back(problem.Describe(unknown).Tangent());
    offsets.push_back(index.OffsetOf(unknown));
    columns += sizes.back();
  }
  std::vector<double> memory(U(rows * columns));
  std::vector<double*> jacobians;
  int place = 0;
  for (const int size : sizes) {
    jacobians.push_back(memory.data() + place);
    place += rows * size;
  }
  VectorXd r(rows);
  term.cost->EvaluateTangent(values.data(), r.data(), jacobians.data());
  MatrixXd J(rows, columns), S(columns, columns);
  int at = 0;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    J.middleCols(at, sizes[i]) =
        Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
            jacobians[i], rows, sizes[i]);
    int to = 0;
    for (std::size_t j = 0; j < sizes.size(); ++j) {
      S.block(at, to, sizes[i], sizes[j]) =
          covariance.block(offsets[i], offsets[j], sizes[i], sizes[j]);
      to += sizes[j];
    }
    at += sizes[i];
  }
  spread.squares += r.squaredNorm();
  spread.redundancy += rows - (J * S).cwiseProduct(J).sum();
}

}  // namespace

Certainty AssessCertainty(const ArmProblem& problem, State& state) {
  Elimination::Workspace workspace;
  const int past_end = problem.size().knots;
  const Elimination elimination(problem, state, {}, 0, past_end, true, workspace);

  Certainty certainty;
  certainty.singular = elimination.singular();
  certainty.root_sd.assign(U(problem.size().knots), 0.0);
  std::vector<Spread> accelerations(U(problem.size().sensors)), quivers(accelerations);
  const auto& terms = problem.terms();
  elimination.VisitCovariances([&](int knot, const BlockIndex& index, const MatrixXd& covariance) {
    for (const int unknown : index.unknowns) {
      const Unknown u = problem.Describe(unknown);
      const auto variance = covariance.diagonal().segment(index.OffsetOf(unknown), u.Tangent());
      if (u.place < 0 || u.kind == UnknownKind::kGyroBias)
        certainty.constant_sd.try_emplace(unknown, variance.cwiseSqrt());
      if (u.kind == UnknownKind::kRoot && u.sensor == problem.size().roots - 1)
        certainty.root_sd[U(u.place)] = std::sqrt(variance.maxCoeff());
    }
    auto term = std::lower_bound(terms.begin(), terms.end(), knot,
                                 [](const Term& t, int at) { return t.first_knot < at; });
    for (; term != terms.end() && term->first_knot == knot; ++term) {
      if (term->kind == ResidualKind::kAccelerometer)
        AddTerm(problem, state, *term, index, covariance, accelerations[U(term->sensor)]);
      if (term->kind == ResidualKind::kSegmentChain)
        AddTerm(problem, state, *term, index, covariance, quivers[U(term->sensor)]);
    }
  });

  const auto& options = problem.options();
  for (int sensor = 0; sensor < problem.size().sensors; ++sensor) {
    const double white =
        0.5 * std::pow(problem.observations().recordings[U(sensor)].noise.accel_density, 2);
    const Unmodelled& used = problem.unmodelled()[U(sensor)];
    const double memory = 2 * options.unmodelled_correlation_s;
    const double density = white + memory * used.acceleration * used.acceleration;
    const double variance = (accelerations[U(sensor)].Ratio() * density - white) / memory;
    certainty.unmodelled.push_back(
        {std::sqrt(std::max(variance, kLeastAcceleration * kLeastAcceleration)),
         std::max(std::sqrt(quivers[U(sensor)].Ratio()) * used.quiver, kLeastQuiver)});
  }
  return certainty;
}

}  // namespace brachium
