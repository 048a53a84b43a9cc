#include "io/report/tables.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "io/report/html.h"
#include "io/report/series.h"
#include "io/text.h"
#include "problems/arm_model.h"

namespace brachium {
namespace {

std::string Degrees(double angle) { return NumberText(angle / kDegree, 2); }
std::string Millimetres(double length) { return NumberText(length / 1e-3, 1); }

void AddStatistics(const std::string& name, const Statistics& error, std::string (*text)(double),
                   HtmlTable* table) {
  table->Add({name, text(error.bias), text(error.sd), text(error.rmse), text(error.median),
              text(error.p95), text(error.max)});
}

std::vector<std::string> StatisticsHeader(const std::string& first) {
  return {first, "bias", "sd", "rmse", "median", "95 %", "max"};
}

std::string JointAngleTable(const Evaluation& evaluation) {
  auto header = StatisticsHeader("angle");
  header.insert(header.end(), {"correlation", "limits of agreement"});
  HtmlTable table("Joint angles, estimate minus reference [deg]", header);
  for (const auto& [name, error] : evaluation.joint_angles)
    table.Add({Spoken(name), Degrees(error.bias), Degrees(error.sd), Degrees(error.rmse),
               Degrees(error.median), Degrees(error.p95), Degrees(error.max),
               error.correlation ? Fixed(*error.correlation, 4) : "–",
               error.limits ? Degrees(error.limits->lower) + " to " + Degrees(error.limits->upper)
                            : "–"});
  return table.Html();
}

std::string RelativeTable(const Evaluation& evaluation) {
  const bool raw = evaluation.frames == Reference::Frames::kSegment;
  HtmlTable table(raw ? "Orientation between segments [deg]"
                      : "Orientation between segments, aligned by a constant on each side [deg]",
                  StatisticsHeader("segments"));
  for (const RelativeEvaluation& relative : evaluation.relative) {
    const OrientationEvaluation& orientation = relative.orientation;
    AddStatistics(Spoken(relative.name),
                  raw ? orientation.raw.rotation : orientation.aligned.rotation, Degrees, &table);
  }
  return table.Html();
}

std::string OrientationTable(const Evaluation& evaluation) {
  HtmlTable table("Orientation of segments after one constant heading [deg]",
                  StatisticsHeader("segment"));
  for (const auto& [segment, orientation] : evaluation.orientation)
    AddStatistics(Spoken(std::string(Name(segment))), orientation.aligned.rotation, Degrees,
                  &table);
  return table.Html();
}

std::string PositionTable(const Evaluation& evaluation) {
  HtmlTable table("Points after one constant heading and shift [mm]", StatisticsHeader("point"));
  for (const auto& [name, position] : evaluation.positions)
    AddStatistics(Spoken(name), position.aligned.distance, Millimetres, &table);
  return table.Html();
}

std::string Brief(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) {
    const double size = std::abs(value);
    text += (text.empty() ? "" : ", ") + NumberText(value, size < 0.01 ? 5 : size < 10.0 ? 3 : 1);
  }
  return text.empty() ? "–" : text;
}

std::string Verdict(const Diagnostics& diagnostics) {
  const bool trusted = diagnostics.converged && !diagnostics.singular;
  const std::string what = diagnostics.singular
                               ? "Not to be trusted: the information matrix is singular."
                           : diagnostics.converged ? "Converged."
                                                   : "Not to be trusted: not converged.";
  return std::string("<p class=\"") + (trusted ? "good" : "bad") + "\">" + what + " " +
         EscapedHtml(diagnostics.termination) + "</p>\n";
}

std::string InputsText(const RunInfo& run) {
  std::string text;
  for (const InputFile& input : run.inputs)
    text += (text.empty() ? "" : ", ") + input.path + " (" + input.sha256.substr(0, 8) + ")";
  return text;
}

std::string VersionOf(const RunInfo& run) {
  for (const auto& [name, version] : run.versions)
    if (name == "brachium") return version;
  return "–";
}

}  // namespace

std::string FactsHtml(const ReportedEstimate& reported) {
  const Estimate& estimate = reported.estimate;
  const Diagnostics& diagnostics = estimate.diagnostics;
  const auto n = estimate.time.size();
  const double duration = n < 2 ? 0.0 : estimate.time.back() - estimate.time.front();
  HtmlTable table("What this is", {"", ""});
  table.Add({"trial", reported.run.trial});
  table.Add({"method", estimate.method});
  table.Add({"arm", std::string(Name(estimate.side))});
  table.Add({"samples", std::to_string(n) + " over " + Fixed(duration, 2) + " s"});
  if (diagnostics.iterations > 0)
    table.Add({"iterations", std::to_string(diagnostics.iterations) + ", cost " +
                                 NumberText(diagnostics.initial_cost, 1) + " to " +
                                 NumberText(diagnostics.final_cost, 1)});
  table.Add({"reference", reported.reference_note});
  table.Add({"made by", "brachium " + VersionOf(reported.run)});
  table.Add({"inputs (SHA-256)", InputsText(reported.run)});
  return Verdict(diagnostics) + "<div class=\"facts\">" + table.Html() + "</div>\n";
}

std::string RemarksHtml(const ReportedEstimate& reported) {
  const Findings& findings = reported.run.findings;
  const std::string lists =
      HtmlList("Held by priors only", reported.estimate.diagnostics.held_by_prior) +
      HtmlList("Notes", reported.estimate.diagnostics.notes) +
      HtmlList("Warnings", findings.warnings) + HtmlList("Repaired", findings.repairs) +
      HtmlList("Taken by default", findings.defaults);
  if (lists.empty()) return "";
  const bool open = !findings.warnings.empty() || !reported.estimate.diagnostics.notes.empty();
  return std::string("<details") + (open ? " open" : "") +
         "><summary>Remarks on the recordings and the estimate</summary>\n" + lists +
         "</details>\n";
}

std::string ErrorTables(const ReportedEstimate& reported) {
  if (!reported.evaluation) return "";
  const Evaluation& evaluation = *reported.evaluation;
  return JointAngleTable(evaluation) + RelativeTable(evaluation) + OrientationTable(evaluation) +
         PositionTable(evaluation);
}

std::string ResidualTable(const ReportedEstimate& reported) {
  HtmlTable table("Residuals by kind", {"kind", "count", "rms", "bounds of 3 sd about 1"});
  for (const ResidualStatistics& residual : reported.estimate.diagnostics.residuals) {
    const double reach = 3.0 / std::sqrt(2.0 * static_cast<double>(residual.count));
    table.Add({residual.kind, std::to_string(residual.count), NumberText(residual.rms, 3),
               NumberText(std::max(1.0 - reach, 0.0), 3) + " to " + NumberText(1.0 + reach, 3)});
  }
  return table.Html();
}

std::string ConstantTable(const ReportedEstimate& reported) {
  HtmlTable table("Constants found", {"name", "value", "sd"});
  for (const Constant& constant : reported.estimate.diagnostics.constants)
    table.Add({constant.name, Brief(constant.value), Brief(constant.sd)});
  return table.Html();
}

}  // namespace brachium
