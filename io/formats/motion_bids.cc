// Motion-BIDS (Jeung et al., Scientific Data 11, 2024): *_motion.tsv without a header row, its
// columns named by *_channels.tsv, its rate by *_motion.json beside it.
#include <algorithm>

#include "io/file_bytes.h"
#include "io/formats/export_table.h"
#include "io/input_error.h"
#include "io/json_input.h"
#include "io/text.h"

namespace brachium {
namespace {

constexpr std::string_view kEnding = "_motion.tsv";

struct Channel {
  std::string name, component, type, point, unit;
  std::size_t line = 0;  // of the channels file
};

struct Channels {
  std::string file;
  std::vector<Channel> list;
};

std::string Beside(const ExportFile& file, const std::string& ending) {
  if (!file.path.ends_with(kEnding))
    throw InputError(file.path, 0, "is not called *_motion.tsv, as a Motion-BIDS recording is");
  return file.path.substr(0, file.path.size() - kEnding.size()) + ending;
}

std::size_t ColumnOf(const std::vector<std::string>& names, std::string_view name,
                     const std::string& file) {
  const auto found = std::ranges::find(names, name);
  if (found == names.end())
    throw InputError(file, 1,
                     "has no column '" + std::string(name) +
                         "'; expected the columns "
                         "name, component, type, tracked_point, units");
  return static_cast<std::size_t>(found - names.begin());
}

Channels ReadChannels(const std::string& path) {
  const FileBytes bytes(path);
  Lines lines(PlainText(bytes.text(), path));
  const std::vector<std::string> names = SplitCells(lines.Next(), '\t');
  const std::size_t at[] = {ColumnOf(names, "name", path), ColumnOf(names, "component", path),
                            ColumnOf(names, "type", path), ColumnOf(names, "tracked_point", path),
                            ColumnOf(names, "units", path)};
  Channels channels{.file = path, .list = {}};
  while (!lines.AtEnd()) {
    const std::vector<std::string> cells = SplitCells(lines.Next(), '\t');
    if (cells.size() == 1 && cells[0].empty()) continue;
    if (cells.size() < names.size())
      throw InputError(path, lines.number(),
                       "row has " + std::to_string(cells.size()) + " cells; expected " +
                           std::to_string(names.size()));
    channels.list.push_back(
        {cells[at[0]], cells[at[1]], cells[at[2]], cells[at[3]], cells[at[4]], lines.number()});
  }
  return channels;
}

double ReadRate(const std::string& path, const ExportClock& clock) {
  if (clock.rate_hz) return *clock.rate_hz;
  const FileBytes bytes(path);
  const double rate = JsonNode::Parse(bytes.text(), path).At("SamplingFrequency").Number();
  if (!(rate >= 2.0 && rate <= 1e5))
    throw InputError(path, 0,
                     "has SamplingFrequency " + Shortest(rate) + "; expected 2 Hz to 100 kHz");
  return rate;
}

const Channel* Find(const Channels& channels, const std::string& point, std::string_view type,
                    char component) {
  for (const Channel& channel : channels.list)
    if (channel.point == point && channel.type == type &&
        channel.component == std::string(1, component))
      return &channel;
  return nullptr;
}

bool HasType(const Channels& channels, const std::string& point, std::string_view type) {
  return Find(channels, point, type, 'x') != nullptr;
}

void Add(const Channels& channels, const std::string& point, std::string_view type,
         Quantity quantity, const std::string& to, SensorTable* sensor) {
  std::array<std::string, 3> names;
  double factor = 1.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Channel* const channel = Find(channels, point, type, "xyz"[axis]);
    if (channel == nullptr)
      throw InputError(channels.file, 0,
                       point + " lacks the " + std::string(type) + " component " + "xyz"[axis] +
                           "; expected ACCEL and GYRO with x, y and z");
    names[axis] = channel->name;
    factor = UnitFactor(channel->unit, quantity, channels.file, channel->line);
  }
  sensor->AddVector(to, names, factor);
}

// Points with a gyroscope; of a file that has none, everything is refused.
std::vector<std::string> SensorsOf(const Channels& channels) {
  std::vector<std::string> points;
  for (const Channel& channel : channels.list)
    if (channel.type == "GYRO" && std::ranges::find(points, channel.point) == points.end())
      points.push_back(channel.point);
  if (points.empty())
    throw InputError(channels.file, 0,
                     "has no channel of the type GYRO; expected inertial sensors "
                     "(GYRO and ACCEL), not markers");
  return points;
}

std::vector<double> TimesOf(const Channels& channels, const CsvTable& table, double rate) {
  const auto latency = std::ranges::find(channels.list, "LATENCY", &Channel::type);
  if (latency != channels.list.end()) return table.Column(latency->name);
  std::vector<double> time(table.rows);
  for (std::size_t row = 0; row < table.rows; ++row) time[row] = static_cast<double>(row) / rate;
  return time;
}

}  // namespace

std::vector<SensorExport> ReadMotionBids(const ExportFile& file, ExportClock* clock,
                                         Findings* findings) {
  const Channels channels = ReadChannels(Beside(file, "_channels.tsv"));
  const double rate = ReadRate(Beside(file, "_motion.json"), *clock);
  CsvLayout layout;
  layout.delimiter = '\t';
  layout.missing = "n/a";
  for (const Channel& channel : channels.list) layout.names.push_back(channel.name);
  const std::vector<std::string> points = SensorsOf(channels);
  const CsvTable table = ParseRows(PlainText(file.text, file.path), file.path, layout);
  const std::vector<double> time = TimesOf(channels, table, rate);
  std::vector<SensorExport> sensors;
  for (const std::string& point : points) {
    if (!file.wanted(point)) continue;
    SensorTable sensor(table);
    sensor.Add("time_s", time);
    Add(channels, point, "GYRO", Quantity::kAngularRate, "gyr_", &sensor);
    Add(channels, point, "ACCEL", Quantity::kAcceleration, "acc_", &sensor);
    if (HasType(channels, point, "MAGN"))
      Add(channels, point, "MAGN", Quantity::kMagneticField, "mag_", &sensor);
    sensors.push_back({point, sensor.Take()});
  }
  findings->defaults.push_back(CentreNote(file.name, "Motion-BIDS"));
  return sensors;
}

}  // namespace brachium
