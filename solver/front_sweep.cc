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

// Fronts that stand in full precision at a time: a window's, and of a longer run its last ones.
constexpr std::size_t kTogether = 256;

// Numbers of their eliminated columns.
std::size_t MostTogether(const FrontPlan& plan) {
  const auto& fronts = plan.fronts();
  std::size_t most = 0;
  for (std::size_t begin = 0, end; begin < fronts.size(); begin = end) {
    end = begin + kTogether;
    const std::size_t after = end < fronts.size() ? fronts[end].storage : plan.storage();
    most = std::max(most, after - fronts[begin].storage);
  }
  return most;
}

// The diagonal that damping multiplies is kept away from nothing and from infinity.
double Clamped(double diagonal) { return std::clamp(diagonal, 1e-6, 1e32); }

}  // namespace

bool FrontSweep::Sums::IsFinite() const {
  return std::isfinite(cost) && std::isfinite(length_2) && std::isfinite(gradient_norm);
}

void FrontSweep::Prepare(const FrontPlan& plan) {
  const std::size_t columns = U(plan.columns()), widest = U(plan.widest_stride());
  factors_.Reserve(plan.storage() + kLane);
  diagonal_.resize(columns);
  gradient_.resize(columns);
  for (LargeBuffer<double>* square : {&last_, &eliminated_, &front_, &before_})
    square->Reserve(widest * widest + kLane);
  marks_.Reserve((plan.fronts().size() / kTogether + 1) * widest * widest);
  together_.Reserve(MostTogether(plan));
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
  for (std::size_t i = 0; i < plan.fronts().size(); ++i) {
    const FrontPlan::Front& front = plan.fronts()[i];
    if (i % kTogether == 0)
      std::copy_n(front_.data(), U(stride_before) * U(stride_before), Mark(plan, i));
    TakeOver(plan, front, stride_before);
    for (const FrontPlan::PlannedTerm& term : plan.Terms(front)) {
      cost += AddTerm(plan, front, term);
      SumDiagonal(plan, term);
    }
    Eliminate(front);
    NoteLost(front);
    Keep(eliminated_.data(), front.eliminated * front.Stride(), factors_.data() + front.storage);
    if (i / kTogether == (plan.fronts().size() - 1) / kTogether) KeepExact(plan, i);
    const double* y = eliminated_.data() + front.columns;
    for (int k = 0; k < front.eliminated; ++k, y += front.Stride()) sums.length_2 += *y * *y;
    stride_before = front.Stride();
  }
  if (!plan.fronts().empty())
    std::copy_n(eliminated_.data(), U(plan.fronts().back().eliminated * stride_before),
                last_.data());
  sums.cost = static_cast<double>(cost);
  for (const double g : gradient_) sums.gradient_norm = std::max(sums.gradient_norm, std::abs(g));
  return sums;
}

void FrontSweep::VisitBackwards(const FrontPlan& plan, const Visitor& visit) {
  const auto& fronts = plan.fronts();
  for (std::size_t end = fronts.size(), begin; end > 0; end = begin) {
    begin = (end - 1) / kTogether * kTogether;
    if (begin != together_begin_) EliminateAgain(plan, begin, end);
    for (std::size_t i = end; i-- > begin;) visit(fronts[i], Exact(plan, i));
  }
}

void FrontSweep::EliminateAgain(const FrontPlan& plan, std::size_t begin, std::size_t end) {
  int stride_before = begin == 0 ? 0 : plan.fronts()[begin - 1].Stride();
  std::copy_n(Mark(plan, begin), U(stride_before) * U(stride_before), front_.data());
  for (std::size_t i = begin; i < end; ++i) {
    const FrontPlan::Front& front = plan.fronts()[i];
    TakeOver(plan, front, stride_before);
    for (const FrontPlan::PlannedTerm& term : plan.Terms(front)) AddTerm(plan, front, term);
    Eliminate(front);
    KeepExact(plan, i);
    stride_before = front.Stride();
  }
}

// The eliminated columns of a front, of those that stand together now.
double* FrontSweep::Exact(const FrontPlan& plan, std::size_t front) {
  const std::size_t begin = front / kTogether * kTogether;
  return together_.data() + (plan.fronts()[front].storage - plan.fronts()[begin].storage);
}

