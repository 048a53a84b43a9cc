#include "solver/covariance.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "solver/elimination.h"

namespace brachium {
namespace {

std::size_t U(int i) { return static_cast<std::size_t>(i); }

// The estimate of an unmodelled acceleration starts as if this many residuals had confirmed the
// first guess: a short or poorly linked trial keeps it.
constexpr double kPriorResiduals = 30.0;

// Weighted residuals of one sensor's accelerometer: their squares, their redundancy, how many
// intervals they stand for and how long those are together [s].
struct Spread {
  double squares = 0.0, redundancy = 0.0, duration = 0.0, count = 0.0;
};

// Adds up what terms say of their sensor.
class Spreads {
 public:
  Spreads(const ArmProblem& problem, State& state)
      : problem_(problem), state_(state), spreads_(U(problem.size().sensors)) {}

  // r and the trace of J Σ Jᵀ = <JᵀJ, Σ> of one term, Σ being the covariance of a front that holds
  // it.
  void Add(const Term& term, const BlockIndex& index, const CovarianceView& covariance) {
    blocks_.clear();
    int columns = 0;
    for (const int unknown : term.unknowns) {
      const int tangent = problem_.Describe(unknown).Tangent();
      blocks_.push_back(
          {problem_.Value(state_, unknown), -1, tangent, columns, index.OffsetOf(unknown)});
      columns += tangent;
    }
    const int rows = term.cost->num_residuals();
    square_.Reserve(rows, static_cast<int>(blocks_.size()), columns);
    square_.Linearise(*term.cost, term.loss.get(), blocks_, columns);
    const int* place = square_.PlacesInFront();
    double trace = 0.0;
    for (int column = 0; column < columns; ++column) {
      const double* JtJ = square_.Column(column);
      const double* sigma = covariance.data() + place[column] * covariance.outerStride();
      double below = 0.0;
      for (int row = column + 1; row < columns; ++row) below += JtJ[row] * sigma[place[row]];
      trace += JtJ[column] * sigma[place[column]] + 2 * below;
    }
    Spread& spread = spreads_[U(term.sensor)];
    spread.squares += square_.Column(columns)[columns];
    spread.redundancy += rows - trace;
    spread.duration += problem_.Interval(term.first_knot, term.sensor).duration;
    spread.count += 1.0;
  }

  const Spread& Of(int sensor) const { return spreads_[U(sensor)]; }

 private:
  const ArmProblem& problem_;
  State& state_;
  std::vector<Spread> spreads_;
  std::vector<TermBlock> blocks_;
  TermSquare square_;
};

}  // namespace

Certainty AssessCertainty(const ArmProblem& problem, State& state, ChainWorkspace* workspace) {
  std::optional<ChainWorkspace> own;
  if (workspace == nullptr) workspace = &own.emplace(problem);
  const int past_end = problem.size().knots;
  const Elimination elimination(problem, state, {}, 0, past_end, *workspace);

  Certainty certainty;
  certainty.singular = elimination.singular();
  certainty.root_sd.assign(U(problem.size().knots), 0.0);
  Spreads spreads(problem, state);
  const auto& terms = problem.terms();
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
        auto term = std::lower_bound(terms.begin(), terms.end(), knot,
                                     [](const Term& t, int at) { return t.first_knot < at; });
        for (; term != terms.end() && term->first_knot == knot; ++term)
          if (term->kind == ResidualKind::kAccelerometer) spreads.Add(*term, index, covariance);
      });

  const auto& options = problem.options();
  for (int sensor = 0; sensor < problem.size().sensors; ++sensor) {
    const Spread& spread = spreads.Of(sensor);
    const double white =
        0.5 * std::pow(problem.observations().recordings[U(sensor)].noise.accel_density, 2);
    const double used = problem.unmodelled_acceleration()[U(sensor)];
    const double density = white + 2 * options.unmodelled_correlation_s * used * used;
    const double ratio = (spread.squares + kPriorResiduals) / (spread.redundancy + kPriorResiduals);
    // What is left out lasts longer than an interval, so its size is what an interval shows; its
    // weight at lower frequencies then follows from how long it lasts.
    const double memory = std::min(2 * options.unmodelled_correlation_s,
                                   spread.duration / std::max(spread.count, 1.0));
    const double variance = (ratio * density - white) / memory;
    certainty.unmodelled_acceleration.push_back(std::sqrt(std::max(variance, 1e-6)));
  }
  return certainty;
}

}  // namespace brachium
