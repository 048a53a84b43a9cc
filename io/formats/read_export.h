// Recordings out of makers' exports.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "io/formats/export_format.h"
#include "io/recording_csv.h"

namespace brachium {

// One recording of an export that stays where it is: `text` are the bytes of `path`, called `name`
// in findings. `sensor` says which, and may be empty where the file has one only.
RecordingFile ReadExport(const ExportFormat& format, const ExportFile& file,
                         const std::string& sensor, Segment segment, ExportClock* clock,
                         Findings* findings);

// What is to be made of a maker's export.
struct Import {
  const ExportFormat* format = nullptr;
  std::vector<std::string> files;             // or folders of them
  std::map<std::string, Segment> segment_of;  // by the sensor's name, or its file's
  Side side = Side::kRight;
  std::optional<double> rate_hz;
};

struct ImportedTrial : Findings {
  std::vector<RecordingFile> recordings;  // from proximal to distal
  std::vector<std::string> sensors;       // beside them
};

// Reads the sensors that are mapped, on one clock. Throws InputError as the readers do, and where a
// mapped sensor is in none of the files or in two.
ImportedTrial ReadImport(const Import& import);

// Writes a trial folder: a csv file per recording and a trial.json that states the side and what
// was imported, and leaves lengths, mountings and the rest to be filled in. Throws OutputError.
void WriteImport(const std::string& folder, const Import& import, const ImportedTrial& imported,
                 bool overwrite);

}  // namespace brachium
