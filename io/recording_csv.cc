#include "io/recording_csv.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string_view>

#include "io/clock.h"
#include "io/input_error.h"
#include "io/mounting_json.h"
#include "io/recording_checks.h"
#include "io/text.h"

namespace brachium {
namespace {

using Columns = std::vector<const std::vector<double>*>;

constexpr std::array<std::string_view, 7> kRequired = {"time_s", "gyr_x", "gyr_y", "gyr_z",
                                                       "acc_x",  "acc_y", "acc_z"};
constexpr std::array<std::string_view, 3> kMagnetometer = {"mag_x", "mag_y", "mag_z"};
constexpr std::array<std::string_view, 4> kOrientation = {"q_w", "q_x", "q_y", "q_z"};
constexpr double kMostEmpty = 0.05;  // share of rows that may lack an optional quantity

std::vector<std::string_view> KnownColumns() {
  std::vector<std::string_view> known(kRequired.begin(), kRequired.end());
  known.insert(known.end(), kMagnetometer.begin(), kMagnetometer.end());
  known.insert(known.end(), kOrientation.begin(), kOrientation.end());
  return known;
}

Columns Find(const CsvTable& table, std::span<const std::string_view> names) {
  Columns columns;
  for (const std::string_view name : names) columns.push_back(&table.Column(name));
  return columns;
}

bool AllFinite(const Columns& columns, std::size_t row) {
  return std::ranges::all_of(columns,
                             [row](const auto* column) { return std::isfinite((*column)[row]); });
}

// All of the columns or, where the table has none of them or they are mostly empty, no column.
Columns FindOptional(const CsvTable& table, std::span<const std::string_view> names,
                     const std::string& name, Findings* findings) {
  if (std::ranges::none_of(names, [&](std::string_view n) { return table.Has(n); })) return {};
  Columns columns = Find(table, names);
  std::size_t empty = 0;
  for (std::size_t row = 0; row < table.rows; ++row) empty += AllFinite(columns, row) ? 0 : 1;
  if (static_cast<double>(empty) <= kMostEmpty * static_cast<double>(table.rows)) return columns;
  findings->repairs.push_back(name + ": " + std::string(names[0]) +
                              " and its fellows are empty in " + std::to_string(empty) +
                              " rows and were left out as a whole");
  return {};
}

std::vector<Eigen::Vector3d> Vectors(const UsableRows& usable,
                                     std::span<const std::vector<double>* const> c) {
  std::vector<Eigen::Vector3d> vectors;
  if (c.empty()) return vectors;
  vectors.reserve(usable.rows.size());
  for (const std::size_t row : usable.rows)
    vectors.emplace_back((*c[0])[row], (*c[1])[row], (*c[2])[row]);
  return vectors;
}

std::vector<Eigen::Quaterniond> Rotations(const UsableRows& usable, const Columns& c,
                                          const CsvTable& table) {
  std::vector<Eigen::Quaterniond> rotations;
  if (c.empty()) return rotations;
  rotations.reserve(usable.rows.size());
  for (const std::size_t row : usable.rows) {
    const Eigen::Quaterniond q_WS((*c[0])[row], (*c[1])[row], (*c[2])[row], (*c[3])[row]);
    if (!(std::abs(q_WS.norm() - 1.0) <= kUnitNormTolerance))
      throw InputError(table.file, table.Line(row),
                       "q_w, q_x, q_y, q_z have the norm " + Fixed(q_WS.norm(), 4) +
                           "; expected a unit quaternion");
    rotations.push_back(q_WS.normalized());
  }
  return rotations;
}

std::vector<double> Times(const UsableRows& usable, const CsvTable& table) {
  const std::vector<double>& column = table.Column("time_s");
  std::vector<double> time;
  time.reserve(usable.rows.size());
  for (const std::size_t row : usable.rows) time.push_back(column[row]);
  return time;
}

void WarnOfUnknownColumns(const CsvTable& table, std::span<const std::string_view> known,
                          const std::string& name, Findings* findings) {
  for (const std::string& column : table.names)
    if (!column.empty() && std::ranges::find(known, std::string_view(column)) == known.end())
      findings->warnings.push_back(name + ":1: the column '" + column +
                                   "' is not known and was ignored" + DidYouMean(column, known));
}

RecordingFacts Facts(const Recording& recording, const Steps& steps, const UsableRows& usable,
                     const CsvTable& table, const std::string& name) {
  return {.segment = recording.segment,
          .file = name,
          .samples = recording.size(),
          .rate_hz = 1.0 / steps.median,
          .start_s = recording.time.front(),
          .duration_s = recording.time.back() - recording.time.front(),
          .gaps = steps.gaps,
          .lost_samples = steps.lost,
          .longest_step_s = steps.longest,
          .not_finite_rows = usable.not_finite,
          .not_later_rows = usable.not_later,
          .cut_off = table.cut_off,
          .magnetometer = !recording.mag_S.empty(),
          .orientation = !recording.q_WS.empty()};
}

}  // namespace

RecordingFile ParseRecording(std::string_view text, const std::string& file,
                             const std::string& name, Segment segment, Findings* findings) {
  const std::vector<std::string_view> known = KnownColumns();
  const CsvTable table = ParseCsv(text, file, [&known](std::string_view column) {
    return std::ranges::find(known, column) != known.end();
  });
  WarnOfUnknownColumns(table, known, name, findings);
  return MakeRecording(table, name, segment, findings);
}

RecordingFile MakeRecording(const CsvTable& table, const std::string& name, Segment segment,
                            Findings* findings) {
  const Columns required = Find(table, kRequired);
  const Columns magnetometer = FindOptional(table, kMagnetometer, name, findings);
  const Columns orientation = FindOptional(table, kOrientation, name, findings);
  const UsableRows usable = FindUsableRows(table, [&](std::size_t row) {
    return AllFinite(required, row) && AllFinite(magnetometer, row) && AllFinite(orientation, row);
  });
  RecordingFile result;
  Recording& recording = result.recording;
  recording.segment = segment;
  recording.time = Times(usable, table);
  recording.gyr_S = Vectors(usable, std::span(required).subspan(1, 3));
  recording.acc_S = Vectors(usable, std::span(required).subspan(4, 3));
  recording.mag_S = Vectors(usable, magnetometer);
  recording.q_WS = Rotations(usable, orientation, table);
  const Steps steps = MeasureSteps(recording.time);
  CheckStepUnit(steps, table.file);
  CheckSensorUnits(recording, table.file, name, findings);
  ReportRows(table, usable, steps, name, findings);
  result.facts = Facts(recording, steps, usable, table, name);
  return result;
}

}  // namespace brachium
