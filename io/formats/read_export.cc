#include "io/formats/read_export.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "io/file_bytes.h"
#include "io/formats/export_table.h"
#include "io/input_error.h"
#include "io/output_folder.h"
#include "io/text.h"

namespace brachium {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string Lower(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

bool IsOfWord(char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'); }

// Whether `key` means this sensor: its name, or the beginning of its file's name by whole words.
bool Means(const std::string& key, const std::string& sensor, const std::string& path) {
  const std::string stem = Lower(StemOf(path)), lower = Lower(key);
  if (lower.empty() || Lower(sensor) == lower || stem == lower) return !lower.empty();
  return stem.starts_with(lower) && !(IsOfWord(lower.back()) && IsOfWord(stem[lower.size()]));
}

// Every file of the list; of a folder, the text files in it in alphabetical order.
std::vector<std::string> FilesOf(const std::vector<std::string>& list) {
  std::vector<std::string> files;
  for (const std::string& path : list) {
    if (!fs::is_directory(path)) {
      files.push_back(path);
      continue;
    }
    std::set<std::string> inside;
    for (const auto& entry : fs::directory_iterator(path))
      if (const auto extension = entry.path().extension();
          entry.is_regular_file() && (extension == ".txt" || extension == ".csv" ||
                                      entry.path().string().ends_with("_motion.tsv")))
        inside.insert(entry.path().string());
    files.insert(files.end(), inside.begin(), inside.end());
  }
  return files;
}

std::string Names(const std::vector<std::string>& names) {
  return names.empty() ? "none" : Listed(std::vector<std::string_view>(names.begin(), names.end()));
}

class Importer {
 public:
  explicit Importer(const Import& import) : import_(import) {}

  ImportedTrial Read() {
    clock_.rate_hz = import_.rate_hz;
    const std::vector<std::string> files = FilesOf(import_.files);
    if (files.empty())
      throw InputError(import_.files.empty() ? "" : import_.files.front(), 0,
                       "has no .txt, .csv or _motion.tsv in it; expected the exports of a trial");
    for (const std::string& path : files) ReadFile(path);
    for (const auto& [key, segment] : import_.segment_of)
      if (!found_.contains(segment))
        throw InputError(import_.files.empty() ? "" : import_.files.front(), 0,
                         "has no sensor '" + key + "'; the sensors at hand are " + Names(seen_));
    for (const Segment segment : kSegments)
      if (const auto found = found_.find(segment); found != found_.end()) {
        result_.recordings.push_back(std::move(found->second.recording));
        result_.sensors.push_back(found->second.sensor);
      }
    return std::move(result_);
  }

 private:
  struct Found {
    RecordingFile recording;
    std::string sensor;
  };

  std::optional<Segment> SegmentOf(const std::string& sensor, const std::string& path) const {
    for (const auto& [key, segment] : import_.segment_of)
      if (Means(key, sensor, path)) return segment;
    return std::nullopt;
  }

  void ReadFile(const std::string& path) {
    const FileBytes bytes(path);
    ExportFile file{.path = path, .name = fs::path(path).filename().string(), .text = bytes.text()};
    file.wanted = [this, &path](const std::string& sensor) {
      seen_.push_back(sensor + " in " + fs::path(path).filename().string());
      return SegmentOf(sensor, path).has_value();
    };
    for (const SensorExport& sensor : import_.format->read(file, &clock_, &result_)) {
      const Segment segment = *SegmentOf(sensor.sensor, path);
      if (found_.contains(segment))
        throw InputError(path, 0,
                         "is a second recording of the " + std::string(Name(segment)) +
                             "; expected one sensor for each segment");
      found_[segment] = {MakeRecording(sensor.table, file.name, segment, &result_), sensor.sensor};
    }
  }

  const Import& import_;
  ExportClock clock_;
  std::map<Segment, Found> found_;
  std::vector<std::string> seen_;
  ImportedTrial result_;
};

std::string CsvName(Segment segment) { return std::string(Name(segment)) + ".csv"; }

}  // namespace

RecordingFile ReadExport(const ExportFormat& format, const ExportFile& file,
                         const std::string& sensor, Segment segment, ExportClock* clock,
                         Findings* findings) {
  std::vector<std::string> seen;
  ExportFile asked = file;
  asked.wanted = [&](const std::string& name) {
    seen.push_back(name);
    return sensor.empty() || Means(sensor, name, file.path);
  };
  const std::vector<SensorExport> sensors = format.read(asked, clock, findings);
  if (sensors.size() != 1)
    throw InputError(file.path, 0,
                     "has " + std::to_string(sensors.size()) + " sensors that fit (" + Names(seen) +
                         "); expected trial.json to name one as \"sensor\"");
  return MakeRecording(sensors.front().table, file.name, segment, findings);
}

ImportedTrial ReadImport(const Import& import) { return Importer(import).Read(); }

void WriteImport(const std::string& folder, const Import& import, const ImportedTrial& imported,
                 bool overwrite) {
  OutputFolder output(folder, {.what = "a trial", .marker = "trial.json", .fresh = {}, .stale = {}},
                      overwrite);
  Json recordings = Json::array(), sources = Json::array();
  for (std::size_t i = 0; i < imported.recordings.size(); ++i) {
    const auto& [recording, facts] = imported.recordings[i];
    WriteRecording(recording, output.File(CsvName(recording.segment)));
    recordings.push_back({{"segment", Name(recording.segment)},
                          {"file", CsvName(recording.segment)},
                          {"format", "csv"}});
    sources.push_back({{"segment", Name(recording.segment)},
                       {"sensor", imported.sensors[i]},
                       {"file", facts.file},
                       {"rate_hz", facts.rate_hz},
                       {"lost_samples", facts.lost_samples}});
  }
  const Json json = {{"brachium_trial", 1},
                     {"arm", {{"side", Name(import.side)}}},
                     {"recordings", recordings},
                     {"imported",
                      {{"format", import.format->name},
                       {"recordings", sources},
                       {"notes", imported.defaults},
                       {"repairs", imported.repairs},
                       {"warnings", imported.warnings}}}};
  output.Write("trial.json", json.dump(2) + "\n");
  output.Commit();
}

}  // namespace brachium
