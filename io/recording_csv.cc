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
#include "io/recording_columns.h"
#include "io/text.h"

namespace brachium {
namespace {

// All of the columns or, where the table has none of them or they are mostly empty, no column.
Columns FindOptional(const CsvTable& table, std::span<const std::string_view> names,
                     const std::string& name, Findings* findings) {
  if (!HasAny(table, names)) return {};
  Columns columns = FindColumns(table, names);
  std::size_t empty = 0;
  for (std::size_t row = 0; row < table.rows; ++row) empty += AllFinite(columns, row) ? 0 : 1;
  if (static_cast<double>(empty) <= kMostEmpty * static_cast<double>(table.rows)) return columns;
  findings->repairs.push_back(MostlyEmpty(name, names[0], empty));
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
    rotations.push_back(UnitRotation(c, row, table));
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
  const CsvTable table = ParseCsv(text, file, IsRecordingColumn);
  WarnOfUnknownColumns(table, name, findings);
  return MakeRecording(table, name, segment, findings);
}

RecordingFile MakeRecording(const CsvTable& table, const std::string& name, Segment segment,
                            Findings* findings) {
  const Columns required = FindColumns(table, kRecorded);
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
