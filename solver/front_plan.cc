#include "solver/front_plan.h"

#include <algorithm>
#include <numeric>

#include "solver/front_factor.h"

namespace brachium {
namespace {

std::size_t U(int i) { return static_cast<std::size_t>(i); }

}  // namespace

bool IsGeometry(UnknownKind kind) {
  return kind == UnknownKind::kGyroScale || kind == UnknownKind::kAccelScale ||
         kind == UnknownKind::kSensorPosition || kind == UnknownKind::kJointVector ||
         kind == UnknownKind::kClockOffset || kind == UnknownKind::kMounting ||
         kind == UnknownKind::kSkin;
}

FrontPlan::FrontPlan(const ArmProblem& problem)
    : last_knot_(U(problem.unknowns()), -1), variable_of_(U(problem.unknowns()), -1) {
  for (const Term& term : problem.terms())
    for (const int unknown : term.unknowns) last_knot_[U(unknown)] = term.first_knot;
}

void FrontPlan::Reset() {
  for (const Variable& variable : variables_) variable_of_[U(variable.unknown)] = -1;
  variables_.clear();
  fronts_.clear();
  terms_.clear();
  blocks_.clear();
  members_.clear();
  runs_.clear();
  active_.clear();
  columns_ = handed_on_ = widest_stride_ = most_residuals_ = widest_term_ = most_blocks_ = 0;
  storage_ = 0;
}

void FrontPlan::Build(const ArmProblem& problem, State& state, const CarriedPrior& prior,
                      const TermRange& range) {
  Reset();
  if (prior.cost != nullptr)
    AddTerm(problem, state, *prior.cost, nullptr, prior.unknowns, range.start_knot,
            range.hold_geometry);
  const auto& terms = problem.terms();
  const auto before = [](const Term& term, int knot) { return term.first_knot < knot; };
  const auto begin = std::lower_bound(terms.begin(), terms.end(), range.start_knot, before);
  const auto end = std::lower_bound(begin, terms.end(), range.end_knot, before);
  terms_.reserve(terms_.size() + static_cast<std::size_t>(end - begin));
  blocks_.reserve(std::accumulate(
      begin, end, blocks_.size(),
      [](std::size_t sum, const Term& term) { return sum + term.unknowns.size(); }));
  for (auto term = begin; term != end; ++term)
    if (term->last_knot <= range.last_knot &&
        !(range.leave_stops && term->kind == ResidualKind::kRangeOfMotion))
      AddTerm(problem, state, *term->cost, term->loss.get(), term->unknowns, term->first_knot,
              range.hold_geometry);
  // Where a joint is, is asked at every knot, whatever spoke of its place last.
  for (Variable& variable : variables_)
    if (problem.Describe(variable.unknown).kind == UnknownKind::kJointVector)
      variable.last_front = static_cast<int>(fronts_.size()) - 1;
  if (range.hand_on)
    for (Variable& variable : variables_)
      if (last_knot_[U(variable.unknown)] >= range.end_knot)
        variable.last_front = static_cast<int>(fronts_.size());
  OrderVariables();
  for (std::size_t i = 0; i < fronts_.size(); ++i) {
    EnterMembers(fronts_[i]);
    PlaceBlocks(fronts_[i]);
    if (i > 0) FindRuns(fronts_[i - 1], fronts_[i]);
  }
}

void FrontPlan::AddTerm(const ArmProblem& problem, State& state, const TangentCost& cost,
                        const ceres::LossFunction* loss, const std::vector<int>& unknowns, int knot,
                        bool hold_geometry) {
  if (fronts_.empty() || fronts_.back().knot != knot)
    fronts_.push_back({.knot = knot, .first_term = terms_.size()});
  const int front = static_cast<int>(fronts_.size()) - 1;
  ++fronts_.back().terms;
  PlannedTerm term{&cost, loss, blocks_.size(), static_cast<int>(unknowns.size())};
  int tangent = 0;
  for (const int unknown : unknowns) {
    const int index = VariableOf(problem, state, unknown, hold_geometry);
    Variable& variable = variables_[U(index)];
    variable.last_front = front;
    const int columns = TangentSize(variable.size);
    blocks_.push_back({index, columns, -1, -1});
    tangent += columns;
  }
  terms_.push_back(term);
  most_residuals_ = std::max(most_residuals_, cost.num_residuals());
  widest_term_ = std::max(widest_term_, tangent);
  most_blocks_ = std::max(most_blocks_, term.blocks);
}

int FrontPlan::VariableOf(const ArmProblem& problem, State& state, int unknown,
                          bool hold_geometry) {
  int& index = variable_of_[U(unknown)];
  if (index < 0) {
    index = static_cast<int>(variables_.size());
    const Unknown u = problem.Describe(unknown);
    const bool held = u.held || (hold_geometry && IsGeometry(u.kind));
    variables_.push_back(
        {unknown, problem.Value(state, unknown), u.Size(), held ? 0 : u.Tangent(), 0, 0});
  }
  return index;
}

void FrontPlan::OrderVariables() {
  std::sort(variables_.begin(), variables_.end(), [](const Variable& a, const Variable& b) {
    return a.last_front != b.last_front ? a.last_front < b.last_front : a.unknown < b.unknown;
  });
  // variable_of_ still holds the places before the sort, which the blocks name.
  std::vector<int>& place = column_in_front_;
  place.resize(variables_.size());
  for (std::size_t i = 0; i < variables_.size(); ++i) {
    int& index = variable_of_[U(variables_[i].unknown)];
    place[U(index)] = static_cast<int>(i);
    index = static_cast<int>(i);
    variables_[i].column = columns_;
    columns_ += variables_[i].tangent;
    if (variables_[i].last_front == static_cast<int>(fronts_.size()))
      handed_on_ += variables_[i].tangent;
  }
  for (TermBlock& block : blocks_) block.variable = place[U(block.variable)];
  std::fill(column_in_front_.begin(), column_in_front_.end(), -1);
}

void FrontPlan::EnterMembers(Front& front) {
  const auto carried = static_cast<std::ptrdiff_t>(active_.size());
  for (const PlannedTerm& term : Terms(front))
    for (const TermBlock& block : Blocks(term)) {
      int& column = column_in_front_[U(block.variable)];
      if (column >= 0 || variables_[U(block.variable)].tangent == 0) continue;
      column = 0;
      active_.push_back(block.variable);
    }
  std::sort(active_.begin() + carried, active_.end());
  std::inplace_merge(active_.begin(), active_.begin() + carried, active_.end());

  const int index = static_cast<int>(&front - fronts_.data());
  const bool is_last = index + 1 == static_cast<int>(fronts_.size());
  front.first_member = members_.size();
  front.members = active_.size();
  front.first_column = active_.empty() ? 0 : variables_[U(active_.front())].column;
  std::size_t leaving = 0;
  for (const int member : active_) {
    const Variable& variable = variables_[U(member)];
    column_in_front_[U(member)] = front.columns;
    members_.push_back({member, front.columns});
    front.columns += variable.tangent;
    if (variable.last_front > index && !is_last) continue;
    front.eliminated = front.columns;
    ++leaving;
  }
  active_.erase(active_.begin(), active_.begin() + static_cast<std::ptrdiff_t>(leaving));
  front.first_staying = front.columns;
  front.storage = storage_;
  storage_ += U(front.eliminated) * U(front.Stride());
  widest_stride_ = std::max(widest_stride_, front.Stride());
}

void FrontPlan::PlaceBlocks(const Front& front) {
  for (const PlannedTerm& term : Terms(front)) {
    in_order_.clear();
    for (int i = 0; i < term.blocks; ++i) {
      TermBlock& block = blocks_[term.first_block + U(i)];
      if (variables_[U(block.variable)].tangent == 0) continue;
      block.column = column_in_front_[U(block.variable)];
      in_order_.push_back(&block);
    }
    std::sort(in_order_.begin(), in_order_.end(),
              [](const TermBlock* a, const TermBlock* b) { return a->column < b->column; });
    int place = 0;
    for (TermBlock* block : in_order_) block->place = place++;
  }
}

void FrontPlan::FindRuns(const Front& before, Front& front) {
  front.first_run = runs_.size();
  for (const Member& member : Members(before)) {
    if (member.column < before.eliminated) continue;
    const int to = column_in_front_[U(member.variable)];
    const int length = variables_[U(member.variable)].tangent;
    if (front.runs > 0 && runs_.back().from + runs_.back().length == member.column &&
        runs_.back().to + runs_.back().length == to) {
      runs_.back().length += length;
    } else {
      runs_.push_back({member.column, to, length});
      ++front.runs;
    }
  }
  const auto runs = Runs(front);
  if (front.columns != before.columns || runs.empty()) return;
  const Run& last = runs.back();
  const auto is_eliminated = [&](const Run& run) { return run.to < front.eliminated; };
  if (last.from == last.to && !is_eliminated(last) && last.to + last.length == front.columns &&
      std::all_of(runs.begin(), runs.end() - 1, is_eliminated))
    front.first_staying = last.to;
}

}  // namespace brachium