void FrontSweep::KeepExact(const FrontPlan& plan, std::size_t front) {
  const FrontPlan::Front& kept = plan.fronts()[front];
  together_begin_ = front / kTogether * kTogether;
  std::copy_n(eliminated_.data(), kept.eliminated * kept.Stride(), Exact(plan, front));
}

// What stands before a front.
double* FrontSweep::Mark(const FrontPlan& plan, std::size_t front) {
  return marks_.data() + front / kTogether * U(plan.widest_stride()) * U(plan.widest_stride());
}

double* FrontSweep::Column(const FrontPlan::Front& front, int column) {
  double* columns = column < front.eliminated ? eliminated_.data() : front_.data();
  return columns + column * front.Stride();
}

// Puts the columns [begin, end) to zero, what stands above the diagonal apart.
void FrontSweep::Clear(const FrontPlan::Front& front, int begin, int end) {
  for (int column = begin; column < end; ++column)
    std::fill_n(Column(front, column) + column, front.Stride() - column, 0.0);
}

// Takes over the columns of the first of `runs`: what stands there in them and in those below.
void FrontSweep::CopyRun(const FrontPlan::Front& front, std::span<const FrontPlan::Run> runs,
                         const double* before, int stride_before) {
  const FrontPlan::Run& run = runs.front();
  const int gradient_before = runs.back().from + runs.back().length;  // the row below the last
  for (int i = 0; i < run.length; ++i) {
    const double* from = before + (run.from + i) * stride_before;
    double* to = Column(front, run.to + i);
    std::copy_n(from + run.from + i, run.length - i, to + run.to + i);
    for (const FrontPlan::Run& below : runs.subspan(1))
      std::copy_n(from + below.from, below.length, to + below.to);
    to[front.columns] = from[gradient_before];
  }
}

// Begins a front with what the last one handed on.
void FrontSweep::TakeOver(const FrontPlan& plan, const FrontPlan::Front& front, int stride_before) {
  const auto runs = plan.Runs(front);
  if (front.first_staying == front.columns) std::swap(front_, before_);
  const double* before = front.first_staying == front.columns ? before_.data() : front_.data();
  const auto take_over = [&](int begin, int end) {
    Clear(front, begin, end);
    for (std::size_t i = 0; i < runs.size(); ++i)
      if (runs[i].to >= begin && runs[i].to < end)
        CopyRun(front, runs.subspan(i), before, stride_before);
  };
  take_over(0, front.eliminated);
  take_over(front.eliminated, front.first_staying);
}

// Adds Jᵀ [J r] of one term to the front; returns its cost.
double FrontSweep::AddTerm(const FrontPlan& plan, const FrontPlan::Front& front,
                           const FrontPlan::PlannedTerm& term) {
  const auto blocks = plan.Blocks(term);
  const double cost = term_.Linearise(*term.cost, term.loss, blocks, [&](int variable) {
    return plan.variables()[U(variable)].value;
  });
  term_.AddTo(
      blocks, [&](int column) { return Column(front, column); }, front.columns, front.Stride());
  return cost;
}

// The same of the term that AddTerm took last to the diagonal and the gradient of all columns.
void FrontSweep::SumDiagonal(const FrontPlan& plan, const FrontPlan::PlannedTerm& term) {
  for (const TermBlock& block : plan.Blocks(term)) {
    if (block.place < 0) continue;
    const int at = plan.variables()[U(block.variable)].column;
    for (int k = 0; k < block.tangent; ++k) {
      diagonal_[U(at + k)] += term_.Diagonal(block, k);
      gradient_[U(at + k)] += term_.Gradient(block, k);
    }
  }
}

void FrontSweep::Eliminate(const FrontPlan::Front& front) {
  const int stride = front.Stride();
  double* E = Column(front, 0);
  const double lost = damping_ > 0.0 ? kShareOfDamping * damping_ : kSingular;
  for (int k = 0; k < front.eliminated; ++k) {
    const double diagonal = diagonal_[U(front.first_column + k)];
    E[k * stride + k] += damping_ * Clamped(diagonal);
    least_[U(k)] = lost * std::max(diagonal, 1e-9);
  }
  FactorFront(E, front_.data(), stride, front.columns, front.eliminated, least_.data());
}

