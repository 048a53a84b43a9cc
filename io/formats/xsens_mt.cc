// Xsens MT Manager, ASCII export: comment lines, a header row, one row per packet. Fields after the
// MT Manager and MT Low-Level Protocol manuals: acceleration m/s^2, rate of turn rad/s, orientation
// sensor to ENU. A sample is the mean over the interval that ends at its packet.
#include <Eigen/Geometry>
#include <cmath>

#include "io/formats/export_table.h"
#include "io/input_error.h"
#include "io/text.h"
#include "problems/arm_model.h"

namespace brachium {
namespace {

constexpr double kCounts = 65536.0;       // at which PacketCounter wraps
constexpr double kTicksPerSecond = 1e4;   // of SampleTimeFine
constexpr double kRateTolerance = 0.005;  // relative

struct Header {
  std::string sensor;
  std::optional<double> rate_hz;
  bool north_east_down = false;
  CsvLayout layout;
};

// The last of the name's tokens that is eight hexadecimal digits, or the whole name.
std::string SensorInName(const std::string& path) {
  const std::string stem = StemOf(path);
  const std::vector<std::string> tokens = SplitCells(stem, '_');
  for (auto token = tokens.rbegin(); token != tokens.rend(); ++token)
    if (token->size() == 8 && token->find_first_not_of("0123456789ABCDEFabcdef") == token->npos)
      return *token;
  return stem;
}

void ReadComment(std::string_view line, const ExportFile& file, Header* header) {
  if (const auto rate = ValueOf(line, "Update Rate")) header->rate_hz = LeadingNumber(*rate);
  if (const auto id = ValueOf(line, "DeviceId")) header->sensor = *id;
  const auto world = ValueOf(line, "Coordinate system");
  if (!world) return;
  header->north_east_down = *world == "NED";
  if (*world != "ENU" && *world != "NWU" && *world != "NED")
    throw InputError(file.path, 0,
                     "has the coordinate system '" + *world + "'; expected ENU, NWU or NED");
}

Header ReadHeader(const ExportFile& file, Lines* lines) {
  Header header;
  std::string_view line = lines->Next();
  for (; line.starts_with("//") || (line.empty() && !lines->AtEnd()); line = lines->Next())
    ReadComment(line, file, &header);
  if (header.sensor.empty()) header.sensor = SensorInName(file.path);
  const char delimiter = DelimiterOf(line);
  header.layout = {.names = SplitCells(line, delimiter),
                   .delimiter = delimiter,
                   .first_line = lines->number() + 1,
                   .spare_delimiter = true};
  while (!header.layout.names.empty() && header.layout.names.back().empty())
    header.layout.names.pop_back();
  return header;
}

bool IsPlausible(double rate_hz) { return rate_hz >= 2.0 && rate_hz <= 1e5; }

// From SampleTimeFine, where it is filled.
std::optional<double> MeasuredRate(const CsvTable& table, const std::vector<double>& counts) {
  if (!table.Has("SampleTimeFine")) return std::nullopt;
  const double ticks = MedianStep(Unwrapped(table.Column("SampleTimeFine"), 4294967296.0));
  const double rate = MedianStep(counts) * kTicksPerSecond / ticks;
  if (!IsPlausible(rate)) return std::nullopt;
  return rate;
}

double RateOf(const ExportFile& file, const Header& header, const CsvTable& table,
              const std::vector<double>& counts, const ExportClock& clock, Findings* findings) {
  const auto stated = header.rate_hz ? header.rate_hz : MeasuredRate(table, counts);
  if (clock.rate_hz && stated && std::abs(*stated / *clock.rate_hz - 1.0) > kRateTolerance)
    findings->warnings.push_back(file.name + ": the file says " + Fixed(*stated, 1) + " Hz, and " +
                                 Fixed(*clock.rate_hz, 1) +
                                 " Hz was told and taken; leave it out unless you are sure [rate]");
  const auto rate = clock.rate_hz ? clock.rate_hz : stated;
  if (!rate)
    throw InputError(file.path, 0,
                     "does not say its update rate, and SampleTimeFine is empty; expected the rate "
                     "to be told (--rate=HZ, or rate_hz in trial.json)");
  if (!IsPlausible(*rate))
    throw InputError(file.path, 0,
                     "has the update rate " + Shortest(*rate) + " Hz; expected 2 Hz to 100 kHz");
  return *rate;
}

Eigen::Quaterniond FromEuler(double roll, double pitch, double yaw) {
  using Eigen::AngleAxisd, Eigen::Vector3d;
  return AngleAxisd(yaw * kDegree, Vector3d::UnitZ()) *
         AngleAxisd(pitch * kDegree, Vector3d::UnitY()) *
         AngleAxisd(roll * kDegree, Vector3d::UnitX());
}

// The maker's orientation of a row, sensor to world, from whatever the file spells it in.
std::function<Eigen::Quaterniond(std::size_t)> OrientationOf(const CsvTable& table) {
  const auto column = [&table](const char* name) { return &table.Column(name); };
  if (table.Has("Quat_q0")) {
    const auto *w = column("Quat_q0"), *x = column("Quat_q1"), *y = column("Quat_q2"),
               *z = column("Quat_q3");
    return [=](std::size_t r) { return Eigen::Quaterniond((*w)[r], (*x)[r], (*y)[r], (*z)[r]); };
  }
  if (table.Has("Mat[1][1]")) {
    std::array<const std::vector<double>*, 9> m{};
    for (std::size_t i = 0; i < 9; ++i)
      m[i] = &table.Column("Mat[" + std::to_string(i / 3 + 1) + "][" + std::to_string(i % 3 + 1) +
                           "]");
    return [=](std::size_t r) {
      Eigen::Matrix3d R_WS;
      for (int i = 0; i < 9; ++i) R_WS(i / 3, i % 3) = (*m[static_cast<std::size_t>(i)])[r];
      return Eigen::Quaterniond(R_WS);
    };
  }
  if (table.Has("Roll")) {
    const auto *roll = column("Roll"), *pitch = column("Pitch"), *yaw = column("Yaw");
    return [=](std::size_t r) { return FromEuler((*roll)[r], (*pitch)[r], (*yaw)[r]); };
  }
  return {};
}

void AddOrientation(const CsvTable& table, bool north_east_down, SensorTable* to) {
  const auto orientation = OrientationOf(table);
  if (!orientation) return;
  const Eigen::Quaterniond q_WN(0.0, std::sqrt(0.5), std::sqrt(0.5),
                                0.0);  // (x, y, z) -> (y, x, -z)
  std::array<std::vector<double>, 4> wxyz;
  for (std::size_t row = 0; row < table.rows; ++row) {
    Eigen::Quaterniond q_WS = orientation(row);
    if (north_east_down) q_WS = q_WN * q_WS;
    const double values[] = {q_WS.w(), q_WS.x(), q_WS.y(), q_WS.z()};
    for (std::size_t i = 0; i < 4; ++i) wxyz[i].push_back(values[i]);
  }
  for (std::size_t i = 0; i < 4; ++i) to->Add(std::string("q_") + "wxyz"[i], std::move(wxyz[i]));
}

void RequireSensors(const CsvTable& table) {
  if (table.Has("Gyr_X") && table.Has("Acc_X")) return;
  throw InputError(table.file, table.first_line - 1,
                   std::string("has no ") + (table.Has("Gyr_X") ? "Acc_X" : "Gyr_X") +
                       "; expected Acc_X.._Z and Gyr_X.._Z (export it again with acceleration and "
                       "rate of turn)");
}

}  // namespace

std::vector<SensorExport> ReadXsensMt(const ExportFile& file, ExportClock* clock,
                                      Findings* findings) {
  Lines lines(PlainText(file.text, file.path));
  const Header header = ReadHeader(file, &lines);
  if (!file.wanted(header.sensor)) return {};
  const CsvTable table = ParseRows(lines.rest(), file.path, header.layout);
  RequireSensors(table);
  const std::vector<double> counts =
      Unwrapped(table.Column(table.Has("Counter") ? "Counter" : "PacketCounter"), kCounts);
  const double rate = RateOf(file, header, table, counts, *clock, findings);
  const double first = FirstFinite(counts, file.path, "PacketCounter");
  const double begin = FromOrigin(first, kCounts, clock) - 0.5;
  std::vector<double> time = counts;
  for (double& t : time) t = (t - first + begin) / rate;
  SensorTable sensor(table);
  sensor.Add("time_s", std::move(time));
  sensor.AddVector("gyr_", {"Gyr_X", "Gyr_Y", "Gyr_Z"}, 1.0);
  sensor.AddVector("acc_", {"Acc_X", "Acc_Y", "Acc_Z"}, 1.0);
  if (table.Has("Mag_X")) sensor.AddVector("mag_", {"Mag_X", "Mag_Y", "Mag_Z"}, 1.0);
  AddOrientation(table, header.north_east_down, &sensor);
  findings->defaults.push_back(ShiftNote(file.name, 1.0 / rate));
  return {{header.sensor, sensor.Take()}};
}

}  // namespace brachium
