#include "io/summary_read.h"

#include <limits>
#include <string>
#include <vector>

#include "io/arm_json.h"

namespace brachium {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

double NumberOr(const JsonNode& object, const char* key, double otherwise) {
  const auto found = object.Find(key);
  return found ? found->Number() : otherwise;
}

double NumberOrNaN(const JsonNode& object, const char* key) { return NumberOr(object, key, kNaN); }

// Of a list or a lone number; `unknown` for those that are null.
std::vector<double> NumbersFrom(const JsonNode& node, double unknown = kNaN) {
  if (!node.IsList()) return {node.Number()};
  std::vector<double> numbers;
  for (const JsonNode& number : node.Elements())
    numbers.push_back(number.IsNull() ? unknown : number.Number());
  return numbers;
}

std::vector<std::string> Sentences(const JsonNode& summary, const char* key) {
  std::vector<std::string> sentences;
  for (const JsonNode& sentence : summary.At(key).Elements()) sentences.push_back(sentence.Text());
  return sentences;
}

std::vector<double> Radians(const JsonNode& degrees) {
  std::vector<double> radians = NumbersFrom(degrees, std::numeric_limits<double>::infinity());
  for (double& angle : radians) angle *= kDegree;
  return radians;
}

Constant ConstantFrom(const std::string& name, const JsonNode& node) {
  Constant constant{.name = name, .value = {kNaN}, .sd = {}};
  if (const auto value = node.Find("value")) constant.value = NumbersFrom(*value);
  if (const auto sd = node.Find("sd")) constant.sd = NumbersFrom(*sd);
  return constant;
}

HeadingSupport HeadingFrom(const JsonNode& node) {
  HeadingSupport support{.segment = ParseSegment(node.At("segment")),
                         .against = ParseSegment(node.At("against")),
                         .time = NumbersFrom(node.At("time_s")),
                         .sd = Radians(node.At("sd_deg")),
                         .sd_by = {}};
  for (const auto& [kind, sd] : node.At("sd_by_deg").Members()) support.sd_by[kind] = Radians(sd);
  return support;
}

void ReadConvergence(const JsonNode& node, Diagnostics* diagnostics) {
  diagnostics->converged = node.At("converged").Truth();
  diagnostics->singular = node.At("singular").Truth();
  diagnostics->termination = node.At("termination").Text();
  diagnostics->iterations = static_cast<int>(NumberOr(node, "iterations", 0.0));
  diagnostics->initial_cost = NumberOrNaN(node, "initial_cost");
  diagnostics->final_cost = NumberOrNaN(node, "final_cost");
  diagnostics->gradient_norm = NumberOrNaN(node, "gradient_norm");
}

}  // namespace

Diagnostics DiagnosticsFrom(const JsonNode& summary) {
  Diagnostics diagnostics;
  ReadConvergence(summary.At("convergence"), &diagnostics);
  for (const auto& [kind, node] : summary.At("residuals").Members())
    diagnostics.residuals.push_back(
        {kind, static_cast<std::size_t>(node.At("count").Number()), NumberOrNaN(node, "rms")});
  for (const auto& [name, node] : summary.At("constants").Members())
    diagnostics.constants.push_back(ConstantFrom(name, node));
  for (const JsonNode& rest : summary.At("rests").Elements())
    diagnostics.rests.push_back({ParseSegment(rest.At("segment")), rest.At("start_s").Number(),
                                 rest.At("end_s").Number(), NumberOr(rest, "certainty", 1.0)});
  for (const JsonNode& epoch : summary.At("epochs").Elements())
    diagnostics.epochs.push_back({ParseSegment(epoch.At("segment")), epoch.At("start_s").Number(),
                                  epoch.At("end_s").Number()});
  for (const JsonNode& heading : summary.At("headings").Elements())
    diagnostics.headings.push_back(HeadingFrom(heading));
  for (const auto& [name, node] : summary.At("figures").Members())
    diagnostics.figures.push_back({name, node.IsNull() ? kNaN : node.Number()});
  diagnostics.held_by_prior = Sentences(summary, "held_by_prior");
  diagnostics.notes = Sentences(summary, "notes");
  return diagnostics;
}

RunInfo RunFrom(const JsonNode& summary) {
  RunInfo run;
  run.trial = summary.At("trial").Text();
  run.findings = {.defaults = Sentences(summary, "defaults"),
                  .repairs = Sentences(summary, "repairs"),
                  .warnings = Sentences(summary, "warnings")};
  for (const JsonNode& input : summary.At("inputs").Elements())
    run.inputs.push_back({input.At("file").Text(), input.At("sha256").Text()});
  for (const auto& [name, version] : summary.At("versions").Members())
    run.versions.emplace_back(name, version.Text());
  return run;
}

}  // namespace brachium
