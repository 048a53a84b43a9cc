// The columns of a recording's table.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/csv.h"
#include "io/findings.h"

namespace brachium {

using Columns = std::vector<const std::vector<double>*>;

inline constexpr std::array<std::string_view, 7> kRecorded = {"time_s", "gyr_x", "gyr_y", "gyr_z",
                                                              "acc_x",  "acc_y", "acc_z"};
inline constexpr std::array<std::string_view, 3> kMagnetometer = {"mag_x", "mag_y", "mag_z"};
inline constexpr std::array<std::string_view, 4> kOrientation = {"q_w", "q_x", "q_y", "q_z"};

bool IsRecordingColumn(std::string_view name);

// Throws InputError where one is missing.
Columns FindColumns(const CsvTable& table, std::span<const std::string_view> names);

bool HasAny(const CsvTable& table, std::span<const std::string_view> names);

bool AllFinite(const Columns& columns, std::size_t row);

// Of columns w, x, y, z. Throws InputError where the norm is not 1.
Eigen::Quaterniond UnitRotation(const Columns& columns, std::size_t row, const CsvTable& table);

void WarnOfUnknownColumns(const CsvTable& table, const std::string& name, Findings* findings);

// What is said where an optional quantity is mostly empty.
std::string MostlyEmpty(const std::string& name, std::string_view column, std::size_t empty);
inline constexpr double kMostEmpty = 0.05;  // share of rows that may lack it

}  // namespace brachium
