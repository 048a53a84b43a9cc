#include "io/estimate_csv.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <list>
#include <string_view>

#include "io/csv.h"
#include "io/input_error.h"
#include "io/mounting_json.h"
#include "io/text.h"
#include "problems/arm_model.h"
#include "problems/joint_angles.h"

namespace brachium {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

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
    for (const auto& [name, p_W] : estimate.p_W) AddPosition(name, p_W);
    AddElbow();
    AddShoulder();
    AddWrist();
  }

  void Write(const std::string& file) const { WriteCsv(file, estimate_.time.size(), columns_); }

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

  void AddPosition(const std::string& name, const std::vector<Eigen::Vector3d>& p_W) {
    if (p_W.empty()) return;
    columns_.push_back({name + "_px", p_W[0].data(), 3});
    columns_.push_back({name + "_py", p_W[0].data() + 1, 3});
    columns_.push_back({name + "_pz", p_W[0].data() + 2, 3});
  }

  const Rotations* Find(Segment segment) const {
    const auto found = estimate_.q_WB.find(segment);
    return found != estimate_.q_WB.end() ? &found->second : nullptr;
  }

  // A column of angles [rad] by row, kept in degrees; a row whose rotation is a gap gets none.
  void AddAngles(const std::string& name, const Rotations& q,
                 const std::function<double(const Eigen::Quaterniond&)>& angle) {
    std::vector<double>& degrees = made_.emplace_back();
    degrees.reserve(q.size());
    for (const Eigen::Quaterniond& q_AB : q)
      degrees.push_back(q_AB.coeffs().allFinite() ? angle(q_AB) / kDegree : kNaN);
    columns_.push_back({name, degrees.data(), 1});
  }

  static Rotations Relative(const Rotations& q_WA, const Rotations& q_WB) {
    Rotations q_AB;
    q_AB.reserve(q_WA.size());
    for (std::size_t i = 0; i < q_WA.size(); ++i) q_AB.push_back(q_WA[i].conjugate() * q_WB[i]);
    return q_AB;
  }

  void AddElbow() {
    const Rotations* const q_WU = Find(Segment::kUpperArm);
    const Rotations* const q_WF = Find(Segment::kForearm);
    if (q_WU == nullptr || q_WF == nullptr) return;
    const Rotations q_UF = Relative(*q_WU, *q_WF);
    const Side side = estimate_.side;
    AddAngles("elbow_flexion_deg", q_UF,
              [side](const auto& q) { return ElbowAnglesFrom(q, side).flexion; });
    AddAngles("elbow_carrying_deg", q_UF,
              [side](const auto& q) { return ElbowAnglesFrom(q, side).carrying; });
    AddAngles("forearm_pronation_deg", q_UF,
              [side](const auto& q) { return ElbowAnglesFrom(q, side).pronation; });
  }

  void AddShoulder() {
    const Rotations* const q_WU = Find(Segment::kUpperArm);
    const Rotations* const q_WT = Find(Segment::kThorax);
    if (q_WU == nullptr) return;
    if (q_WT == nullptr) return AddAngles("shoulder_elevation_deg", *q_WU, ShoulderElevation);
    const Rotations q_TU = Relative(*q_WT, *q_WU);
    const Side side = estimate_.side;
    AddAngles("shoulder_plane_deg", q_TU,
              [side](const auto& q) { return ShoulderAnglesFrom(q, side).plane.value_or(kNaN); });
    AddAngles("shoulder_elevation_deg", q_TU,
              [side](const auto& q) { return ShoulderAnglesFrom(q, side).elevation; });
    AddAngles("shoulder_rotation_deg", q_TU, [side](const auto& q) {
      return ShoulderAnglesFrom(q, side).rotation.value_or(kNaN);
    });
  }

  void AddWrist() {
    const Rotations* const q_WF = Find(Segment::kForearm);
    const Rotations* const q_WH = Find(Segment::kHand);
    if (q_WF == nullptr || q_WH == nullptr) return;
    const Rotations q_FH = Relative(*q_WF, *q_WH);
    const Side side = estimate_.side;
    AddAngles("wrist_flexion_deg", q_FH,
              [side](const auto& q) { return WristAnglesFrom(q, side).flexion; });
    AddAngles("wrist_deviation_deg", q_FH,
              [side](const auto& q) { return WristAnglesFrom(q, side).deviation; });
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
      throw InputError(table.file, CsvTable::Line(row),
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

std::vector<Eigen::Vector3d> ReadPositions(const CsvTable& table, const std::string& name) {
  const auto &x = table.Column(name + "_px"), &y = table.Column(name + "_py"),
             &z = table.Column(name + "_pz");
  std::vector<Eigen::Vector3d> positions;
  positions.reserve(table.rows);
  for (std::size_t row = 0; row < table.rows; ++row) positions.emplace_back(x[row], y[row], z[row]);
  return positions;
}

}  // namespace

void WriteEstimateCsv(const Estimate& estimate, const std::string& file) {
  Table(estimate).Write(file);
}

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
      estimate.p_W[name] = ReadPositions(table, name);
    }
  return estimate;
}

}  // namespace brachium
