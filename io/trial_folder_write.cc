#include <nlohmann/json.hpp>

#include "io/csv_columns.h"
#include "io/output_folder.h"
#include "io/trial_folder.h"

namespace brachium {
namespace {

using Json = nlohmann::ordered_json;

Json ToJson(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

Json ToJson(const SegmentGeometry& geometry) {
  const Eigen::Vector3d& p = geometry.p_distal_B;
  Json json;
  if (p.x() == 0.0 && p.z() == 0.0 && p.y() < 0.0)
    json["length_m"] = -p.y();
  else
    json["distal_joint_m"] = ToJson(p);
  json["length_sigma_m"] = geometry.sigma;
  return json;
}

Json ToJson(const ElbowModel& elbow) {
  return {{"constraint", elbow.adduction_constraint ? "adduction" : "none"},
          {"carrying_angle_deg", elbow.carrying_angle / kDegree},
          {"carrying_angle_sigma_deg", elbow.carrying_angle_sigma / kDegree},
          {"carrying_slope_sigma_deg", elbow.carrying_slope_sigma / kDegree}};
}

Json ToJson(const ArmModel& arm) {
  Json segments = Json::object();
  for (const auto& [segment, geometry] : arm.segments)
    segments[std::string(Name(segment))] = ToJson(geometry);
  return {{"side", Name(arm.side)},
          {"segments", segments},
          {"elbow", ToJson(arm.elbow)},
          {"shoulder",
           {{"sigma_m", arm.shoulder.sigma}, {"correlation_s", arm.shoulder.correlation_time}}}};
}

Json ToJson(const Mounting& mounting) {
  const Eigen::Quaterniond& q = mounting.q_BS;
  return {{"q_BS_wxyz", {q.w(), q.x(), q.y(), q.z()}},
          {"q_sigma_deg", mounting.q_sigma / kDegree},
          {"p_BS_m", ToJson(mounting.p_BS_B)},
          {"p_sigma_m", mounting.p_sigma}};
}

Json ToJson(const ImuNoise& noise) {
  return {{"preset", "mtw"},
          {"gyro_density_deg_s_rthz", noise.gyro_density / kDegree},
          {"gyro_bias_sigma_deg_s", noise.gyro_bias_sigma / kDegree},
          {"gyro_bias_walk_deg_s_rts", noise.gyro_bias_walk / kDegree},
          {"accel_density_m_s2_rthz", noise.accel_density},
          {"accel_bias_sigma_m_s2", noise.accel_bias_sigma}};
}

std::string CsvName(const Recording& recording) {
  return std::string(Name(recording.segment)) + ".csv";
}

Json ToJson(const Recording& recording) {
  Json json = {
      {"segment", Name(recording.segment)}, {"file", CsvName(recording)}, {"format", "csv"}};
  if (recording.mounting) json["mounting"] = ToJson(*recording.mounting);
  json["noise"] = ToJson(recording.noise);
  return json;
}

Json ToJson(const HeldPose& pose) {
  Json json = {{"at_s", pose.time}, {"sd_deg", pose.sigma / kDegree}};
  if (pose.elbow_flexion) json["elbow_flexion_deg"] = *pose.elbow_flexion / kDegree;
  if (pose.forearm_pronation) json["forearm_pronation_deg"] = *pose.forearm_pronation / kDegree;
  if (pose.shoulder_elevation) json["shoulder_elevation_deg"] = *pose.shoulder_elevation / kDegree;
  return json;
}

Json ToJson(const Contact& contact) {
  return {{"point", DistalJointName(contact.segment)},
          {"at_s", contact.times},
          {"place", contact.place},
          {"sigma_m", contact.sigma},
          {"axes", contact.height_only ? "height" : "all"}};
}

Json ToJson(const Reference& reference) {
  const bool cluster = reference.frames == Reference::Frames::kCluster;
  Json json = {{"file", "reference.csv"}, {"frames", cluster ? "cluster" : "segment"}};
  if (reference.clock_offset) json["clock_offset_s"] = *reference.clock_offset;
  return json;
}

Json ToJson(const Trial& trial, bool simulated) {
  const Observations& observations = trial.observations;
  Json json = {{"brachium_trial", 1}, {"name", trial.name}};
  if (simulated) json["simulated"] = true;
  json["gravity_m_s2"] = observations.gravity;
  json["arm"] = ToJson(observations.arm);
  for (const Recording& recording : observations.recordings)
    json["recordings"].push_back(ToJson(recording));
  for (const Interval& interval : observations.intervals)
    json["intervals"].push_back(
        {{"label", interval.label}, {"start_s", interval.start}, {"end_s", interval.end}});
  if (observations.start_pose) json["start_pose"] = ToJson(*observations.start_pose);
  if (observations.end_pose) json["end_pose"] = ToJson(*observations.end_pose);
  for (const Contact& contact : observations.contacts) json["contacts"].push_back(ToJson(contact));
  if (trial.reference) json["reference"] = ToJson(*trial.reference);
  return json;
}

void WriteReference(const Reference& reference, const std::string& file) {
  std::vector<CsvColumn> columns = {{"time_s", reference.time.data(), 1}};
  for (const auto& [segment, q_VB] : reference.q_VB)
    AddRotation(std::string(Name(segment)) + "_q", q_VB, &columns);
  for (const auto& [name, p_V] : reference.p_V) AddVector(name + "_p", p_V, &columns);
  WriteCsv(file, reference.time.size(), columns);
}

}  // namespace

void WriteTrial(const std::string& folder, const Trial& trial, const TrialExtras& extras,
                bool overwrite) {
  OutputFolder output(folder, {.what = "a trial", .marker = "trial.json", .fresh = {}, .stale = {}},
                      overwrite);
  for (const Recording& recording : trial.observations.recordings)
    WriteRecording(recording, output.File(CsvName(recording)));
  if (trial.reference) WriteReference(*trial.reference, output.File("reference.csv"));
  if (!extras.truth_json.empty()) output.Write("truth.json", extras.truth_json);
  output.Write("trial.json", ToJson(trial, extras.simulated).dump(2) + "\n");
  output.Commit();
}

}  // namespace brachium
