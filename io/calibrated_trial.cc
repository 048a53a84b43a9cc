#include "io/calibrated_trial.h"

#include <filesystem>

#include "io/file_bytes.h"

namespace brachium {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

void EnterRotation(const Mounting& mounting, const std::string& key, Json& entry) {
  const Eigen::Quaterniond& q = mounting.q_BS;
  entry[key] = {q.w(), q.x(), q.y(), q.z()};
  entry["q_sigma_deg"] = mounting.q_sigma / kDegree;
}

void EnterPosition(const Mounting& mounting, Json& entry) {
  const Eigen::Vector3d& p = mounting.p_BS_B;
  entry["p_BS_m"] = {p.x(), p.y(), p.z()};
  entry["p_sigma_m"] = mounting.p_sigma;
}

void LeaveOutUnmounted(Json& recordings) {
  Json mounted = Json::array();
  for (const Json& entry : recordings)
    if (entry.contains("mounting")) mounted.push_back(entry);
  recordings = mounted;
}

// A file's name as seen from another folder.
void Rebase(const fs::path& from, const fs::path& to, Json& node) {
  const fs::path file = fs::absolute(from / node["file"].get<std::string>());
  node["file"] = file.lexically_normal().lexically_relative(to).generic_string();
}

fs::path Folder(const fs::path& path) { return fs::absolute(path).lexically_normal(); }

}  // namespace

std::string WithMountings(const std::string& trial, const std::map<Segment, Mounting>& mountings,
                          const std::map<Segment, Mounting>& clusters, const Json& calibration,
                          const std::string& output) {
  const FileBytes bytes((fs::path(trial) / "trial.json").string());
  Json json = Json::parse(bytes.text());
  const fs::path to = Folder(output).parent_path();
  for (Json& entry : json["recordings"]) {
    Rebase(trial, to, entry);
    const auto segment = SegmentFromName(entry["segment"].get<std::string>());
    if (const auto found = mountings.find(*segment); found != mountings.end()) {
      const bool placed = !entry.contains("mounting") && !found->second.p_BS_B.isZero();
      EnterRotation(found->second, "q_BS_wxyz", entry["mounting"]);
      if (placed) EnterPosition(found->second, entry["mounting"]);
    }
  }
  LeaveOutUnmounted(json["recordings"]);
  if (json.contains("reference")) Rebase(trial, to, json["reference"]);
  for (const auto& [segment, mounting] : clusters)
    EnterRotation(mounting, "q_BC_wxyz", json["reference"]["clusters"][std::string(Name(segment))]);
  json["calibration"] = calibration;
  return json.dump(2) + "\n";
}

}  // namespace brachium
