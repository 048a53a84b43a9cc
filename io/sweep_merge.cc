#include "io/sweep_merge.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "io/file_bytes.h"
#include "io/output_folder.h"
#include "io/sweep_figures.h"
#include "io/sweep_results.h"

namespace brachium {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

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

struct Spent {
  std::size_t tasks = 0;
  double seconds = 0.0, most_seconds = 0.0, most_memory_mb = 0.0;
};

std::string TimingJson(const std::string& folder) {
  std::map<std::string, Spent> methods;
  ForEachTiming(folder, [&](const TaskTiming& timing) {
    Spent& spent = methods[timing.method];
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

void WriteSweep(const std::string& folder, const SweepTable& table, SweepRows* rows,
                bool overwrite) {
  const std::string file = folder + "/sweep.json", json = SweepJson(table);
  const bool replace = overwrite || HoldsPartialMerge(file);
  if (!replace && fs::exists(file)) WriteOneFile(file, json, false);
  for (const auto& [name, svg] : SweepFigures(table)) WriteOneFile(folder + "/" + name, svg, true);
  StreamedFile csv(folder + "/sweep.csv");
  rows->WriteTo(&csv);
  csv.Commit(replace, "exists and says otherwise; say --overwrite to replace the older merge");
  WriteOneFile(folder + "/timing.json", TimingJson(folder), true);
  WriteOneFile(file, json, replace);
}

}  // namespace brachium
