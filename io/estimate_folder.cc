#include "io/estimate_folder.h"

#include <filesystem>

#include "io/arm_json.h"
#include "io/estimate_csv.h"
#include "io/file_bytes.h"
#include "io/headings_figure.h"
#include "io/input_error.h"
#include "io/json_input.h"
#include "io/summary.h"

namespace brachium {
namespace {

std::string Dump(const nlohmann::ordered_json& json) {
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string RunFlags(const RunInfo& run) {
  std::string text;
  for (const auto& [name, value] : run.flags) text += "--" + name + "=" + value + "\n";
  return text;
}

}  // namespace

FolderKind EstimateFolderKind() {
  return {.what = "an estimate",
          .marker = "summary.json",
          .fresh = {"timing.json"},
          .stale = {"evaluation.json"}};
}

void WriteEstimate(const std::string& folder, const Estimate& estimate, const RunInfo& run,
                   bool overwrite) {
  OutputFolder output(folder, EstimateFolderKind(), overwrite);
  WriteEstimateCsv(estimate, output.File("estimate.csv"));
  output.Write("summary.json", Dump(SummaryOf(estimate, run)));
  output.Write("timing.json", Dump(TimingOf(estimate, run)));
  output.Write("run.flags", RunFlags(run));
  if (!estimate.diagnostics.headings.empty())
    output.Write("headings.svg", HeadingsFigure(estimate.diagnostics.headings));
  output.Commit();
}

bool HoldsEstimate(const std::string& folder, const std::string& method, const RunInfo& run) {
  const std::string summary = (std::filesystem::path(folder) / "summary.json").string();
  if (!std::filesystem::is_regular_file(summary)) return false;
  const auto json = nlohmann::ordered_json::parse(FileBytes(summary).text(), nullptr, false);
  return json.is_object() && TellsOfTheSame(json, method, run);
}

Estimate ReadEstimate(const std::string& folder) {
  if (!std::filesystem::is_directory(folder))
    throw InputError(folder, 0, "is not a folder; expected an estimate folder");
  const std::string summary = (std::filesystem::path(folder) / "summary.json").string();
  const JsonNode root = JsonNode::Parse(FileBytes(summary).text(), summary);
  if (root.At("brachium_summary").Number() != 1)
    root.At("brachium_summary").Fail("is not 1; expected version 1");
  Estimate estimate = ReadEstimateCsv((std::filesystem::path(folder) / "estimate.csv").string());
  estimate.method = root.At("method").Text();
  estimate.side = ParseSide(root.At("side"));
  const JsonNode convergence = root.At("convergence");
  estimate.diagnostics.converged = convergence.At("converged").Truth();
  estimate.diagnostics.singular = convergence.At("singular").Truth();
  estimate.diagnostics.termination = convergence.At("termination").Text();
  for (const JsonNode& epoch : root.At("epochs").Elements())
    estimate.diagnostics.epochs.push_back({ParseSegment(epoch.At("segment")),
                                           epoch.At("start_s").Number(),
                                           epoch.At("end_s").Number()});
  return estimate;
}

}  // namespace brachium
