#include "io/summary.h"

namespace brachium {
namespace {

using Json = nlohmann::ordered_json;

Json Convergence(const Diagnostics& diagnostics) {
  return {{"converged", diagnostics.converged},        {"singular", diagnostics.singular},
          {"termination", diagnostics.termination},    {"iterations", diagnostics.iterations},
          {"initial_cost", diagnostics.initial_cost},  {"final_cost", diagnostics.final_cost},
          {"gradient_norm", diagnostics.gradient_norm}};
}

Json Residuals(const Diagnostics& diagnostics) {
  Json json = Json::object();
  for (const ResidualStatistics& residual : diagnostics.residuals)
    json[residual.kind] = {{"count", residual.count}, {"rms", residual.rms}};
  return json;
}

Json NumberOrList(const std::vector<double>& numbers) {
  return numbers.size() == 1 ? Json(numbers[0]) : Json(numbers);
}

Json Constants(const Diagnostics& diagnostics) {
  Json json = Json::object();
  for (const Constant& constant : diagnostics.constants) {
    json[constant.name]["value"] = NumberOrList(constant.value);
    if (!constant.sd.empty()) json[constant.name]["sd"] = NumberOrList(constant.sd);
  }
  return json;
}

Json Rests(const Diagnostics& diagnostics) {
  Json json = Json::array();
  for (const Rest& rest : diagnostics.rests)
    json.push_back({{"segment", Name(rest.segment)},
                    {"start_s", rest.start},
                    {"end_s", rest.end},
                    {"certainty", rest.certainty}});
  return json;
}

Json Epochs(const Diagnostics& diagnostics) {
  Json json = Json::array();
  for (const Epoch& epoch : diagnostics.epochs)
    json.push_back(
        {{"segment", Name(epoch.segment)}, {"start_s", epoch.start}, {"end_s", epoch.end}});
  return json;
}

Json InDegrees(const std::vector<double>& radians) {
  Json json = Json::array();
  for (const double angle : radians) json.push_back(angle / kDegree);
  return json;
}

// Infinity, where a relation tells nothing, becomes null.
Json Headings(const Diagnostics& diagnostics) {
  Json json = Json::array();
  for (const HeadingSupport& support : diagnostics.headings) {
    Json by = Json::object();
    for (const auto& [kind, sd] : support.sd_by) by[kind] = InDegrees(sd);
    json.push_back({{"segment", Name(support.segment)},
                    {"against", Name(support.against)},
                    {"time_s", support.time},
                    {"sd_deg", InDegrees(support.sd)},
                    {"sd_by_deg", by}});
  }
  return json;
}

Json Figures(const Diagnostics& diagnostics) {
  Json json = Json::object();
  for (const Figure& figure : diagnostics.figures) json[figure.name] = figure.value;
  return json;
}

Json ToJson(const RecordingFacts& facts) {
  return {{"segment", Name(facts.segment)},
          {"file", facts.file},
          {"samples", facts.samples},
          {"rate_hz", facts.rate_hz},
          {"start_s", facts.start_s},
          {"duration_s", facts.duration_s},
          {"lost_samples", facts.lost_samples},
          {"gaps", facts.gaps},
          {"longest_step_s", facts.longest_step_s},
          {"not_finite_rows", facts.not_finite_rows},
          {"not_later_rows", facts.not_later_rows},
          {"cut_off", facts.cut_off}};
}

Json Recordings(const RunInfo& run) {
  Json json = Json::array();
  for (const RecordingFacts& facts : run.recordings) json.push_back(ToJson(facts));
  return json;
}

Json Inputs(const RunInfo& run) {
  Json json = Json::array();
  for (const InputFile& input : run.inputs)
    json.push_back({{"file", input.path}, {"sha256", input.sha256}});
  return json;
}

Json Versions(const RunInfo& run) {
  Json json = Json::object();
  for (const auto& [name, version] : run.versions) json[name] = version;
  return json;
}

Json Options(const RunInfo& run) { return run.options.is_null() ? Json::object() : run.options; }

// What the columns of estimate.csv mean, for a reader who has nothing but the folder.
Json Conventions() {
  return {
      {"time_s", "sample times of the first recording: the centre of each sample's interval"},
      {"world", "right-handed, z up; the heading about z and the origin are free"},
      {"segments",
       "axes after ISB on both sides: x anterior (volar), y proximal along the segment, "
       "z to the person's right"},
      {"NAME_qw.._qz", "Hamilton unit quaternion that takes vectors from segment to world axes"},
      {"NAME_rx_sd_deg.._rz_sd_deg",
       "standard deviation of that rotation about the segment's own axes"},
      {"NAME_px.._pz",
       "position of a joint in the world [m]; with one recording alone, of its sensor"},
      {"angles",
       "in degrees, the same for the same movement on both sides: elbow flexion; carrying "
       "angle, valgus positive; forearm pronation, 0 fully supinated; shoulder plane, 0 "
       "abduction and 90 forward flexion; shoulder elevation from hanging; shoulder "
       "rotation, internal positive; wrist flexion, palmar positive; wrist deviation, "
       "ulnar positive"},
      {"empty cell", "not covered by the sensors, or an angle that is not defined there"}};
}

void AddStages(const std::vector<StageTime>& stages, Json* json) {
  for (const StageTime& stage : stages)
    json->push_back({{"stage", stage.stage}, {"seconds", stage.seconds}});
}

}  // namespace

Json SummaryOf(const Estimate& estimate, const RunInfo& run) {
  const Diagnostics& diagnostics = estimate.diagnostics;
  return {{"brachium_summary", 1},
          {"trial", run.trial},
          {"side", Name(estimate.side)},
          {"method", estimate.method},
          {"options", Options(run)},
          {"samples", estimate.Instants()},
          {"convergence", Convergence(diagnostics)},
          {"residuals", Residuals(diagnostics)},
          {"constants", Constants(diagnostics)},
          {"rests", Rests(diagnostics)},
          {"epochs", Epochs(diagnostics)},
          {"headings", Headings(diagnostics)},
          {"figures", Figures(diagnostics)},
          {"held_by_prior", diagnostics.held_by_prior},
          {"notes", diagnostics.notes},
          {"defaults", run.findings.defaults},
          {"repairs", run.findings.repairs},
          {"warnings", run.findings.warnings},
          {"recordings", Recordings(run)},
          {"versions", Versions(run)},
          {"inputs", Inputs(run)},
          {"conventions", Conventions()}};
}

bool TellsOfTheSame(const Json& summary, const std::string& method, const RunInfo& run) {
  const auto says = [&](const char* key, const Json& value) {
    return summary.contains(key) && summary[key] == Json::parse(value.dump());
  };
  return says("method", method) && says("options", Options(run)) &&
         says("versions", Versions(run)) && says("inputs", Inputs(run));
}

Json TimingOf(const Estimate& estimate, const RunInfo& run) {
  Json stages = Json::array();
  AddStages(run.stages, &stages);
  AddStages(estimate.timing, &stages);
  return {{"stages", stages}, {"host", run.host}, {"command_line", run.command_line}};
}

}  // namespace brachium
