// Xsens and Movella DOT, CSV of the app and of the exporter: "Key:,value" lines, then a header row.
// Gyr is deg/s here, SampleTimeFine microseconds that wrap at 2^32. A sample is the mean over the
// interval that ends at its time.
#include "io/formats/export_table.h"
#include "io/input_error.h"
#include "problems/arm_model.h"

namespace brachium {
namespace {

constexpr double kMicroseconds = 4294967296.0;  // at which SampleTimeFine wraps

struct Header {
  std::string sensor;
  bool synced = true;
  CsvLayout layout;
};

Header ReadHeader(const ExportFile& file, Lines* lines) {
  Header header{.sensor = StemOf(file.path), .synced = true, .layout = {}};
  while (!lines->AtEnd()) {
    const std::string_view line = lines->Next();
    if (const auto tag = ValueOf(line, "DeviceTag")) header.sensor = *tag;
    if (const auto status = ValueOf(line, "SyncStatus")) header.synced = *status == "Synced";
    if (!line.starts_with("PacketCounter")) continue;
    const char delimiter = DelimiterOf(line);
    header.layout = {.names = SplitCells(line, delimiter),
                     .delimiter = delimiter,
                     .first_line = lines->number() + 1,
                     .spare_delimiter = true};
    while (header.layout.names.back().empty()) header.layout.names.pop_back();
    return header;
  }
  throw InputError(file.path, 0, "has no header row; expected a line that begins PacketCounter");
}

void RequireSensors(const CsvTable& table) {
  if (table.Has("Gyr_X") && table.Has("Acc_X")) return;
  throw InputError(
      table.file, table.first_line - 1,
      "has no Gyr_X and Acc_X, as files of the sensor fusion modes have not; expected a "
      "measurement mode with calibrated rates and accelerations (custom mode 5, rate "
      "quantities, or recording with the inertial data)");
}

}  // namespace

std::vector<SensorExport> ReadXsensDot(const ExportFile& file, ExportClock* clock,
                                       Findings* findings) {
  Lines lines(PlainText(file.text, file.path));
  const Header header = ReadHeader(file, &lines);
  if (!file.wanted(header.sensor)) return {};
  const CsvTable table = ParseRows(lines.rest(), file.path, header.layout);
  RequireSensors(table);
  std::vector<double> time = Unwrapped(table.Column("SampleTimeFine"), kMicroseconds);
  const double first = FirstFinite(time, file.path, "SampleTimeFine");
  const double period = MedianStep(time);
  const double begin = FromOrigin(first, kMicroseconds, clock) - 0.5 * period;
  for (double& t : time) t = 1e-6 * (t - first + begin);
  SensorTable sensor(table);
  sensor.Add("time_s", std::move(time));
  sensor.AddVector("gyr_", {"Gyr_X", "Gyr_Y", "Gyr_Z"}, kDegree);
  sensor.AddVector("acc_", {"Acc_X", "Acc_Y", "Acc_Z"}, 1.0);
  if (table.Has("Mag_X")) sensor.AddVector("mag_", {"Mag_X", "Mag_Y", "Mag_Z"}, 1.0);
  if (table.Has("Quat_W")) {
    sensor.Add("q_w", table.Column("Quat_W"));
    sensor.AddVector("q_", {"Quat_X", "Quat_Y", "Quat_Z"}, 1.0);
  }
  if (!header.synced)
    findings->warnings.push_back(file.name +
                                 ": the sensor was not synchronised; its clock may be " +
                                 "its own: synchronise all sensors before recording [clock]");
  findings->defaults.push_back(ShiftNote(file.name, 1e-6 * period));
  return {{header.sensor, sensor.Take()}};
}

}  // namespace brachium
