#include <cmath>

#include "io/report/html.h"
#include "io/report/series.h"
#include "io/report/tables.h"
#include "io/text.h"
#include "problems/arm_model.h"

namespace brachium {
namespace {

constexpr std::size_t kMostEpochs = 200;  // rows of a table
constexpr std::size_t kFolded = 12;       // of more, the table is folded away

std::string EpochTable(const MovementOutcomes& outcomes, const std::string& of) {
  const double unit = outcomes.is_point ? 1.0 : kDegree;
  std::string caption = "Movements of the " + Spoken(outcomes.mover) + ", " + of;
  if (outcomes.epochs.size() > kMostEpochs)
    caption += ": the first " + std::to_string(kMostEpochs) + " of " +
               std::to_string(outcomes.epochs.size());
  HtmlTable table(caption, {"", "start [s]", "end [s]", "duration [s]",
                            outcomes.is_point ? "peak speed [m/s]" : "peak rate [deg/s]",
                            "time to peak [s]", "speed peaks", "SPARC", "LDLJ",
                            outcomes.is_point ? "path [m]" : "path [deg]", "path ratio"});
  for (std::size_t i = 0; i < std::min(outcomes.epochs.size(), kMostEpochs); ++i) {
    const MovementEpoch& epoch = outcomes.epochs[i];
    table.Add({std::to_string(i + 1), Fixed(epoch.start, 2), Fixed(epoch.end, 2),
               Fixed(epoch.end - epoch.start, 2), NumberText(epoch.peak_speed / unit, 2),
               NumberText(epoch.time_to_peak, 2), std::to_string(epoch.speed_peaks),
               NumberText(epoch.spectral_arc_length, 2), NumberText(epoch.log_jerk, 2),
               NumberText(epoch.path / unit, 2),
               epoch.path_ratio ? Fixed(*epoch.path_ratio, 2) : "–"});
  }
  return table.Html();
}

std::string Epochs(const MovementOutcomes& outcomes, const std::string& by) {
  const std::string table = EpochTable(outcomes, "by the " + by);
  if (table.empty()) return "<p>No movement by the " + by + ".</p>\n";
  return std::string("<details") + (outcomes.epochs.size() > kFolded ? "" : " open") +
         "><summary>" + std::to_string(outcomes.epochs.size()) + " movements by the " + by +
         "</summary>\n" + table + "</details>\n";
}

std::string Degrees(double angle) { return NumberText(angle / kDegree, 1); }

std::string RangeTable(const MovementOutcomes& own, const MovementOutcomes* reference) {
  std::vector<std::string> header = {"angle", "least", "greatest", "range"};
  if (reference != nullptr) header.emplace_back("range of the reference");
  HtmlTable table("Range of motion, 1 % and 99 % quantiles [deg]", header);
  for (const auto& [name, range] : own.ranges) {
    std::vector<std::string> row = {Spoken(name), Degrees(range.least), Degrees(range.greatest),
                                    Degrees(range.greatest - range.least)};
    if (reference != nullptr) {
      const auto found = reference->ranges.find(name);
      row.push_back(found == reference->ranges.end()
                        ? "–"
                        : Degrees(found->second.greatest - found->second.least));
    }
    table.Add(std::move(row));
  }
  return table.Html();
}

std::string Compensation(const MovementOutcomes& outcomes) {
  std::string text;
  if (outcomes.shoulder_range)
    text += "The shoulder strayed up to " + Fixed(*outcomes.shoulder_range / 1e-3, 0) +
            " mm from its median place. ";
  if (outcomes.trunk_tilt)
    text += "The trunk tilted up to " + Degrees(*outcomes.trunk_tilt) + " deg.";
  return text.empty() ? "" : "<p>" + EscapedHtml(text) + "</p>\n";
}

}  // namespace

std::string MovementTables(const ReportedEstimate& reported) {
  const Estimate& estimate = reported.estimate;
  const MovementOutcomes own =
      OutcomesOf(estimate.side, estimate.time, estimate.q_WB, estimate.p_W);
  const bool judged = reported.evaluation.has_value();
  std::string html = RangeTable(own, judged ? &reported.evaluation->reference_outcomes : nullptr) +
                     Compensation(own) + Epochs(own, "estimate");
  if (judged) html += Epochs(reported.evaluation->reference_outcomes, "reference");
  return html +
         "<p class=\"small\">SPARC: spectral arc length, LDLJ: log dimensionless jerk; nearer to "
         "zero is smoother. Path ratio: the way over the straight line.</p>\n";
}

}  // namespace brachium
