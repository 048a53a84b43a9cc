#include "io/sweep_merge.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "io/file_bytes.h"
#include "io/output_folder.h"
#include "io/streamed_file.h"
#include "io/sweep_figures.h"
#include "io/sweep_results.h"
#include "io/text.h"

namespace brachium {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Outcome = SweepResult::Outcome;

constexpr const char* kOtherMerge =
    "exists and says otherwise; say --overwrite to replace the older merge";

std::string Quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text) quoted += letter == '"' ? "\"\"" : std::string(1, letter);
  return quoted + "\"";
}

Json NumberOrNull(double value) { return std::isnan(value) ? Json() : Json(value); }

Json PointJson(const SweptMethod& method, const ParameterChoice::Point& point) {
  if (!point) return nullptr;
  Json json = Json::object();
  const auto& values = method.points[static_cast<std::size_t>(*point)];
  for (std::size_t i = 0; i < method.options.size(); ++i) {
    const Json parsed = Json::parse(values[i], nullptr, false);
    json[method.options[i]] = parsed.is_primitive() && !parsed.is_null() ? parsed : Json(values[i]);
  }
  return json;
}

// What the trials say together about each point: their mean error, null where one lacks it.
Json PointsJson(const SweptMethod& method) {
  Json points = Json::array();
  for (Eigen::Index p = 0; p < method.error.cols(); ++p)
    points.push_back({{"options", PointJson(method, p)},
                      {"mean_error", NumberOrNull(method.error.col(p).mean())}});
  return points;
}

Json MethodJson(const SweepTable& table, const SweptMethod& method) {
  Json trials = Json::array();
  for (std::size_t t = 0; t < table.trials.size(); ++t) {
    const auto row = static_cast<Eigen::Index>(t);
    const auto error_at = [&](const ParameterChoice::Point& point) {
      return point ? NumberOrNull(method.error(row, *point)) : Json();
    };
    const auto &best = method.choice.best[t], &by_others = method.choice.by_others[t];
    trials.push_back({{"trial", table.trials[t]},
                      {"best", PointJson(method, best)},
                      {"best_error", error_at(best)},
                      {"chosen_by_others", PointJson(method, by_others)},
                      {"error_there", error_at(by_others)}});
  }
  return {{"method", method.method},
          {"varied", method.options},
          {"overall", PointJson(method, method.choice.overall)},
          {"overall_mean_error", NumberOrNull(method.choice.overall_error)},
          {"leave_one_trial_out_mean_error", NumberOrNull(method.choice.others_error)},
          {"trials", trials},
          {"points", PointsJson(method)}};
}

std::string SweepJson(const SweepTable& table) {
  Json methods = Json::array();
  for (const SweptMethod& method : table.methods) methods.push_back(MethodJson(table, method));
  return Json{{"brachium_sweep", 1},      {"complete", table.Complete()},
              {"tasks", table.tasks},     {"done", table.done},
              {"refused", table.refused}, {"failed", table.failed},
              {"missing", table.missing}, {"not_trusted", table.not_trusted},
              {"figure", table.figure},   {"methods", methods}}
             .dump(2, ' ', false, Json::error_handler_t::replace) +
         "\n";
}

std::vector<std::string> VariedIn(const SweepTable& table) {
  std::vector<std::string> varied;
  for (const SweptMethod& method : table.methods)
    for (const std::string& option : method.options)
      if (std::find(varied.begin(), varied.end(), option) == varied.end()) varied.push_back(option);
  return varied;
}

std::string VariedCells(const SweepTask& task, const std::vector<std::string>& varied) {
  std::string text;
  for (const std::string& option : varied) {
    text += ",";
    if (const auto found = task.varied.find(option); found != task.varied.end())
      text += found->is_string() ? Quoted(found->get<std::string>()) : found->dump();
  }
  return text;
}

