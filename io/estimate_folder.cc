#include "io/estimate_folder.h"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <vector>

#include "io/arm_json.h"
#include "io/estimate_csv.h"
#include "io/file_bytes.h"
#include "io/headings_figure.h"
#include "io/input_error.h"
#include "io/json_input.h"
#include "io/summary.h"
#include "io/summary_read.h"
#include "io/text.h"

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

std::vector<NameValue> FlagsFrom(std::string_view text) {
  std::vector<NameValue> flags;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    const std::size_t equals = line.find('=');
    if (line.starts_with("--") && equals != line.npos)
      flags.emplace_back(line.substr(2, equals - 2), line.substr(equals + 1));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
  }
  return flags;
}

JsonNode ReadSummary(const std::string& folder) {
  if (!std::filesystem::is_directory(folder))
    throw InputError(folder, 0, "is not a folder; expected an estimate folder");
  const std::string file = (std::filesystem::path(folder) / "summary.json").string();
  JsonNode summary = JsonNode::Parse(FileBytes(file).text(), file);
  if (summary.At("brachium_summary").Number() != 1)
    summary.At("brachium_summary").Fail("is not 1; expected version 1");
  return summary;
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
  EstimateFolder output(folder, overwrite);
  output.Append(estimate);
  output.Commit(estimate, run);
}

EstimateFolder::EstimateFolder(const std::string& folder, bool overwrite)
    : output_(folder, EstimateFolderKind(), overwrite), motion_(output_.File("estimate.csv")) {}

void EstimateFolder::Append(const Estimate& piece) { motion_.Append(piece); }

void EstimateFolder::Commit(const Estimate& estimate, const RunInfo& run) {
  motion_.Close();
  output_.Write("summary.json", Dump(SummaryOf(estimate, run)));
  output_.Write("timing.json", Dump(TimingOf(estimate, run)));
  output_.Write("run.flags", RunFlags(run));
  if (!estimate.diagnostics.headings.empty())
    output_.Write("headings.svg", HeadingsFigure(estimate.diagnostics.headings));
  output_.Commit();
}

bool HoldsEstimate(const std::string& folder, const std::string& method, const RunInfo& run) {
  const std::string summary = (std::filesystem::path(folder) / "summary.json").string();
  if (!std::filesystem::is_regular_file(summary)) return false;
  const auto json = nlohmann::ordered_json::parse(FileBytes(summary).text(), nullptr, false);
  return json.is_object() && TellsOfTheSame(json, method, run);
}

Estimate ReadEstimate(const std::string& folder) {
  const JsonNode summary = ReadSummary(folder);
  Estimate estimate = ReadEstimateCsv((std::filesystem::path(folder) / "estimate.csv").string());
  if (const double told = summary.At("samples").Number();
      told != static_cast<double>(estimate.time.size()))
    throw InputError((std::filesystem::path(folder) / "estimate.csv").string(), 0,
                     "has " + std::to_string(estimate.time.size()) + " samples; expected the " +
                         Shortest(told) + " of summary.json: make the estimate again");
  estimate.method = summary.At("method").Text();
  estimate.side = ParseSide(summary.At("side"));
  estimate.diagnostics = DiagnosticsFrom(summary);
  return estimate;
}

RunInfo ReadRun(const std::string& folder) {
  RunInfo run = RunFrom(ReadSummary(folder));
  const std::string file = (std::filesystem::path(folder) / "run.flags").string();
  if (std::filesystem::is_regular_file(file)) run.flags = FlagsFrom(FileBytes(file).text());
  return run;
}

}  // namespace brachium
