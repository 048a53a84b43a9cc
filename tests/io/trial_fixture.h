// A small sound trial as text, for tests that break one thing in it.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/csv.h"
#include "io/input_error.h"
#include "io/text.h"
#include "io/trial_folder.h"
#include "tests/support/temporary_folder.h"

namespace brachium {

// `rows` samples at 100 Hz from `start` on: a slow swing about x, seen with gravity alone.
inline std::string RecordingText(std::size_t rows = 200, double start = 0.0) {
  std::string text = "time_s,gyr_x,gyr_y,gyr_z,acc_x,acc_y,acc_z\n";
  for (std::size_t i = 0; i < rows; ++i) {
    const double t = 0.01 * static_cast<double>(i), angle = 0.8 * std::sin(2.0 * t);
    const double values[] = {start + t,
                             1.6 * std::cos(2.0 * t),
                             0.0,
                             0.0,
                             0.0,
                             9.81 * std::sin(angle),
                             9.81 * std::cos(angle)};
    for (const double value : values) text += Shortest(value) + ",";
    text.back() = '\n';
  }
  return text;
}

// The table with one more column at its end, the same value in each row.
inline std::string WithColumn(const std::string& table, const std::string& name,
                              const std::string& value) {
  std::string wider;
  for (std::size_t begin = 0; begin < table.size();) {
    const std::size_t end = table.find('\n', begin);
    wider += table.substr(begin, end - begin) + "," + (begin == 0 ? name : value) + "\n";
    begin = end + 1;
  }
  return wider;
}

// The table with a cell (row 0 below the header) replaced.
inline std::string WithCell(const std::string& table, std::size_t row, std::size_t column,
                            const std::string& value) {
  std::size_t begin = 0;
  for (std::size_t line = 0; line <= row; ++line) begin = table.find('\n', begin) + 1;
  for (std::size_t cell = 0; cell < column; ++cell) begin = table.find(',', begin) + 1;
  const std::size_t end = table.find_first_of(",\n", begin);
  return table.substr(0, begin) + value + table.substr(end);
}

// The table with a column's numbers multiplied.
inline std::string Scaled(const std::string& table, const std::vector<std::string>& names,
                          double factor) {
  CsvTable parsed = ParseCsv(table, "");
  for (const std::string& name : names)
    for (std::size_t c = 0; c < parsed.names.size(); ++c)
      if (parsed.names[c] == name)
        for (double& value : parsed.columns[c]) value *= factor;
  std::string text = table.substr(0, table.find('\n') + 1);
  for (std::size_t row = 0; row < parsed.rows; ++row) {
    for (const auto& column : parsed.columns) text += Shortest(column[row]) + ",";
    text.back() = '\n';
  }
  return text;
}

inline std::string ReferenceText(std::size_t rows = 50) {
  std::string text =
      "time_s,upper_arm_qw,upper_arm_qx,upper_arm_qy,upper_arm_qz,elbow_px,elbow_py,elbow_pz\n";
  for (std::size_t i = 0; i < rows; ++i)
    text += Shortest(0.04 * static_cast<double>(i)) + ",0.8,0,0.6,0,0.1,0.2,0.3\n";
  return text;
}

inline nlohmann::ordered_json TrialJson() {
  const nlohmann::ordered_json mounting = {{"q_BS_wxyz", {1, 0, 0, 0}},
                                           {"p_BS_m", {0.01, -0.1, 0}}};
  return {
      {"brachium_trial", 1},
      {"name", "drinking"},
      {"arm",
       {{"side", "right"},
        {"segments", {{"upper_arm", {{"length_m", 0.31}}}, {"forearm", {{"length_m", 0.26}}}}}}},
      {"recordings",
       {{{"segment", "upper_arm"}, {"file", "upper_arm.csv"}, {"mounting", mounting}},
        {{"segment", "forearm"}, {"file", "forearm.csv"}, {"mounting", mounting}}}},
      {"intervals", {{{"label", "task:drinking"}, {"start_s", 0.1}, {"end_s", 0.5}}}},
      {"start_pose", {{"label", "arms_along_body_thumbs_forward"}, {"at_s", 0.1}}},
      {"reference", {{"file", "reference.csv"}}}};
}

// A trial folder with that trial.json and sound csv files.
class TrialOnDisk : public TemporaryFolder {
 public:
  explicit TrialOnDisk(const std::function<void(nlohmann::ordered_json&)>& change = {}) {
    nlohmann::ordered_json json = TrialJson();
    if (change) change(json);
    Write("trial.json", json.dump(1));
    Write("upper_arm.csv", RecordingText());
    Write("forearm.csv", RecordingText());
    Write("reference.csv", ReferenceText());
  }

  // Line of the first occurrence of `text` in `file`.
  std::size_t LineOf(const std::string& file, const std::string& text) const {
    const std::string bytes = Read(file);
    const auto end = bytes.begin() + static_cast<std::ptrdiff_t>(bytes.find(text));
    return 1 + static_cast<std::size_t>(std::count(bytes.begin(), end, '\n'));
  }
};

// What ReadTrial says against a folder, without the folder's own path; empty when it says nothing.
inline std::string Complaint(const TemporaryFolder& folder) {
  try {
    ReadTrial(folder.path());
  } catch (const InputError& error) {
    const std::string what = error.what();
    return what.starts_with(folder.path() + "/") ? what.substr(folder.path().size() + 1) : what;
  }
  return "";
}

}  // namespace brachium
