#include "bin/evaluation_text.h"

#include <cmath>
#include <string>
#include <vector>

#include "bin/table.h"
#include "io/text.h"
#include "problems/arm_model.h"

namespace brachium {
namespace {

constexpr double kMillimetre = 1e-3;  // [m]

std::string Number(double value, double unit, int digits) {
  if (!std::isfinite(value)) return "-";
  const std::string text = Fixed(value / unit, digits);
  const bool is_zero = text.find_first_of("123456789") == std::string::npos;
  return is_zero ? Fixed(0.0, digits) : text;
}

std::string Degrees(double angle) { return Number(angle, kDegree, 2); }
std::string Millimetres(double length) { return Number(length, kMillimetre, 1); }

std::string Section(const std::string& title, const Table& table) {
  return table.empty() ? "" : "\n" + title + "\n" + table.Text();
}

void AddOrientation(const std::string& name, const OrientationErrors& errors, Table* table) {
  table->Add({name, Degrees(errors.rotation.rmse), Degrees(errors.rotation.median),
              Degrees(errors.rotation.p95), Degrees(errors.rotation.max),
              Degrees(errors.inclination.rmse), Degrees(errors.heading.rmse)});
}

Table OrientationTable() {
  return Table({"", "rmse", "median", "95 %", "max", "inclination", "heading"});
}

Table Orientations(const Evaluation& evaluation) {
  Table table = OrientationTable();
  for (const auto& [segment, orientation] : evaluation.orientation)
    AddOrientation(std::string(Name(segment)), orientation.aligned, &table);
  return table;
}

Table RelativeOrientations(const Evaluation& evaluation) {
  Table table = OrientationTable();
  for (const RelativeEvaluation& relative : evaluation.relative) {
    AddOrientation(relative.name + ", raw", relative.orientation.raw, &table);
    AddOrientation(relative.name + ", aligned", relative.orientation.aligned, &table);
  }
  return table;
}

Table JointAngles(const Evaluation& evaluation) {
  Table table({"", "bias", "sd", "rmse", "median", "95 %", "max", "correlation"});
  for (const auto& [name, error] : evaluation.joint_angles)
    table.Add({name, Degrees(error.bias), Degrees(error.sd), Degrees(error.rmse),
               Degrees(error.median), Degrees(error.p95), Degrees(error.max),
               error.correlation ? Fixed(*error.correlation, 4) : "-"});
  return table;
}

Table Positions(const Evaluation& evaluation) {
  Table table({"", "rmse", "median", "95 %", "max", "at the end", "path"});
  for (const auto& [name, position] : evaluation.positions) {
    const Statistics& distance = position.aligned.distance;
    table.Add({name, Millimetres(distance.rmse), Millimetres(distance.median),
               Millimetres(distance.p95), Millimetres(distance.max),
               Millimetres(position.final_horizontal), Millimetres(position.path_length)});
  }
  return table;
}

std::string ClockText(const ClockOffset& offset) {
  const std::string seconds = Fixed(offset.seconds, 4) + " s";
  switch (offset.source) {
    case ClockOffset::Source::kGiven:
      return "Clock offset of the reference " + seconds + ", as stated\n";
    case ClockOffset::Source::kEstimated:
      return "Clock offset of the reference " + seconds + ", from the two motions\n";
    case ClockOffset::Source::kUnknown:
      break;
  }
  return "Clock offset of the reference unknown, taken as 0 s\n";
}

std::string RelativeTitle(const Evaluation& evaluation) {
  return evaluation.frames == Reference::Frames::kSegment
             ? "Between segments [deg]; raw is the figure to go by"
             : "Between segments [deg]; aligned by a constant on each side, the figure to go by";
}

}  // namespace

std::string EvaluationText(const Evaluation& evaluation) {
  return "Method " + evaluation.method + ": " + std::to_string(evaluation.used) + " of " +
         std::to_string(evaluation.reference_samples) + " instants compared\n" +
         "Heading removed " + Degrees(evaluation.heading) + " deg\n" +
         ClockText(evaluation.clock_offset) +
         Section("Segments after one constant heading [deg]", Orientations(evaluation)) +
         Section(RelativeTitle(evaluation), RelativeOrientations(evaluation)) +
         Section("Joint angles [deg]", JointAngles(evaluation)) +
         Section("Points after one constant heading and shift [mm]", Positions(evaluation)) + "\n";
}

}  // namespace brachium
