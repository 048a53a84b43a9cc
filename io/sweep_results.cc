#include "io/sweep_results.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "io/evaluation_file.h"
#include "io/file_bytes.h"
#include "io/input_error.h"
#include "io/output_folder.h"

namespace brachium {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Outcome = SweepResult::Outcome;

constexpr std::size_t kTasksPerFolder = 1000;

std::string Digits(std::size_t number, std::size_t count) {
  const std::string text = std::to_string(number);
  return std::string(count - std::min(count, text.size()), '0') + text;
}

std::string ResultText(const SweepTask& task, const SweepResult& result) {
  Json figures = Json::object();
  for (const auto& [name, value] : result.figures) figures[name] = value;
  return Json{{"task", task.index},
              {"key", task.key},
              {"outcome", NameOf(result.outcome)},
              {"trusted", result.trusted},
              {"reason", result.reason},
              {"figures", figures}}
             .dump(-1, ' ', false, Json::error_handler_t::replace) +
         "\n";
}

std::optional<Outcome> OutcomeCalled(const std::string& name) {
  for (const Outcome outcome :
       {Outcome::kDone, Outcome::kRefused, Outcome::kFailed, Outcome::kUnreadable})
    if (NameOf(outcome) == name) return outcome;
  return std::nullopt;
}

std::optional<SweepResult> ResultFrom(const Json& json, const SweepTask& task) {
  const auto outcome = OutcomeCalled(json.at("outcome").get<std::string>());
  if (json.at("key") != task.key || json.at("task") != task.index || !outcome) return std::nullopt;
  SweepResult result{.outcome = *outcome};
  json.at("trusted").get_to(result.trusted);
  json.at("reason").get_to(result.reason);
  for (const auto& [name, value] : json.at("figures").items())
    result.figures.emplace_back(name, value.get<double>());
  return result;
}

bool IsFigureOfSweep(const std::string& path, const std::string& key) {
  if (key == "rmse_deg" || key == "rmse_m") return true;
  return path.starts_with("relative.") && std::count(path.begin(), path.end(), '.') == 2 &&
         (key == "bias_deg" || key == "sd_deg" || key == "median_deg" || key == "p95_deg" ||
          key == "max_deg");
}

void Collect(const Json& json, const std::string& path,
             std::vector<std::pair<std::string, double>>* figures) {
  for (const auto& [key, value] : json.items()) {
    if (key == "raw" || key == "aligned" || key == "removed") continue;
    const std::string name = path.empty() ? key : path + "." + key;
    if (value.is_object())
      Collect(value, name, figures);
    else if (value.is_number() && IsFigureOfSweep(name, key))
      figures->emplace_back(name, value.get<double>());
  }
}

}  // namespace

const double* SweepResult::Find(const std::string& figure) const {
  for (const auto& [name, value] : figures)
    if (name == figure) return &value;
  return nullptr;
}

std::string SweepResultFile(const std::string& folder, std::size_t task) {
  return folder + "/results/" + Digits(task / kTasksPerFolder, 3) + "/" + Digits(task, 6) + ".json";
}

void WriteSweepResult(const std::string& folder, const SweepTask& task, const SweepResult& result) {
  WriteOneFile(SweepResultFile(folder, task.index), ResultText(task, result), true);
}

std::optional<SweepResult> ReadSweepResult(const std::string& folder, const SweepTask& task) {
  const std::string file = SweepResultFile(folder, task.index);
  if (access(file.c_str(), F_OK) != 0) return std::nullopt;
  try {
    return ResultFrom(Json::parse(FileBytes(file).text()), task);
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

std::vector<std::pair<std::string, double>> FiguresOf(const Evaluation& evaluation) {
  std::vector<std::pair<std::string, double>> figures;
  Collect(Json::parse(EvaluationJson(evaluation)), "", &figures);
  return figures;
}

void AppendTiming(const std::string& folder, const std::string& host, const TaskTiming& timing) {
  std::error_code ignored;
  fs::create_directories(folder + "/timing", ignored);
  std::ofstream(folder + "/timing/" + host + "-" + std::to_string(getpid()) + ".jsonl",
                std::ios::app)
      << Json{{"task", timing.task},
              {"method", timing.method},
              {"seconds", timing.seconds},
              {"memory_mb", timing.memory_mb}}
                 .dump() +
             "\n";
}

void ForEachTiming(const std::string& folder, const std::function<void(const TaskTiming&)>& visit) {
  std::error_code error;
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder + "/timing", error))
    if (entry.path().extension() == ".jsonl") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) {
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);) try {
        const Json json = Json::parse(line);
        visit({.task = json.at("task"),
               .method = json.at("method"),
               .seconds = json.at("seconds"),
               .memory_mb = json.at("memory_mb")});
      } catch (const nlohmann::json::exception&) {
        continue;  // a program was ended in the middle of its line
      }
  }
}

}  // namespace brachium