std::string ResultCells(const std::optional<SweepResult>& result,
                        const std::map<std::string, std::size_t>& places) {
  if (!result) return std::string(",missing,,").append(places.size(), ',');
  const bool done = result->outcome == Outcome::kDone;
  std::string text = "," + NameOf(result->outcome) + "," +
                     (done ? std::string(result->trusted ? "1" : "0") : "") + "," +
                     Quoted(result->reason);
  std::vector<std::string> cells(places.size());
  for (const auto& [name, value] : result->figures) cells[places.at(name)] = Shortest(value);
  for (const std::string& cell : cells) text += "," + cell;
  return text;
}

// Reads the results once more, so that no more than a row is held. A result that appeared since
// has no columns of its own.
void WriteCsv(const SweepManifest& manifest, const std::vector<std::string>& varied,
              const std::vector<std::string>& columns, bool overwrite) {
  std::map<std::string, std::size_t> places;
  for (const std::string& column : columns) places.emplace(column, places.size());
  StreamedFile csv(manifest.folder() + "/sweep.csv");
  std::string header = "task,trial,method";
  for (const std::string& option : varied) header += "," + option;
  header += ",outcome,trusted,reason";
  for (const std::string& column : columns) header += "," + column;
  csv.Append(header + "\n");
  for (std::size_t i = 0; i < manifest.size(); ++i) {
    const SweepTask task = manifest.At(i);
    auto result = ReadSweepResult(manifest.folder(), task);
    if (result)
      std::erase_if(result->figures, [&](const auto& f) { return !places.contains(f.first); });
    csv.Append(std::to_string(i) + "," + Quoted(task.trial) + "," + task.method +
               VariedCells(task, varied) + ResultCells(result, places) + "\n");
  }
  csv.Commit(overwrite, kOtherMerge);
}

struct Spent {
  std::size_t tasks = 0;
  double seconds = 0.0, most_seconds = 0.0, most_memory_mb = 0.0;
};

std::string TimingJson(const SweepManifest& manifest) {
  std::map<std::string, Spent> methods;
  ForEachTiming(manifest.folder(), [&](const TaskTiming& timing) {
    if (timing.task >= manifest.size()) return;
    Spent& spent = methods[manifest.At(timing.task).method];
    ++spent.tasks;
    spent.seconds += timing.seconds;
    spent.most_seconds = std::max(spent.most_seconds, timing.seconds);
    spent.most_memory_mb = std::max(spent.most_memory_mb, timing.memory_mb);
  });
  Json json = Json::object();
  for (const auto& [method, spent] : methods)
    json[method] = {{"tasks_run", spent.tasks},
                    {"seconds", spent.seconds},
                    {"longest_s", spent.most_seconds},
                    {"most_memory_mb", spent.most_memory_mb}};
  return Json{{"methods", json}}.dump(2) + "\n";
}

// Whether what stands there came of a sweep that was not complete yet.
bool HoldsPartialMerge(const std::string& file) {
  if (!fs::exists(file)) return false;
  const Json json = Json::parse(FileBytes(file).text(), nullptr, false);
  return json.is_object() && json.value("complete", true) == false;
}

}  // namespace

void WriteSweep(const SweepManifest& manifest, const SweepTable& table,
                const std::vector<std::string>& columns, bool overwrite) {
  const std::string folder = manifest.folder() + "/";
  const bool replace = overwrite || HoldsPartialMerge(folder + "sweep.json");
  const std::string json = SweepJson(table);
  if (!replace && fs::exists(folder + "sweep.json"))
    WriteOneFile(folder + "sweep.json", json, false);
  for (const auto& [name, svg] : SweepFigures(table)) WriteOneFile(folder + name, svg, true);
  WriteCsv(manifest, VariedIn(table), columns, replace);
  WriteOneFile(folder + "timing.json", TimingJson(manifest), true);
  WriteOneFile(folder + "sweep.json", json, replace);
}

}  // namespace brachium
