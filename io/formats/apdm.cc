// APDM Opal, CSV of Motion Studio in both layouts. Old: lines of facts, a header row of
// "LABEL/QUANTITY/AXIS", a row of units. "Format=7": a row of sensors and labels, a row of
// quantities, a row of axes; m/s^2, rad/s, time in microseconds since 1970.
#include <algorithm>

#include "io/formats/export_table.h"
#include "io/input_error.h"

namespace brachium {
namespace {

constexpr double kMicroseconds = 1e-6;  // [s]

// Names of columns as the old layout has them, and units beside them.
struct Header {
  CsvLayout layout;
  std::vector<std::string> units;
  std::vector<std::string> sensors;  // in their order
};

void NoteSensor(const std::string& sensor, std::vector<std::string>* sensors) {
  if (!sensor.empty() && std::ranges::find(*sensors, sensor) == sensors->end())
    sensors->push_back(sensor);
}

Header ReadOldHeader(const ExportFile& file, Lines* lines) {
  Header header;
  for (std::string_view line = lines->Next();; line = lines->Next()) {
    if (line.starts_with("Time,")) {
      header.layout.names = SplitCells(line, ',');
      break;
    }
    if (lines->AtEnd())
      throw InputError(file.path, 0,
                       "has no header row; expected Format=7, or a line that begins Time,");
  }
  header.units = SplitCells(lines->Next(), ',');
  header.units.resize(header.layout.names.size());
  for (const std::string& name : header.layout.names)
    if (const auto slash = name.find("/Acceleration/"); slash != name.npos)
      NoteSensor(name.substr(0, slash), &header.sensors);
  return header;
}

std::string_view Renamed(const std::string& quantity) {
  if (quantity == "Accelerometer") return "Acceleration";
  if (quantity == "Gyroscope") return "Angular Velocity";
  if (quantity == "Magnetometer") return "Magnetic Field";
  return quantity;
}

std::string_view UnitOf(std::string_view quantity) {
  if (quantity == "Acceleration") return "m/s^2";
  if (quantity == "Angular Velocity") return "rad/s";
  return "";
}

// The label of the sensor whose columns begin at `column`: the last text before the next sensor's.
std::string LabelOf(const std::vector<std::string>& labels, std::size_t column, std::size_t end) {
  std::string label;
  for (std::size_t c = column; c < std::min(end, labels.size()); ++c)
    if (!labels[c].empty()) label = labels[c];
  return label;
}

Header ReadFormat7Header(Lines* lines) {
  const std::vector<std::string> labels = SplitCells(lines->Next(), ',');
  std::vector<std::string> quantities = SplitCells(lines->Next(), ',');
  std::vector<std::string> axes = SplitCells(lines->Next(), ',');
  const std::size_t width = std::max(quantities.size(), axes.size());
  quantities.resize(width);
  axes.resize(width);
  std::vector<std::size_t> begins;
  for (std::size_t c = 0; c < width; ++c)
    if (quantities[c] == "Accelerometer") begins.push_back(c);
  begins.push_back(width);
  Header header;
  header.layout.names.assign(width, "");
  header.units.assign(width, "");
  header.layout.names[0] = "Time";
  header.units[0] = "us";
  for (std::size_t i = 0; i + 1 < begins.size(); ++i) {
    const std::string label = LabelOf(labels, begins[i], begins[i + 1]);
    NoteSensor(label, &header.sensors);
    std::string_view quantity;
    for (std::size_t c = begins[i]; c < begins[i + 1]; ++c) {
      if (!quantities[c].empty()) quantity = Renamed(quantities[c]);
      header.layout.names[c] = label + "/" + std::string(quantity) + "/" + axes[c];
      header.units[c] = UnitOf(quantity);
    }
  }
  return header;
}

double FactorOf(const Header& header, const std::string& name, Quantity quantity,
                const ExportFile& file) {
  const auto& names = header.layout.names;
  const auto at = static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
  if (at == names.size())
    throw InputError(file.path, header.layout.first_line - 1,
                     "has no column '" + name + "'; expected it for each sensor");
  return UnitFactor(header.units[at], quantity, file.path, header.layout.first_line - 1);
}

SensorExport Extract(const ExportFile& file, const Header& header, const CsvTable& table,
                     const std::string& label, const std::vector<double>& time) {
  SensorTable sensor(table);
  sensor.Add("time_s", time);
  const auto add = [&](const std::string& quantity, Quantity kind, const std::string& to) {
    const std::string stem = label + "/" + quantity + "/";
    sensor.AddVector(to, {stem + "X", stem + "Y", stem + "Z"},
                     FactorOf(header, stem + "X", kind, file));
  };
  add("Angular Velocity", Quantity::kAngularRate, "gyr_");
  add("Acceleration", Quantity::kAcceleration, "acc_");
  if (table.Has(label + "/Magnetic Field/X"))
    add("Magnetic Field", Quantity::kMagneticField, "mag_");
  return {label, sensor.Take()};
}

}  // namespace

std::vector<SensorExport> ReadApdm(const ExportFile& file, ExportClock* clock, Findings* findings) {
  Lines lines(PlainText(file.text, file.path));
  Header header = lines.rest().starts_with("Format=7") ? ReadFormat7Header(&lines)
                                                       : ReadOldHeader(file, &lines);
  header.layout.first_line = lines.number() + 1;
  header.layout.spare_delimiter = true;
  const CsvTable table = ParseRows(lines.rest(), file.path, header.layout);
  const double factor = FactorOf(header, "Time", Quantity::kTime, file);
  std::vector<double> time = table.Column("Time");
  if (!clock->origin)
    clock->origin = factor == kMicroseconds ? FirstFinite(time, file.path, "Time") : 0.0;
  for (double& t : time) t = factor * (t - *clock->origin);
  std::vector<SensorExport> sensors;
  for (const std::string& label : header.sensors)
    if (file.wanted(label)) sensors.push_back(Extract(file, header, table, label, time));
  findings->defaults.push_back(CentreNote(file.name, "APDM"));
  return sensors;
}

}  // namespace brachium
