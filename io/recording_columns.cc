#include "io/recording_columns.h"

#include <algorithm>
#include <cmath>

#include "io/input_error.h"
#include "io/mounting_json.h"
#include "io/text.h"

namespace brachium {
namespace {

std::vector<std::string_view> KnownColumns() {
  std::vector<std::string_view> known(kRecorded.begin(), kRecorded.end());
  known.insert(known.end(), kMagnetometer.begin(), kMagnetometer.end());
  known.insert(known.end(), kOrientation.begin(), kOrientation.end());
  return known;
}

}  // namespace

bool IsRecordingColumn(std::string_view name) {
  return std::ranges::find(kRecorded, name) != kRecorded.end() ||
         std::ranges::find(kMagnetometer, name) != kMagnetometer.end() ||
         std::ranges::find(kOrientation, name) != kOrientation.end();
}

Columns FindColumns(const CsvTable& table, std::span<const std::string_view> names) {
  Columns columns;
  for (const std::string_view name : names) columns.push_back(&table.Column(name));
  return columns;
}

bool HasAny(const CsvTable& table, std::span<const std::string_view> names) {
  return std::ranges::any_of(names, [&](std::string_view name) { return table.Has(name); });
}

bool AllFinite(const Columns& columns, std::size_t row) {
  return std::ranges::all_of(columns,
                             [row](const auto* column) { return std::isfinite((*column)[row]); });
}

Eigen::Quaterniond UnitRotation(const Columns& c, std::size_t row, const CsvTable& table) {
  const Eigen::Quaterniond q_WS((*c[0])[row], (*c[1])[row], (*c[2])[row], (*c[3])[row]);
  if (!(std::abs(q_WS.norm() - 1.0) <= kUnitNormTolerance))
    throw InputError(table.file, table.Line(row),
                     "q_w, q_x, q_y, q_z have the norm " + Fixed(q_WS.norm(), 4) +
                         "; expected a unit quaternion");
  return q_WS.normalized();
}

void WarnOfUnknownColumns(const CsvTable& table, const std::string& name, Findings* findings) {
  const std::vector<std::string_view> known = KnownColumns();
  for (const std::string& column : table.names)
    if (!column.empty() && !IsRecordingColumn(column))
      findings->warnings.push_back(name + ":1: the column '" + column +
                                   "' is not known and was ignored" + DidYouMean(column, known));
}

std::string MostlyEmpty(const std::string& name, std::string_view column, std::size_t empty) {
  return name + ": " + std::string(column) + " and its fellows are empty in " +
         std::to_string(empty) + " rows and were left out as a whole";
}

}  // namespace brachium
