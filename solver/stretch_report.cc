#include "solver/stretch_report.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "solver/diagnosis.h"

namespace brachium {
namespace {

constexpr double kLoose = 10 * kDegree;  // above it a heading is little held

std::string Whole(double number) { return std::to_string(std::lround(number)); }

}  // namespace

void StretchReport::Add(const SolvedStretch& stretch) {
  const Timeline& timeline = stretch.problem.timeline();
  if (stretches_ == 0.0) {
    start_ = timeline.knots.front();
    has_contacts_ = !stretch.problem.observations().contacts.empty();
    windows_.settling_span = stretch.windows.settling_span;
  }
  ++stretches_;
  sums_ += stretch.sums;
  windows_.windows += stretch.windows.windows;
  windows_.unconverged += stretch.windows.unconverged;
  windows_.iterations += stretch.windows.iterations;
  knots_ += stretch.stop + (stretch.is_last ? 1 : 0);
  unknowns_ += stretch.unknowns;
  residuals_.Add(stretch.residuals);
  AddRests(stretch);
  Diagnostics& diagnostics = told_.diagnostics;
  diagnostics.singular = diagnostics.singular || stretch.singular;
  if (!stretch.is_last) return;
  diagnostics.constants = DescribeConstants(stretch.problem, stretch.state, stretch.certainty);
  diagnostics.held_by_prior =
      ConstantsHeldByPrior(stretch.problem, stretch.certainty, start_, timeline.knots.back());
  diagnostics.notes = FarFromTold(stretch.problem, stretch.state);
}

// A rest that goes on in the next stretch is one. Rests are by their sensors' own clocks.
void StretchReport::AddRests(const SolvedStretch& stretch) {
  const ArmProblem& problem = stretch.problem;
  const auto& knots = problem.timeline().knots;
  const bool is_first = stretches_ == 1.0;
  std::map<Segment, Rest> open;
  for (Rest rest : DescribeRests(problem)) {
    const double behind = problem.Interval(0, problem.SensorOn(rest.segment)).clock_offset;
    const double start = knots.front() - behind,
                 end = knots[static_cast<std::size_t>(stretch.stop)] - behind;
    const bool goes_on = !stretch.is_last && rest.end > end;
    const bool began_before = !is_first && rest.start < start;
    if ((!is_first && rest.end <= start) || (!stretch.is_last && rest.start >= end)) continue;
    if (goes_on) rest.end = end;
    if (const auto before = open_rests_.find(rest.segment);
        began_before && before != open_rests_.end()) {
      rest.start = before->second.start;
      rest.certainty = std::min(rest.certainty, before->second.certainty);
      open_rests_.erase(before);
    } else if (began_before) {
      rest.start = start;
    }
    if (goes_on)
      open[rest.segment] = rest;
    else
      told_.diagnostics.rests.push_back(rest);
  }
  for (const auto& [segment, rest] : open_rests_) told_.diagnostics.rests.push_back(rest);
  open_rests_ = std::move(open);
}

void StretchReport::Add(const Estimate& piece) {
  told_.streamed += piece.time.size();
  const auto heading = piece.sd_angle.find("relative_heading");
  if (heading == piece.sd_angle.end()) return;
  for (const double sd : heading->second) {
    if (std::isnan(sd)) continue;
    ++heading_known_;
    loose_ += sd > kLoose ? 1.0 : 0.0;
    loosest_ = std::max(loosest_, sd);
  }
}

std::vector<std::string> StretchReport::Notes() const {
  std::vector<std::string> notes = told_.diagnostics.notes;
  if (loose_ > 0.0)
    notes.push_back("The heading of the forearm against the upper arm is little held in " +
                    Whole(std::ceil(100 * loose_ / heading_known_)) +
                    " % of the trial: its standard deviation is up to " +
                    Whole(loosest_ / kDegree) + " deg");
  if (windows_.unconverged > 0)
    notes.push_back(std::to_string(windows_.unconverged) + " of " +
                    std::to_string(windows_.windows) + " windows ended before they converged");
  if (has_contacts_ && stretches_ > 1.0)
    notes.push_back("A place that is touched again in another stretch is taken for another place");
  return notes;
}

Estimate StretchReport::Told() const {
  Estimate estimate = told_;
  estimate.method = "smoother";
  Diagnostics& diagnostics = estimate.diagnostics;
  std::ranges::stable_sort(diagnostics.rests, {}, &Rest::segment);
  diagnostics.residuals = residuals_.Statistics();
  diagnostics.notes = Notes();
  diagnostics.figures = {{"knots", knots_},
                         {"stretches", stretches_},
                         {"sums", sums_},
                         {"windows", static_cast<double>(windows_.windows)},
                         {"window_iterations", static_cast<double>(windows_.iterations)},
                         {"start_heading_span_s", windows_.settling_span},
                         {"residual_scale", ResidualScale(diagnostics.residuals, unknowns_)}};
  return estimate;
}

}  // namespace brachium
