#include "io/evaluation_file.h"

#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "io/outcomes_json.h"
#include "io/output_folder.h"
#include "problems/arm_model.h"

namespace brachium {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;  // a number that is NaN becomes null

struct Unit {
  const char* suffix;
  double size;  // in SI
};
constexpr Unit kDegrees{"_deg", kDegree};
constexpr Unit kMetres{"_m", 1.0};
constexpr std::array kAxes = {"x", "y", "z"};

Json OrNull(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json ToJson(const Statistics& statistics, const Unit& unit) {
  Json json = {{"samples_used", statistics.used}, {"samples_left_out", statistics.left_out}};
  const auto add = [&](const std::string& name, double value) {
    json[name + unit.suffix] = value / unit.size;
  };
  add("bias", statistics.bias);
  add("sd", statistics.sd);
  add("rmse", statistics.rmse);
  add("median", statistics.median);
  add("p95", statistics.p95);
  add("max", statistics.max);
  json["correlation"] = OrNull(statistics.correlation);
  return json;
}

Json ToJson(const OrientationErrors& errors) {
  Json json = ToJson(errors.rotation, kDegrees);
  json["inclination"] = ToJson(errors.inclination, kDegrees);
  json["heading"] = ToJson(errors.heading, kDegrees);
  for (std::size_t i = 0; i < 3; ++i) json[kAxes[i]] = ToJson(errors.axis[i], kDegrees);
  return json;
}

Json ToJson(const Eigen::Quaterniond& q) { return {q.w(), q.x(), q.y(), q.z()}; }

enum class Headline { kRaw, kAligned };

Json ToJson(const OrientationEvaluation& orientation, Headline headline,
            const std::string& alignment) {
  Json json = {{"alignment", alignment}};
  json.update(ToJson(headline == Headline::kRaw ? orientation.raw : orientation.aligned));
  json["raw"] = ToJson(orientation.raw);
  json["aligned"] = ToJson(orientation.aligned);
  json["removed"] = {{"proximal_wxyz", ToJson(orientation.alignment.proximal)},
                     {"distal_wxyz", ToJson(orientation.alignment.distal)}};
  return json;
}

Json OrientationsOf(const Evaluation& evaluation) {
  const bool cluster = evaluation.frames == Reference::Frames::kCluster;
  Json json = Json::object();
  for (const auto& [segment, orientation] : evaluation.orientation)
    json[std::string(Name(segment))] = ToJson(
        orientation, Headline::kAligned,
        cluster ? "one heading of all segments, one constant rotation of this segment's frame"
                : "one heading of all segments");
  return json;
}

Json RelativesOf(const Evaluation& evaluation) {
  const bool cluster = evaluation.frames == Reference::Frames::kCluster;
  Json json = Json::object();
  for (const RelativeEvaluation& relative : evaluation.relative)
    json[relative.name] = cluster ? ToJson(relative.orientation, Headline::kAligned,
                                           "one constant rotation on each side")
                                  : ToJson(relative.orientation, Headline::kRaw, "none");
  return json;
}

Json ToJson(const std::optional<LimitsOfAgreement>& limits) {
  if (!limits) return nullptr;
  return {{"lower_deg", limits->lower / kDegree}, {"upper_deg", limits->upper / kDegree}};
}

Json JointAnglesOf(const Evaluation& evaluation) {
  Json json = Json::object();
  for (const auto& [name, angle] : evaluation.joint_angles) {
    json[name] = ToJson(angle, kDegrees);
    json[name]["concordance"] = OrNull(angle.concordance);
    json[name]["limits_of_agreement"] = ToJson(angle.limits);
  }
  return json;
}

Json ToJson(const PositionErrors& errors) {
  Json json = ToJson(errors.distance, kMetres);
  json["horizontal"] = ToJson(errors.horizontal, kMetres);
  for (std::size_t i = 0; i < 2; ++i) json[kAxes[i]] = ToJson(errors.axis[i], kMetres);
  json["vertical"] = errors.vertical ? ToJson(*errors.vertical, kMetres) : Json(nullptr);
  return json;
}

Json ToJson(const PositionEvaluation& position) {
  const double percent = 100.0 / position.path_length;
  const double rms = position.aligned.horizontal.rmse;
  Json json = {{"alignment", "one heading and one shift of all points"}};
  json.update(ToJson(position.aligned));
  json["path_length_m"] = position.path_length;
  json["final_horizontal_m"] = position.final_horizontal;
  json["final_horizontal_percent_of_path"] = position.final_horizontal * percent;
  json["closing_horizontal_m"] = position.closing_horizontal;
  json["closing_horizontal_percent_of_path"] = position.closing_horizontal * percent;
  json["rms_horizontal_m"] = rms;
  json["rms_horizontal_percent_of_path"] = rms * percent;
  json["raw"] = ToJson(position.raw);
  json["aligned"] = ToJson(position.aligned);
  return json;
}

Json PositionsOf(const Evaluation& evaluation) {
  Json json = Json::object();
  for (const auto& [name, position] : evaluation.positions) json[name] = ToJson(position);
  return json;
}

std::string NameOf(ClockOffset::Source source) {
  switch (source) {
    case ClockOffset::Source::kGiven:
      return "given";
    case ClockOffset::Source::kEstimated:
      return "estimated";
    case ClockOffset::Source::kUnknown:
      break;
  }
  return "unknown";
}

Json ToJson(const ClockOffset& offset) {
  return {{"seconds", offset.seconds},
          {"source", NameOf(offset.source)},
          {"estimated", offset.source == ClockOffset::Source::kEstimated},
          {"correlation", OrNull(offset.correlation)}};
}

}  // namespace

std::string EvaluationJson(const Evaluation& evaluation) {
  const PointAlignment& points = evaluation.point_alignment;
  const Json json = {
      {"brachium_evaluation", 1},
      {"method", evaluation.method},
      {"frames", evaluation.frames == Reference::Frames::kCluster ? "cluster" : "segment"},
      {"clock_offset", ToJson(evaluation.clock_offset)},
      {"samples",
       {{"reference", evaluation.reference_samples},
        {"used", evaluation.used},
        {"left_out", evaluation.reference_samples - evaluation.used}}},
      {"removed",
       {{"heading_of_orientations_deg", evaluation.heading / kDegree},
        {"heading_of_positions_deg", points.heading / kDegree},
        {"shift_of_positions_m", {points.shift.x(), points.shift.y(), points.shift.z()}}}},
      {"orientation", OrientationsOf(evaluation)},
      {"relative", RelativesOf(evaluation)},
      {"joint_angles", JointAnglesOf(evaluation)},
      {"positions", PositionsOf(evaluation)},
      {"outcomes",
       {{"estimate", ToJson(evaluation.outcomes)},
        {"reference", ToJson(evaluation.reference_outcomes)}}}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void WriteEvaluation(const std::string& folder, const Evaluation& evaluation, bool overwrite) {
  WriteOneFile((fs::path(folder) / "evaluation.json").string(), EvaluationJson(evaluation),
               overwrite);
}

}  // namespace brachium
