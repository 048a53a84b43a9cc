#include "solver/front_sweep.h"

#include <algorithm>
#include <cmath>

#include "solver/front_factor.h"

namespace brachium {
namespace {

std::size_t U(int i) { return static_cast<std::size_t>(i); }

// A pivot that loses this many digits against the diagonal of JᵀJ is not determined.
constexpr double kSingular = 1e-13;

// Damping leaves no pivot below this share of what it adds, rounding apart.
constexpr double kShareOfDamping = 1e-3;

// The diagonal that damping multiplies is kept away from nothing and from infinity.
double Clamped(double diagonal) { return std::clamp(diagonal, 1e-6, 1e32); }

}  // namespace

bool FrontSweep::Sums::IsFinite() const {
  return std::isfinite(cost) && std::isfinite(length_2) && std::isfinite(gradient_norm);
}

void FrontSweep::Prepare(const FrontPlan& plan) {
  const std::size_t columns = U(plan.columns()), widest = U(plan.widest_stride());
  factors_.resize(plan.storage());
  diagonal_.resize(columns);
  gradient_.resize(columns);
  front_.resize(widest * widest);
  before_.resize(widest * widest);
  least_.resize(widest);
  y_.resize(widest);
  d_.resize(widest);
  term_.Reserve(plan.most_residuals(), plan.most_blocks(), plan.widest_term());
}

FrontSweep::Sums FrontSweep::Run(const FrontPlan& plan, double damping) {
  damping_ = damping;
  lost_.clear();
  std::fill(diagonal_.begin(), diagonal_.end(), 0.0);
  std::fill(gradient_.begin(), gradient_.end(), 0.0);
  Sums sums;
  long double cost = 0.0;  // of very many terms, compared to the last digits
  int stride_before = 0;
  for (const FrontPlan::Front& front : plan.fronts()) {
    TakeOver(plan, front, stride_before);
    for (const FrontPlan::PlannedTerm& term : plan.Terms(front)) cost += AddTerm(plan, front, term);
    if (Eliminate(front)) lost_.push_back(static_cast<int>(&front - plan.fronts().data()));
    const double* y = Factor(front) + front.columns;
    for (int k = 0; k < front.eliminated; ++k, y += front.Stride()) sums.length_2 += *y * *y;
    stride_before = front.Stride();
    std::swap(front_, before_);
  }
  sums.cost = static_cast<double>(cost);
  for (const double g : gradient_) sums.gradient_norm = std::max(sums.gradient_norm, std::abs(g));
  return sums;
}

// Empties the front and puts into it what the last one handed on.
void FrontSweep::TakeOver(const FrontPlan& plan, const FrontPlan::Front& front, int stride_before) {
  const int stride = front.Stride();
  for (int column = 0; column < front.columns; ++column)
    std::fill_n(&front_[U(column * stride + column)], stride - column, 0.0);
  const auto runs = plan.Runs(front);
  if (runs.empty()) return;
  const int gradient_before = runs.back().from + runs.back().length;  // the row below the last
  for (std::size_t j = 0; j < runs.size(); ++j) {
    for (int i = 0; i < runs[j].length; ++i) {
      const double* from = &before_[U((runs[j].from + i) * stride_before)];
      double* to = &front_[U((runs[j].to + i) * stride)];
      std::copy_n(from + runs[j].from + i, runs[j].length - i, to + runs[j].to + i);
      for (std::size_t below = j + 1; below < runs.size(); ++below)
        std::copy_n(from + runs[below].from, runs[below].length, to + runs[below].to);
      to[front.columns] = from[gradient_before];
    }
  }
}

// Adds Jᵀ [J r] of one term; returns its cost.
double FrontSweep::AddTerm(const FrontPlan& plan, const FrontPlan::Front& front,
                           const FrontPlan::PlannedTerm& term) {
  const auto blocks = plan.Blocks(term);
  const int columns = term.columns, stride = front.Stride();
  const double cost = term_.Linearise(*term.cost, term.loss, blocks, columns);
  const int* place = term_.PlacesInFront();
  for (int column = 0; column < columns; ++column) {
    const double* from = term_.Column(column);
    double* to = &front_[U(place[column] * stride)];
    for (int row = column; row < columns; ++row) to[place[row]] += from[row];
    to[front.columns] += from[columns];
  }
  for (const TermBlock& block : blocks) {
    if (block.place < 0) continue;
    const int at = plan.variables()[U(block.variable)].column;
    for (int k = 0; k < block.tangent; ++k) {
      const double* from = term_.Column(block.place + k);
      diagonal_[U(at + k)] += from[block.place + k];
      gradient_[U(at + k)] += from[columns];
    }
  }
  return cost;
}

bool FrontSweep::Eliminate(const FrontPlan::Front& front) {
  const int stride = front.Stride();
  const double lost = damping_ > 0.0 ? kShareOfDamping * damping_ : kSingular;
  for (int k = 0; k < front.eliminated; ++k) {
    const double diagonal = diagonal_[U(front.first_column + k)];
    front_[U(k * stride + k)] += damping_ * Clamped(diagonal);
    least_[U(k)] = lost * std::max(diagonal, 1e-9);
  }
  const int raised =
      FactorFront(front_.data(), stride, front.columns, front.eliminated, least_.data());
  bool is_lost = raised > 0;
  for (int k = 0; k < front.eliminated; ++k) {
    const double root = front_[U(k * stride + k)];
    is_lost = is_lost || root * root < kSingular * diagonal_[U(front.first_column + k)];
  }
  std::copy_n(front_.data(), front.eliminated * stride, factors_.data() + front.storage);
  return is_lost;
}

std::vector<int> FrontSweep::Undetermined(const FrontPlan& plan) const {
  std::vector<int> unknowns;
  for (const int front : lost_)
    for (const FrontPlan::Member& member : plan.Members(plan.fronts()[U(front)]))
      if (member.column < plan.fronts()[U(front)].eliminated)
        unknowns.push_back(plan.variables()[U(member.variable)].unknown);
  return unknowns;
}

double FrontSweep::Step(const FrontPlan& plan, std::vector<double>& step) {
  step.resize(U(plan.columns()));
  double decrease = 0.0;
  for (auto front = plan.fronts().rbegin(); front != plan.fronts().rend(); ++front) {
    GatherKept(plan, *front, step);
    const double* L = Factor(*front);
    for (int k = 0; k < front->eliminated; ++k) y_[U(k)] = L[k * front->Stride() + front->columns];
    BackSubstitute(L, front->Stride(), front->columns, front->eliminated, y_.data(), d_.data());
    for (int k = 0; k < front->eliminated; ++k) {
      const double y = y_[U(k)], d = d_[U(k)];
      const std::size_t column = U(front->first_column + k);
      decrease += 0.5 * (y * y + damping_ * Clamped(diagonal_[column]) * d * d);
      step[column] = d;
    }
  }
  return decrease;
}

void FrontSweep::Draw(const FrontPlan& plan, const std::vector<double>& signs,
                      std::vector<double>& deviation) {
  deviation.resize(U(plan.columns()));
  for (auto front = plan.fronts().rbegin(); front != plan.fronts().rend(); ++front) {
    GatherKept(plan, *front, deviation);
    BackSubstitute(Factor(*front), front->Stride(), front->columns, front->eliminated,
                   &signs[U(front->first_column)], d_.data());
    std::copy_n(d_.data(), front->eliminated, &deviation[U(front->first_column)]);
  }
}

// What a front does not eliminate, into d_.
void FrontSweep::GatherKept(const FrontPlan& plan, const FrontPlan::Front& front,
                            const std::vector<double>& columns) {
  for (const FrontPlan::Member& member : plan.Members(front)) {
    if (member.column < front.eliminated) continue;
    const FrontPlan::Variable& variable = plan.variables()[U(member.variable)];
    std::copy_n(&columns[U(variable.column)], variable.tangent, &d_[U(member.column)]);
  }
}

Eigen::MatrixXd FrontSweep::KeptInformation(const FrontPlan& plan) const {
  if (plan.fronts().empty()) return {};
  const FrontPlan::Front& last = plan.fronts().back();
  const int kept = last.columns - last.eliminated;
  const Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>> H(
      before_.data(), last.columns, last.columns, Eigen::OuterStride<>(last.Stride()));
  return H.bottomRightCorner(kept, kept).selfadjointView<Eigen::Lower>();
}

Eigen::VectorXd FrontSweep::KeptGradient(const FrontPlan& plan) const {
  if (plan.fronts().empty()) return {};
  const FrontPlan::Front& last = plan.fronts().back();
  Eigen::VectorXd g(last.columns - last.eliminated);
  for (int k = 0; k < g.size(); ++k)
    g[k] = before_[U((last.eliminated + k) * last.Stride() + last.columns)];
  return g;
}

void ChainWorkspace::Linearise(const ArmProblem& problem, State& state) {
  Linearise(problem, state, {}, 0, problem.size().knots - 1);
}

void ChainWorkspace::Linearise(const ArmProblem& problem, State& state, const CarriedPrior& prior,
                               int start_knot, int last_knot) {
  plan.Build(problem, state, prior,
             {.start_knot = start_knot,
              .end_knot = last_knot + 1,
              .last_knot = last_knot,
              .leave_stops = true});
  sweep.Prepare(plan);
  sweep.Run(plan, 0.0);
}

}  // namespace brachium
