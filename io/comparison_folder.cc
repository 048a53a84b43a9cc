#include "io/comparison_folder.h"

#include <filesystem>
#include <utility>

#include "io/evaluation_file.h"
#include "io/file_bytes.h"
#include "io/output_folder.h"
#include "io/text.h"

namespace brachium {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Done = ComparedPair::Outcome;

std::string Quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text) quoted += letter == '"' ? "\"\"" : std::string(1, letter);
  return quoted + "\"";
}

using Cells = std::vector<std::pair<std::string, std::string>>;  // path, number

// Numbers by their path; lists and the blocks that the figures to go by were taken from stay out.
void Flatten(const Json& json, const std::string& path, Cells* cells) {
  for (const auto& [key, value] : json.items()) {
    if (key == "raw" || key == "aligned" || key == "removed" || key == "brachium_evaluation")
      continue;
    const std::string name = path.empty() ? key : path + "." + key;
    if (value.is_object())
      Flatten(value, name, cells);
    else if (value.is_null())
      cells->emplace_back(name, "");
    else if (value.is_number())
      cells->emplace_back(name, Shortest(value.get<double>()));
  }
}

Cells CellsOf(const ComparedPair& pair) {
  Cells cells;
  if (pair.outcome == Done::kDone)
    Flatten(Json::parse(EvaluationJson(pair.evaluation)), "", &cells);
  return cells;
}

std::string Truth(const ComparedPair& pair) {
  if (pair.outcome != Done::kDone) return "";
  return pair.trusted ? "1" : "0";
}

Json PairJson(const ComparedPair& pair) {
  Json json = {{"trial", pair.trial}, {"method", pair.method}, {"outcome", NameOf(pair.outcome)}};
  if (pair.outcome == Done::kDone) json["trusted"] = pair.trusted;
  if (!pair.reason.empty()) json["reason"] = pair.reason;
  if (pair.outcome == Done::kDone)
    json["evaluation"] = Json::parse(EvaluationJson(pair.evaluation));
  return json;
}

std::string Dump(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string TimingJson(const Comparison& comparison, const ComparisonInfo& info) {
  Json pairs = Json::array();
  for (const ComparedPair& pair : comparison.pairs)
    pairs.push_back({{"trial", pair.trial},
                     {"method", pair.method},
                     {"reused", pair.reused},
                     {"seconds", pair.seconds}});
  return Dump({{"pairs", pairs}, {"host", info.host}, {"command_line", info.command_line}});
}

std::string FlagsText(const std::vector<NameValue>& flags) {
  std::string text;
  for (const auto& [name, value] : flags) text += "--" + name + "=" + value + "\n";
  return text;
}

// An interrupted comparison holds estimates alone, and the trials of an experiment.
void RequireComparison(const std::string& folder) {
  if (!fs::is_directory(folder) || fs::exists(fs::path(folder) / "comparison.csv")) return;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name != "estimates" && name != "trials" && entry.path().extension() != ".svg")
      throw OutputExists(
          folder + ": holds " + name +
          " and is not a comparison, so it is not written to; choose another folder");
  }
}

}  // namespace

std::string ComparisonCsv(const Comparison& comparison) {
  std::vector<Cells> rows;
  std::vector<std::string> columns;
  std::map<std::string, std::size_t> places;
  for (const ComparedPair& pair : comparison.pairs) {
    rows.push_back(CellsOf(pair));
    for (const auto& [name, text] : rows.back())
      if (places.emplace(name, columns.size()).second) columns.push_back(name);
  }
  std::string csv = "trial,method,outcome,trusted,reason";
  for (const std::string& column : columns) csv += "," + column;
  csv += "\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const ComparedPair& pair = comparison.pairs[i];
    csv += Quoted(pair.trial) + "," + pair.method + "," + NameOf(pair.outcome) + "," + Truth(pair) +
           "," + Quoted(pair.reason);
    std::vector<std::string> cells(columns.size());
    for (const auto& [name, text] : rows[i]) cells[places[name]] = text;
    for (const std::string& cell : cells) csv += "," + cell;
    csv += "\n";
  }
  return csv;
}

std::string ComparisonJson(const Comparison& comparison, const ComparisonInfo& info) {
  Json versions = Json::object(), pairs = Json::array();
  for (const auto& [name, version] : info.versions) versions[name] = version;
  for (const ComparedPair& pair : comparison.pairs) pairs.push_back(PairJson(pair));
  return Dump({{"brachium_comparison", 1},
               {"trials", comparison.trials},
               {"methods", comparison.methods},
               {"options", info.options},
               {"versions", versions},
               {"pairs", pairs}});
}

void CheckComparable(const std::string& folder, const std::vector<NameValue>& flags,
                     bool overwrite) {
  RequireComparison(folder);
  const std::string file = (fs::path(folder) / "run.flags").string();
  if (overwrite || !fs::exists(file)) return;
  if (FileBytes(file).text() != FlagsText(flags))
    throw OutputExists(folder +
                       ": holds a comparison by other flags; choose another folder, or say "
                       "--overwrite, which keeps the estimates that are the same");
}

void WriteComparison(const std::string& folder, const Comparison& comparison,
                     const ComparisonInfo& info, const std::map<std::string, std::string>& figures,
                     bool overwrite) {
  const auto write = [&](const std::string& name, const std::string& text, bool replaces) {
    WriteOneFile((fs::path(folder) / name).string(), text, replaces);
  };
  for (const auto& [name, svg] : figures) write(name, svg, overwrite);
  write("comparison.csv", ComparisonCsv(comparison), overwrite);
  write("comparison.json", ComparisonJson(comparison, info), overwrite);
  write("comparison.md", info.markdown, overwrite);
  write("timing.json", TimingJson(comparison, info), true);
  write("run.flags", FlagsText(info.flags), overwrite);
}

}  // namespace brachium
