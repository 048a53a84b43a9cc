#include "io/formats/opensim_write.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <vector>

#include "io/output_folder.h"
#include "io/text.h"
#include "problems/arm_angles.h"
#include "problems/arm_model.h"

namespace brachium {
namespace {

struct Column {
  std::string label;
  std::vector<double> values;  // [deg]
};

// The body of an OpenSim arm that a segment is; the girdle has no one body.
std::optional<std::string> BodyOf(Segment segment, Side side) {
  const std::string end = side == Side::kRight ? "_r" : "_l";
  switch (segment) {
    case Segment::kThorax:
      return "torso";
    case Segment::kGirdle:
      return std::nullopt;
    case Segment::kUpperArm:
      return "humerus" + end;
    case Segment::kForearm:
      return "radius" + end;
    case Segment::kHand:
      return "hand" + end;
  }
  return std::nullopt;
}

double RateOf(const std::vector<double>& time) {
  std::vector<double> steps;
  for (std::size_t i = 0; i + 1 < time.size(); ++i) steps.push_back(time[i + 1] - time[i]);
  if (steps.empty()) return 0.0;
  std::ranges::nth_element(steps, steps.begin() + std::ssize(steps) / 2);
  return 1.0 / steps[steps.size() / 2];
}

std::string Cell(const Eigen::Quaterniond& q) {
  return Shortest(q.w()) + "," + Shortest(q.x()) + "," + Shortest(q.y()) + "," + Shortest(q.z());
}

std::string Orientations(const Estimate& estimate) {
  std::string labels = "time", rows;
  std::vector<const std::vector<Eigen::Quaterniond>*> bodies;
  for (const auto& [segment, q_WB] : estimate.q_WB)
    if (const auto body = BodyOf(segment, estimate.side)) {
      labels.append("\t").append(*body).append("_imu");
      bodies.push_back(&q_WB);
    }
  if (bodies.empty()) throw std::invalid_argument("the estimate has no attitude of a body");
  for (std::size_t i = 0; i < estimate.time.size(); ++i) {
    std::string row = Shortest(estimate.time[i]);
    bool known = true;
    for (const auto* q_WB : bodies) {
      known = known && (*q_WB)[i].coeffs().allFinite();
      row.append("\t").append(Cell((*q_WB)[i]));
    }
    if (known) rows += row + "\n";
  }
  return "DataRate=" + Fixed(RateOf(estimate.time), 6) +
         "\nDataType=Quaternion\nversion=3\nOpenSimVersion=4.4\nendheader\n" + labels + "\n" + rows;
}

// Angles by their coordinate in the model; those that are never known are left out.
std::vector<Column> Coordinates(const Estimate& estimate) {
  const auto series = JointAngleSeries(estimate.q_WB, estimate.side);
  std::vector<Column> columns;
  const auto add = [&](const char* label, const char* angle, const char* plus, double offset) {
    const auto found = series.find(angle), other = series.find(plus);
    if (found == series.end() || (*plus != '\0' && other == series.end())) return;
    Column column{label, {}};
    for (std::size_t i = 0; i < found->second.size(); ++i)
      column.values.push_back(
          (found->second[i] + (*plus != '\0' ? other->second[i] : 0.0)) / kDegree + offset);
    if (std::ranges::any_of(column.values, [](double v) { return std::isfinite(v); }))
      columns.push_back(std::move(column));
  };
  add("elv_angle", "shoulder_plane", "", 0.0);
  add("shoulder_elv", "shoulder_elevation", "", 0.0);
  add("shoulder_rot", "shoulder_rotation", "shoulder_plane", 0.0);
  add("elbow_flexion", "elbow_flexion", "", 0.0);
  add("pro_sup", "forearm_pronation", "", -90.0);
  return columns;
}

std::string JointAngles(const Estimate& estimate) {
  const std::vector<Column> columns = Coordinates(estimate);
  std::string labels = "time", rows;
  std::size_t count = 0;
  for (const Column& column : columns) labels.append("\t").append(column.label);
  for (std::size_t i = 0; i < estimate.time.size(); ++i) {
    std::string row = Shortest(estimate.time[i]);
    bool known = true;
    for (const Column& column : columns) {
      known = known && std::isfinite(column.values[i]);
      row.append("\t").append(Shortest(column.values[i]));
    }
    if (!known) continue;
    rows += row + "\n";
    ++count;
  }
  return "Coordinates\nversion=1\nnRows=" + std::to_string(count) +
         "\nnColumns=" + std::to_string(columns.size() + 1) + "\ninDegrees=yes\nendheader\n" +
         labels + "\n" + rows;
}

std::string Setup(const std::string& tool, const std::string& members) {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\" ?>\n<OpenSimDocument Version=\"40000\">\n  <" +
         tool + ">\n" + members + "    <sensor_to_opensim_rotations>-1.5707963 0 0" +
         "</sensor_to_opensim_rotations>\n  </" + tool + ">\n</OpenSimDocument>\n";
}

std::string Member(const std::string& name, const std::string& value) {
  return "    <" + name + ">" + value + "</" + name + ">\n";
}

// With a thorax its heading is turned to the model's; its X is forward.
std::string PlacerSetup(const Estimate& estimate) {
  const bool thorax = estimate.q_WB.contains(Segment::kThorax);
  return Setup("IMUPlacer", Member("model_file", "model.osim") +
                                Member("base_imu_label", thorax ? "torso_imu" : "") +
                                Member("base_heading_axis", thorax ? "x" : "") +
                                Member("orientation_file_for_calibration", "orientations.sto") +
                                Member("output_model_file", "calibrated_model.osim"));
}

std::string InverseKinematicsSetup(const Estimate& estimate) {
  const std::string range = estimate.time.empty() ? "0 0"
                                                  : Shortest(estimate.time.front()) + " " +
                                                        Shortest(estimate.time.back());
  return Setup("IMUInverseKinematicsTool", Member("time_range", range) +
                                               Member("model_file", "calibrated_model.osim") +
                                               Member("orientations_file", "orientations.sto") +
                                               Member("results_directory", "inverse_kinematics"));
}

}  // namespace

void WriteOpenSim(const std::string& folder, const Estimate& estimate, bool overwrite) {
  OutputFolder output(
      folder, {.what = "an OpenSim folder", .marker = "orientations.sto", .fresh = {}, .stale = {}},
      overwrite);
  output.Write("orientations.sto", Orientations(estimate));
  output.Write("joint_angles.mot", JointAngles(estimate));
  output.Write("placer_setup.xml", PlacerSetup(estimate));
  output.Write("ik_setup.xml", InverseKinematicsSetup(estimate));
  output.Commit();
}

}  // namespace brachium
