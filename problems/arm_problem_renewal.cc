// What becomes of the terms while a problem is being solved: other weights, other start headings.
#include <iterator>
#include <utility>

#include "problems/arm_problem.h"
#include "problems/residuals/start_heading.h"

namespace brachium {

void ArmProblem::SetUnmodelled(const std::vector<Unmodelled>& unmodelled) {
  unmodelled_ = unmodelled;
  for (Term& term : terms_) {
    if (term.kind == ResidualKind::kAccelerometer)
      term.cost = MakeAccelerometer(term.first_knot, term.sensor);
    if (term.kind == ResidualKind::kSegmentChain)
      term.cost = MakeChain(term.first_knot, term.sensor);
  }
}

void ArmProblem::FixHeadings(const State& state) {
  std::erase_if(terms_, [](const Term& term) {
    return term.kind == ResidualKind::kHeadingGauge || term.kind == ResidualKind::kStartHeading;
  });
  std::vector<Term> ties;
  const auto start = [&](int sensor) {
    return Eigen::Quaterniond(Eigen::Map<const Eigen::Quaterniond>(state.Attitude(0, sensor)));
  };
  const auto tie = [&](TangentCost* cost, ResidualKind kind, std::vector<int> unknowns) {
    ties.push_back({std::unique_ptr<TangentCost>(cost), std::move(unknowns), kind, -1, 0, 0});
  };
  tie(MakeCost(HeadingGauge(start(0))), ResidualKind::kHeadingGauge, {Attitude(0, 0)});
  for (int sensor = 1; sensor < size_.sensors; ++sensor)
    tie(MakeCost(RelativeStartHeading(start(sensor - 1), start(sensor), kStartHeadingSigma)),
        ResidualKind::kStartHeading, {Attitude(0, sensor - 1), Attitude(0, sensor)});
  terms_.insert(terms_.begin(), std::make_move_iterator(ties.begin()),
                std::make_move_iterator(ties.end()));
}

}  // namespace brachium
