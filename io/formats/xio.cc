// x-io Technologies, CSV: one header row whose names end in their unit, "Gyroscope X (deg/s)", and
// time stamps that are not regular.
#include "io/formats/export_table.h"
#include "io/input_error.h"
#include "io/text.h"

namespace brachium {
namespace {

// A column by the words before its unit: "Gyroscope X" of "Gyroscope X (deg/s)".
struct Column {
  std::string name;
  std::string unit;
};

std::optional<Column> FindColumn(const CsvTable& table, const std::string& words) {
  for (const std::string& name : table.names)
    if (name.starts_with(words + " (") && name.ends_with(")"))
      return Column{name, name.substr(words.size() + 2, name.size() - words.size() - 3)};
  return std::nullopt;
}

Column RequireColumn(const CsvTable& table, const std::string& words) {
  if (const auto column = FindColumn(table, words)) return *column;
  const std::vector<std::string_view> present(table.names.begin(), table.names.end());
  throw InputError(table.file, 1,
                   "has no column '" + words + " (UNIT)'; the header has " + Listed(present));
}

void AddVector(const CsvTable& table, const std::string& words, Quantity quantity,
               const std::string& to, SensorTable* sensor) {
  std::array<std::string, 3> names;
  std::string unit;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Column column = RequireColumn(table, words + " " + "XYZ"[axis]);
    if (axis > 0 && column.unit != unit)
      throw InputError(table.file, 1, "names two units for " + words + "; expected one");
    unit = column.unit;
    names[axis] = column.name;
  }
  sensor->AddVector(to, names, UnitFactor(unit, quantity, table.file, 1));
}

}  // namespace

std::vector<SensorExport> ReadXio(const ExportFile& file, ExportClock* clock, Findings* findings) {
  const std::string id = StemOf(file.path);
  if (!file.wanted(id)) return {};
  const CsvTable table = ParseCsv(file.text, file.path);
  const auto stamp = FindColumn(table, "Timestamp");
  const Column when = stamp ? *stamp : RequireColumn(table, "Time");
  const double factor = UnitFactor(when.unit, Quantity::kTime, file.path, 1);
  std::vector<double> time = table.Column(when.name);
  if (!clock->origin) clock->origin = FirstFinite(time, file.path, when.name);
  for (double& t : time) t = factor * (t - *clock->origin);
  SensorTable sensor(table);
  sensor.Add("time_s", std::move(time));
  AddVector(table, "Gyroscope", Quantity::kAngularRate, "gyr_", &sensor);
  AddVector(table, "Accelerometer", Quantity::kAcceleration, "acc_", &sensor);
  if (FindColumn(table, "Magnetometer X"))
    AddVector(table, "Magnetometer", Quantity::kMagneticField, "mag_", &sensor);
  findings->defaults.push_back(CentreNote(file.name, "x-io"));
  return {{id, sensor.Take()}};
}

}  // namespace brachium
