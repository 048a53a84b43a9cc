// Exports of makers' programs: one reader per format, each behind the same interface.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/csv.h"
#include "io/findings.h"

namespace brachium {

// One file of an export, and which of its sensors are asked for.
struct ExportFile {
  std::string path;       // to be opened for files that stand beside it
  std::string name;       // in findings
  std::string_view text;  // its bytes
  std::function<bool(const std::string& sensor)> wanted = [](const std::string&) { return true; };
};

// What the files of one trial share.
struct ExportClock {
  std::optional<double> rate_hz;  // as the user told it
  std::optional<double> origin;   // the count or time at which the trial begins; the first file's
};

// The samples of one sensor as the columns of recording_csv.h: rad/s, m/s^2, and time_s shifted to
// the centre of the interval that a sample averages.
struct SensorExport {
  std::string sensor;  // as the export calls it
  CsvTable table;
};

// How a format is read: the sensors of a file that are wanted, in its order. What a time tag was
// taken for stands in the defaults of `findings`. Throws InputError for what is not of that format,
// for a wanted sensor without gyroscope or accelerometer, and for a rate that nobody told.
struct ExportFormat {
  std::string_view name;
  std::string_view summary;
  std::vector<SensorExport> (*read)(const ExportFile& file, ExportClock* clock, Findings* findings);
};

std::span<const ExportFormat> ExportFormats();

// The format of that name, or nullptr.
const ExportFormat* FindExportFormat(std::string_view name);

std::vector<SensorExport> ReadXsensMt(const ExportFile& file, ExportClock* clock,
                                      Findings* findings);
std::vector<SensorExport> ReadXsensDot(const ExportFile& file, ExportClock* clock,
                                       Findings* findings);
std::vector<SensorExport> ReadApdm(const ExportFile& file, ExportClock* clock, Findings* findings);
std::vector<SensorExport> ReadXio(const ExportFile& file, ExportClock* clock, Findings* findings);
std::vector<SensorExport> ReadMotionBids(const ExportFile& file, ExportClock* clock,
                                         Findings* findings);

}  // namespace brachium
