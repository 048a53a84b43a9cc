#include "io/sweep_manifest.h"

#include <algorithm>
#include <charconv>
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

constexpr std::size_t kLine = 4096;  // [byte] read at a time; most lines are shorter

// The line from `start` on, without its newline.
std::string LineFrom(const FileParts& text, std::size_t start) {
  std::string line;
  while (start + line.size() < text.size()) {
    const std::size_t from = start + line.size();
    const std::string part = text.Read(from, std::min(kLine, text.size() - from));
    const std::size_t end = part.find('\n');
    line.append(part, 0, end);
    if (end != std::string::npos) break;
  }
  return line;
}

std::string LastLine(const FileParts& text) {
  for (std::size_t back = kLine;; back *= 2) {
    const std::size_t bytes = std::min(back, text.size());
    const std::string end = text.Read(text.size() - bytes, bytes - 1);
    const std::size_t newline = end.rfind('\n');
    if (newline != std::string::npos) return end.substr(newline + 1);
    if (bytes == text.size()) return end;
  }
}

// What a line calls itself; 0 where that is no number.
std::size_t IndexOf(const std::string& line) {
  constexpr std::string_view kStart = "{\"task\":";
  std::size_t index = 0;
  if (line.starts_with(kStart))
    std::from_chars(line.data() + kStart.size(), line.data() + line.size(), index);
  return index;
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
  if (text_.size() == 0 || text_.Read(text_.size() - 1, 1) != "\n")
    throw InputError(file, text_.size() == 0 ? 1 : 0,
                     "is cut off; expected a line for each task, as brachium sweep plan writes");
  const std::string last = LastLine(text_);
  size_ = Parse(last, IndexOf(last)).index + 1;
}

// Lines stand in the order of their indices.
std::size_t SweepManifest::StartOf(std::size_t index) const {
  std::size_t low = 0, high = text_.size();  // the line starts at `low` or between them
  for (;;) {
    const std::size_t middle = low + (high - low) / 2;
    const std::size_t behind = middle + LineFrom(text_, middle).size() + 1;
    if (behind >= high) break;
    (IndexOf(LineFrom(text_, behind)) <= index ? low : high) = behind;
  }
  while (low < high) {
    const std::string line = LineFrom(text_, low);
    if (IndexOf(line) >= index) break;
    low += line.size() + 1;
  }
  return low;
}

std::string SweepManifest::LineOf(std::size_t index) const {
  const std::lock_guard lock(mutex_);
  const std::size_t start = next_.index == index ? next_.start : StartOf(index);
  std::string line = LineFrom(text_, start);
  next_ = {index + 1, start + line.size() + 1};
  return line;
}

SweepTask SweepManifest::At(std::size_t index) const { return Parse(LineOf(index), index); }

SweepTask SweepManifest::Parse(const std::string& line, std::size_t index) const {
  const auto fail = [&](const std::string& what) {
    throw InputError(file_, index + 1, what + "; expected a task as brachium sweep plan writes it");
  };
  SweepTask task;
  try {
    task = TaskFrom(Json::parse(line));
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
