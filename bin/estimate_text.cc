#include "bin/estimate_text.h"

#include <cstdio>
#include <map>
#include <vector>

#include "bin/table.h"
#include "io/text.h"

namespace brachium {
namespace {

std::string Brief(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

std::string Brief(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) {
    if (!text.empty()) text += "  ";
    text += Brief(value);
  }
  return text;
}

std::string Section(const std::string& title, const Table& table) {
  return table.empty() ? "" : "\n" + title + "\n" + table.Text();
}

std::string Outcome(const Diagnostics& diagnostics) {
  std::string text = diagnostics.converged ? "Converged" : "NOT converged";
  if (diagnostics.singular) text += ", information matrix SINGULAR";
  if (!diagnostics.termination.empty()) text += ": " + diagnostics.termination;
  text += "\n";
  if (diagnostics.iterations == 0) return text;  // a method of one pass
  return text + std::to_string(diagnostics.iterations) + " iterations, cost " +
         Brief(diagnostics.initial_cost) + " to " + Brief(diagnostics.final_cost) +
         ", gradient norm " + Brief(diagnostics.gradient_norm) + "\n";
}

Table Residuals(const Diagnostics& diagnostics) {
  Table table({"kind", "count", "rms"});
  for (const ResidualStatistics& residual : diagnostics.residuals)
    table.Add({residual.kind, std::to_string(residual.count), Fixed(residual.rms, 3)});
  return table;
}

Table Constants(const Diagnostics& diagnostics) {
  Table table({"name", "value", "sd"});
  for (const Constant& constant : diagnostics.constants)
    table.Add({constant.name, Brief(constant.value), Brief(constant.sd)});
  return table;
}

Table Rests(const Diagnostics& diagnostics) {
  std::map<Segment, std::pair<int, double>> rests;  // how many, how long
  for (const Rest& rest : diagnostics.rests) {
    ++rests[rest.segment].first;
    rests[rest.segment].second += rest.end - rest.start;
  }
  Table table({"segment", "rests", "seconds"});
  for (const auto& [segment, rest] : rests)
    table.Add({std::string(Name(segment)), std::to_string(rest.first), Fixed(rest.second, 2)});
  return table;
}

Table Figures(const Diagnostics& diagnostics) {
  Table table({"figure", "value"});
  for (const Figure& figure : diagnostics.figures) table.Add({figure.name, Brief(figure.value)});
  return table;
}

Table Timing(const Estimate& estimate) {
  Table table({"stage", "seconds"});
  for (const StageTime& stage : estimate.timing) table.Add({stage.stage, Fixed(stage.seconds, 2)});
  return table;
}

}  // namespace

std::string EstimateText(const std::string& trial, const Estimate& estimate) {
  const Diagnostics& diagnostics = estimate.diagnostics;
  return "Trial " + trial + ", " + std::string(Name(estimate.side)) + " arm, method " +
         estimate.method + ", " + std::to_string(estimate.Instants()) + " instants\n" +
         Outcome(diagnostics) +
         Section("Residuals, whitened: rms 1 where the model holds", Residuals(diagnostics)) +
         Section("Constants", Constants(diagnostics)) + Section("Rests", Rests(diagnostics)) +
         Section("Figures", Figures(diagnostics)) + Section("Time", Timing(estimate)) +
         (diagnostics.notes.empty() ? "" : "\n") + Listing("Notes:", diagnostics.notes) + "\n";
}

void WarnOfDistrust(const Diagnostics& diagnostics, std::ostream& to) {
  if (diagnostics.converged && !diagnostics.singular) return;
  to << "brachium: the result is not to be trusted: "
     << (diagnostics.singular ? "the information matrix is singular" : "not converged")
     << (diagnostics.termination.empty() ? "" : "; " + diagnostics.termination) << "\n";
}

std::string FindingsText(const Findings& findings) {
  return Listing("Defaults taken:", findings.defaults) + Listing("Repaired:", findings.repairs) +
         Listing("Warnings:", findings.warnings);
}

}  // namespace brachium
