#include "io/sweep_manifest.h"

#include <filesystem>
#include <string_view>

#include "io/file_bytes.h"
#include "io/input_error.h"

namespace brachium {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string Dump(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

SweepTask TaskFrom(const Json& json) {
  SweepTask task;
  json.at("task").get_to(task.index);
  json.at("trial").get_to(task.trial);
  json.at("path").get_to(task.path);
  json.at("duration_s").get_to(task.duration);
  json.at("method").get_to(task.method);
  json.at("inputs").get_to(task.inputs);
  json.at("key").get_to(task.key);
  task.varied = json.at("varied");
  task.options = json.at("options");
  task.versions = json.at("versions");
  return task;
}

}  // namespace

std::string InputsHash(const std::vector<InputFile>& inputs) {
  std::string text;
  for (const InputFile& input : inputs) text += input.path + "\n" + input.sha256 + "\n";
  return Sha256(text);
}

Json VersionsJson(const std::vector<NameValue>& versions) {
  Json json = Json::object();
  for (const auto& [name, version] : versions) json[name] = version;
  return json;
}

std::string KeyOf(const SweepTask& task) {
  return Sha256(Dump({task.inputs, task.method, task.options, task.versions}));
}

std::string ManifestLine(const SweepTask& task) {
  return Dump({{"task", task.index},
               {"trial", task.trial},
               {"path", task.path},
               {"duration_s", task.duration},
               {"method", task.method},
               {"varied", task.varied},
               {"options", task.options},
               {"versions", task.versions},
               {"inputs", task.inputs},
               {"key", task.key}}) +
         "\n";
}

SweepManifest::SweepManifest(const std::string& file) : file_(file), text_(file) {
  std::size_t start = 0;
  text_.ForEach([&](std::string_view part) {
    for (std::size_t end = part.find('\n'); end != std::string_view::npos;
         end = part.find('\n', end + 1))
      ends_.push_back(start + end);
    start += part.size();
  });
  if (ends_.empty() || ends_.back() + 1 != text_.size())
    throw InputError(file, ends_.size() + 1,
                     "is cut off; expected a line for each task, as brachium sweep plan writes");
}

SweepTask SweepManifest::At(std::size_t index) const {
  const std::size_t start = index == 0 ? 0 : ends_[index - 1] + 1;
  const auto fail = [&](const std::string& what) {
    throw InputError(file_, index + 1, what + "; expected a task as brachium sweep plan writes it");
  };
  SweepTask task;
  try {
    task = TaskFrom(Json::parse(text_.Read(start, ends_[index] - start)));
  } catch (const nlohmann::json::exception& error) {
    fail("is no task (" + std::string(error.what()) + ")");
  }
  if (task.index != index) fail("calls itself task " + std::to_string(task.index));
  if (task.key != KeyOf(task)) fail("was changed: its key is not that of what it says");
  return task;
}

std::string SweepManifest::folder() const {
  const fs::path folder = fs::path(file_).parent_path();
  return folder.empty() ? "." : folder.string();
}

}  // namespace brachium
