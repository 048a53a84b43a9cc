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

// Adds up what accelerometers and chain say of each sensor.
class Spreads {
 public:
  Spreads(const ArmProblem& problem, State& state)
      : problem_(problem),
        state_(state),
        accelerations_(U(problem.size().sensors)),
        quivers_(accelerations_) {}

  static bool Counts(const Term& term) {
    return term.kind == ResidualKind::kAccelerometer || term.kind == ResidualKind::kSegmentChain;
  }

  // Of a term that counts: r and the trace of J Σ Jᵀ = <JᵀJ, Σ>, Σ being the covariance of a front
  // that holds it.
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
    Spread& spread = SpreadOf(term);
    spread.squares += square_.Column(columns)[columns];
    spread.redundancy += rows - trace;
  }

  const Spread& Acceleration(int sensor) const { return accelerations_[U(sensor)]; }
  const Spread& Quiver(int sensor) const { return quivers_[U(sensor)]; }

 private:
  Spread& SpreadOf(const Term& term) {
    return (term.kind == ResidualKind::kAccelerometer ? accelerations_ : quivers_)[U(term.sensor)];
  }

  const ArmProblem& problem_;
  State& state_;
  std::vector<Spread> accelerations_, quivers_;
  std::vector<TermBlock> blocks_;
  TermSquare square_;
};

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

}  // namespace

Certainty AssessCertainty(const ArmProblem& problem, State& state, ChainWorkspace* workspace) {
  std::optional<ChainWorkspace> own;
  if (workspace == nullptr) workspace = &own.emplace(problem);
  const int past_end = problem.size().knots;
  const Elimination elimination(problem, state, {}, 0, past_end, *workspace);

  Certainty certainty;
  certainty.singular = elimination.singular();
  certainty.root_sd.assign(U(problem.size().knots), 0.0);
  certainty.start_heading_sd.assign(U(problem.size().sensors), 0.0);
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
        for (int sensor = 1; knot == 0 && sensor < problem.size().sensors; ++sensor)
          certainty.start_heading_sd[U(sensor)] =
              RelativeHeadingSd(problem, state, sensor, index, covariance);
        auto term = std::lower_bound(terms.begin(), terms.end(), knot,
                                     [](const Term& t, int at) { return t.first_knot < at; });
        for (; term != terms.end() && term->first_knot == knot; ++term)
          if (Spreads::Counts(*term)) spreads.Add(*term, index, covariance);
      });

  const auto& options = problem.options();
  for (int sensor = 0; sensor < problem.size().sensors; ++sensor) {
    const double white =
        0.5 * std::pow(problem.observations().recordings[U(sensor)].noise.accel_density, 2);
    const Unmodelled& used = problem.unmodelled()[U(sensor)];
    const double memory = 2 * options.unmodelled_correlation_s;
    const double density = white + memory * used.acceleration * used.acceleration;
    const double variance = (spreads.Acceleration(sensor).Ratio() * density - white) / memory;
    certainty.unmodelled.push_back(
        {std::sqrt(std::max(variance, kLeastAcceleration * kLeastAcceleration)),
         std::max(std::sqrt(spreads.Quiver(sensor).Ratio()) * used.quiver, kLeastQuiver)});
  }
  return certainty;
}

}  // namespace brachium