void FrontSweep::NoteLost(const FrontPlan::Front& front) {
  for (int k = 0; k < front.eliminated; ++k) {
    const double root = eliminated_.data()[k * front.Stride() + k],
                 raised = std::sqrt(kRaised * least_[U(k)]);
    if (root == raised || root * root < kSingular * diagonal_[U(front.first_column + k)])
      lost_.push_back(front.first_column + k);
  }
}

bool FrontSweep::IsLost(int column) const {
  return std::binary_search(lost_.begin(), lost_.end(), column);
}

std::vector<int> FrontSweep::Undetermined(const FrontPlan& plan) const {
  std::vector<int> unknowns;
  auto lost = lost_.begin();
  for (const FrontPlan::Front& front : plan.fronts()) {
    if (lost == lost_.end()) break;
    if (*lost >= front.first_column + front.eliminated) continue;
    for (const FrontPlan::Member& member : plan.Members(front))
      if (member.column < front.eliminated)
        unknowns.push_back(plan.variables()[U(member.variable)].unknown);
    while (lost != lost_.end() && *lost < front.first_column + front.eliminated) ++lost;
  }
  return unknowns;
}

double FrontSweep::Step(const FrontPlan& plan, std::vector<double>& step) {
  step.resize(U(plan.columns()));
  double decrease = 0.0;
  for (auto front = plan.fronts().rbegin(); front != plan.fronts().rend(); ++front) {
    GatherKept(plan, *front, step, d_.data());
    const Kept* L = Factor(*front);
    const double* y_of_front = y_.data();
    double* d_of_front = d_.data();
    for (int k = 0; k < front->eliminated; ++k) y_[U(k)] = L[k * front->Stride() + front->columns];
    BackSubstitute(L, front->Stride(), front->columns, front->eliminated, 1, &y_of_front,
                   &d_of_front);
    for (int k = 0; k < front->eliminated; ++k) {
      const double y = y_[U(k)], d = d_[U(k)];
      const std::size_t column = U(front->first_column + k);
      decrease += 0.5 * (y * y + damping_ * Clamped(diagonal_[column]) * d * d);
      step[column] = d;
    }
  }
  return decrease;
}

void FrontSweep::Draw(const FrontPlan& plan, const std::vector<std::vector<double>>& signs,
                      std::vector<std::vector<double>>& deviations) {
  deviations.resize(signs.size());
  for (std::vector<double>& deviation : deviations) deviation.resize(U(plan.columns()));
  d_.resize(signs.size() * U(plan.widest_stride()));
  std::vector<const double*> y(signs.size());
  std::vector<double*> d(signs.size());
  for (std::size_t i = 0; i < d.size(); ++i) d[i] = &d_[i * U(plan.widest_stride())];
  for (auto front = plan.fronts().rbegin(); front != plan.fronts().rend(); ++front) {
    for (std::size_t i = 0; i < d.size(); ++i) {
      GatherKept(plan, *front, deviations[i], d[i]);
      y[i] = &signs[i][U(front->first_column)];
    }
    BackSubstitute(Factor(*front), front->Stride(), front->columns, front->eliminated,
                   static_cast<int>(d.size()), y.data(), d.data());
    for (std::size_t i = 0; i < d.size(); ++i)
      std::copy_n(d[i], front->eliminated, &deviations[i][U(front->first_column)]);
  }
}

// What a front does not eliminate.
void FrontSweep::GatherKept(const FrontPlan& plan, const FrontPlan::Front& front,
                            const std::vector<double>& columns, double* kept) {
  for (const FrontPlan::Member& member : plan.Members(front)) {
    if (member.column < front.eliminated) continue;
    const FrontPlan::Variable& variable = plan.variables()[U(member.variable)];
    std::copy_n(&columns[U(variable.column)], variable.tangent, kept + member.column);
  }
}

void ChainWorkspace::Linearise(const ArmProblem& problem, State& state, const CarriedPrior& prior,
                               const TermRange& range) {
  plan.Build(problem, state, prior, range);
  sweep.Prepare(plan);
  sweep.Run(plan, 0.0);
}

void ChainWorkspace::Linearise(const ArmProblem& problem, State& state) {
  const int knots = problem.size().knots;
  Linearise(problem, state, {}, {.end_knot = knots, .last_knot = knots, .leave_stops = true});
}

}  // namespace brachium
