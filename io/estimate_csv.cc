#include "io/estimate_csv.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <list>
#include <string_view>

#include "io/csv.h"
#include "io/input_error.h"
#include "io/mounting_json.h"
#include "io/text.h"
#include "problems/arm_angles.h"
#include "problems/arm_model.h"

namespace brachium {
namespace {

// Of a rotation's error about each axis of its segment.
constexpr std::array kDeviations = {"_rx_sd_deg", "_ry_sd_deg", "_rz_sd_deg"};

using Rotations = std::vector<Eigen::Quaterniond>;

// Collects the columns of the table, and holds the numbers that are made for it.
class Table {
 public:
  explicit Table(const Estimate& estimate) : estimate_(estimate) {
    columns_.push_back({"time_s", estimate.time.data(), 1});
    for (const auto& [segment, q_WB] : estimate.q_WB) {
      AddRotation(std::string(Name(segment)), q_WB);
      if (const auto sd = estimate.sd_B.find(segment); sd != estimate.sd_B.end())
        AddDeviations(std::string(Name(segment)), sd->second);
    }
    for (const auto& [name, p_W] : estimate.p_W) {
      AddVectors(name, "", p_W);
      if (const auto sd = estimate.sd_W.find(name); sd != estimate.sd_W.end())
        AddVectors(name, "_sd", sd->second);
    }
    AddAngles();
  }

  void AppendTo(CsvWriter& writer) const { writer.Append(estimate_.time.size(), columns_); }

 private:
  void AddRotation(const std::string& name, const Rotations& q_WB) {
    if (q_WB.empty()) return;
    const double* const xyzw = q_WB[0].coeffs().data();
    columns_.push_back({name + "_qw", xyzw + 3, 4});
    columns_.push_back({name + "_qx", xyzw, 4});
    columns_.push_back({name + "_qy", xyzw + 1, 4});
    columns_.push_back({name + "_qz", xyzw + 2, 4});
  }

  void AddDeviations(const std::string& name, const std::vector<Eigen::Vector3d>& sd_B) {
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<double>& degrees = made_.emplace_back();
      degrees.reserve(sd_B.size());
      for (const Eigen::Vector3d& sd : sd_B) degrees.push_back(sd[axis] / kDegree);
      columns_.push_back({name + kDeviations[static_cast<std::size_t>(axis)], degrees.data(), 1});
    }
  }

  void AddVectors(const std::string& name, const std::string& suffix,
                  const std::vector<Eigen::Vector3d>& vectors) {
    if (vectors.empty()) return;
    columns_.push_back({name + "_px" + suffix, vectors[0].data(), 3});
    columns_.push_back({name + "_py" + suffix, vectors[0].data() + 1, 3});
    columns_.push_back({name + "_pz" + suffix, vectors[0].data() + 2, 3});
  }

  // A column in degrees of numbers in radians.
  void AddDegrees(const std::string& name, const std::vector<double>& radians) {
    std::vector<double>& degrees = made_.emplace_back();
    degrees.reserve(radians.size());
    for (const double angle : radians) degrees.push_back(angle / kDegree);
    columns_.push_back({name, degrees.data(), 1});
  }

  void AddAngles() {
    std::set<Segment> known;
    for (const auto& [segment, q_WB] : estimate_.q_WB) known.insert(segment);
    for (const ArmAngle& angle : ArmAngles(known, estimate_.side)) {
      AddDegrees(angle.name + "_deg", SeriesOf(angle, estimate_.q_WB));
      AddAngleDeviation(angle.name);
    }
    AddAngleDeviation("relative_heading");
  }

  void AddAngleDeviation(const std::string& name) {
    if (const auto sd = estimate_.sd_angle.find(name); sd != estimate_.sd_angle.end())
      AddDegrees(name + "_sd_deg", sd->second);
  }

  const Estimate& estimate_;
  std::list<std::vector<double>> made_;
  std::vector<CsvColumn> columns_;
};

Rotations ReadRotations(const CsvTable& table, const std::string& name) {
  const auto &w = table.Column(name + "_qw"), &x = table.Column(name + "_qx"),
             &y = table.Column(name + "_qy"), &z = table.Column(name + "_qz");
  Rotations rotations;
  rotations.reserve(table.rows);
  for (std::size_t row = 0; row < table.rows; ++row) {
    rotations.emplace_back(w[row], x[row], y[row], z[row]);
    if (std::abs(rotations.back().norm() - 1.0) > kUnitNormTolerance)
      throw InputError(table.file, table.Line(row),
                       name + "_qw.._qz have the norm " + Fixed(rotations.back().norm(), 4) +
                           "; expected a unit quaternion");
  }
  return rotations;
}

std::vector<Eigen::Vector3d> ReadDeviations(const CsvTable& table, const std::string& name) {
  std::vector<Eigen::Vector3d> sd_B(table.rows);
  for (int axis = 0; axis < 3; ++axis) {
    const auto& degrees = table.Column(name + kDeviations[static_cast<std::size_t>(axis)]);
    for (std::size_t row = 0; row < table.rows; ++row) sd_B[row][axis] = degrees[row] * kDegree;
  }
  return sd_B;
}

std::vector<Eigen::Vector3d> ReadVectors(const CsvTable& table, const std::string& name,
                                         const std::string& suffix) {
  const auto &x = table.Column(name + "_px" + suffix), &y = table.Column(name + "_py" + suffix),
             &z = table.Column(name + "_pz" + suffix);
  std::vector<Eigen::Vector3d> vectors;
  vectors.reserve(table.rows);
  for (std::size_t row = 0; row < table.rows; ++row) vectors.emplace_back(x[row], y[row], z[row]);
  return vectors;
}

constexpr std::string_view kAngleDeviation = "_sd_deg";

// A standard deviation of an angle, not one of those of a rotation.
bool IsAngleDeviation(const std::string& column) {
  return column.ends_with(kAngleDeviation) &&
         std::none_of(kDeviations.begin(), kDeviations.end(),
                      [&](const char* end) { return column.ends_with(end); });
}

}  // namespace

void WriteEstimateCsv(const Estimate& estimate, const std::string& file) {
  EstimateCsvWriter writer(file);
  writer.Append(estimate);
  writer.Close();
}

void EstimateCsvWriter::Append(const Estimate& piece) { Table(piece).AppendTo(writer_); }

Estimate ReadEstimateCsv(const std::string& file) {
  const CsvTable table = ReadCsv(file, [](std::string_view name) {
    return !name.ends_with("_deg") || name.ends_with("_sd_deg");
  });
  Estimate estimate;
  estimate.time = table.Column("time_s");
  for (const Segment segment : kSegments)
    if (const std::string name(Name(segment)); table.Has(name + "_qw")) {
      estimate.q_WB[segment] = ReadRotations(table, name);
      if (table.Has(name + kDeviations[0])) estimate.sd_B[segment] = ReadDeviations(table, name);
    }
  for (const std::string& column : table.names)
    if (column.ends_with("_px")) {
      const std::string name = column.substr(0, column.size() - 3);
      estimate.p_W[name] = ReadVectors(table, name, "");
      if (table.Has(name + "_px_sd")) estimate.sd_W[name] = ReadVectors(table, name, "_sd");
    } else if (IsAngleDeviation(column)) {
      auto& sd = estimate.sd_angle[column.substr(0, column.size() - kAngleDeviation.size())];
      sd = table.Column(column);
      for (double& value : sd) value *= kDegree;
    }
  return estimate;
}

}  // namespace brachium
