#include "io/reference_csv.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

#include "io/clock.h"
#include "io/csv.h"
#include "io/formats/motion_table.h"
#include "io/input_error.h"
#include "io/json_defaults.h"
#include "io/mounting_json.h"
#include "io/text.h"

namespace brachium {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kFarPoint = 100.0;  // [m]
constexpr std::array<std::string_view, 6> kReferenceKeys = {"file", "frames",         "columns",
                                                            "up",   "clock_offset_s", "clusters"};
constexpr std::array<std::string_view, 2> kClusterKeys = {"q_BC_wxyz", "q_sigma_deg"};
constexpr std::array<std::string_view, 4> kJoints = {"shoulder", "elbow", "wrist", "hand"};

const Eigen::Quaterniond& ZUpFromYUp() {
  static const Eigen::Quaterniond q(std::sqrt(0.5), std::sqrt(0.5), 0.0, 0.0);
  return q;
}

bool IsKnownName(const std::string& name) {
  return SegmentFromName(name) || std::ranges::find(kJoints, name) != kJoints.end();
}

std::string OneOf(const JsonNode& node, std::string_view a, std::string_view b) {
  const std::string text = node.Text();
  if (text != a && text != b)
    node.Fail("is '" + text + "'; expected '" + std::string(a) + "' or '" + std::string(b) + "'");
  return text;
}

// Reads one quantity after the other out of the table.
class ReferenceReader {
 public:
  ReferenceReader(const CsvTable& table, const ReferenceEntry& entry)
      : table_(table),
        entry_(entry),
        usable_(FindUsableRows(table, [](std::size_t) { return true; })) {}

  const UsableRows& Usable() const { return usable_; }

  std::vector<double> Times() const {
    const std::vector<double>& column = table_.Column("time_s");
    std::vector<double> time;
    for (const std::size_t row : usable_.rows) time.push_back(column[row]);
    return time;
  }

  bool HasRotation(const std::string& name) const {
    return HasAny(name, {"_qw", "_qx", "_qy", "_qz"});
  }
  bool HasPosition(const std::string& name) const { return HasAny(name, {"_px", "_py", "_pz"}); }

  std::vector<Eigen::Quaterniond> Rotations(const std::string& name) const {
    const auto &w = Column(name, "_qw"), &x = Column(name, "_qx"), &y = Column(name, "_qy"),
               &z = Column(name, "_qz");
    std::vector<Eigen::Quaterniond> rotations;
    rotations.reserve(usable_.rows.size());
    for (const std::size_t row : usable_.rows)
      rotations.push_back(Checked({w[row], x[row], y[row], z[row]}, name, row));
    return rotations;
  }

  std::vector<Eigen::Vector3d> Positions(const std::string& name) const {
    const auto &x = Column(name, "_px"), &y = Column(name, "_py");
    const std::vector<double>* const z =
        table_.Has(InFile(name) + "_pz") ? &Column(name, "_pz") : nullptr;
    std::vector<Eigen::Vector3d> positions;
    positions.reserve(usable_.rows.size());
    for (const std::size_t row : usable_.rows)
      positions.push_back(Upright({x[row], y[row], z != nullptr ? (*z)[row] : kNaN}));
    return positions;
  }

 private:
  std::string InFile(const std::string& name) const {
    const auto mapped = entry_.columns.find(name);
    return mapped != entry_.columns.end() ? mapped->second : name;
  }

  bool HasAny(const std::string& name, std::initializer_list<const char*> endings) const {
    return std::ranges::any_of(endings,
                               [&](const char* end) { return table_.Has(InFile(name) + end); });
  }

  const std::vector<double>& Column(const std::string& name, const char* ending) const {
    return table_.Column(InFile(name) + ending);
  }

  Eigen::Quaterniond Checked(const Eigen::Quaterniond& q_VB, const std::string& name,
                             std::size_t row) const {
    const double norm = q_VB.norm();
    if (!std::isfinite(norm)) return Eigen::Quaterniond(kNaN, kNaN, kNaN, kNaN);
    if (std::abs(norm - 1.0) > kUnitNormTolerance)
      throw InputError(table_.file, table_.Line(row),
                       InFile(name) + "_qw.._qz have the norm " + Fixed(norm, 4) +
                           "; expected a unit quaternion, or empty cells for a gap");
    return entry_.up_is_y ? ZUpFromYUp() * q_VB.normalized() : q_VB.normalized();
  }

  Eigen::Vector3d Upright(const Eigen::Vector3d& p) const {
    const Eigen::Vector3d p_V = entry_.up_is_y ? Eigen::Vector3d(p.x(), -p.z(), p.y()) : p;
    return p_V.unaryExpr([](double c) { return std::isfinite(c) ? c : kNaN; });
  }

  const CsvTable& table_;
  const ReferenceEntry& entry_;
  const UsableRows usable_;
};

void WarnOfMillimetres(const Reference& reference, const std::string& name, Findings* findings) {
  for (const auto& [point, p_V] : reference.p_V) {
    const auto is_far = [](const Eigen::Vector3d& p) { return p.head<2>().norm() > kFarPoint; };
    if (std::ranges::any_of(p_V, is_far))
      findings->warnings.push_back(name + ": the positions of " + point + " reach beyond " +
                                   Fixed(kFarPoint, 0) +
                                   " m; expected metres, and this looks like millimetres");
  }
}

// Joints, and segments that wear a sensor.
std::set<std::string> PointNames(const std::set<Segment>& recorded) {
  std::set<std::string> names(kJoints.begin(), kJoints.end());
  for (const Segment segment : recorded) names.emplace(Name(segment));
  return names;
}

void CheckMappedNames(const ReferenceReader& reader, const ReferenceEntry& entry,
                      const CsvTable& table) {
  for (const auto& [name, in_file] : entry.columns)
    if (!reader.HasRotation(name) && !reader.HasPosition(name))
      throw InputError(table.file, 1,
                       "has no columns " + in_file + "_qw.._qz or " + in_file +
                           "_px.._pz; reference.columns names them for " + name);
}

std::map<Segment, Eigen::Quaterniond> ParseClusters(const JsonNode& node, Reference::Frames frames,
                                                    Findings* findings) {
  if (frames != Reference::Frames::kCluster)
    node.Fail("is told beside the frames 'segment'; expected the frames 'cluster'");
  std::map<Segment, Eigen::Quaterniond> q_BC;
  for (const auto& [name, cluster] : node.Members()) {
    const auto segment = SegmentFromName(name);
    if (!segment) cluster.Fail("is no segment");
    cluster.WarnOfUnknownKeys(kClusterKeys, &findings->warnings);
    q_BC[*segment] = ParseRotation(cluster.At("q_BC_wxyz"));
  }
  return q_BC;
}

// From clusters to segments, where every segment's cluster is known.
void AlignClusters(const ReferenceEntry& entry, Reference& reference, Findings* findings) {
  for (const auto& [segment, q_VC] : reference.q_VB)
    if (!entry.q_BC.contains(segment)) {
      findings->warnings.push_back("reference.clusters lacks " + std::string(Name(segment)) +
                                   ": the clusters of all segments stay unaligned");
      return;
    }
  for (auto& [segment, q_VB] : reference.q_VB)
    for (Eigen::Quaterniond& q : q_VB) q = q * entry.q_BC.at(segment).conjugate();
  reference.frames = Reference::Frames::kSegment;
}

bool IsQuantity(std::string_view column) {
  constexpr std::array<std::string_view, 7> kEndings = {"_qw", "_qx", "_qy", "_qz",
                                                        "_px", "_py", "_pz"};
  return column == "time_s" || std::ranges::any_of(kEndings, [column](std::string_view ending) {
           return column.ends_with(ending);
         });
}

ColumnFilter WantedColumns(const ReferenceEntry& entry) {
  std::set<std::string, std::less<>> stems(kJoints.begin(), kJoints.end());
  for (const Segment segment : kSegments) stems.emplace(Name(segment));
  for (const auto& [name, in_file] : entry.columns) stems.insert(in_file);
  return [stems](std::string_view column) {
    if (!IsQuantity(column)) return false;
    return column == "time_s" || stems.contains(column.substr(0, column.size() - 3));
  };
}

}  // namespace

ReferenceEntry ParseReferenceEntry(const JsonNode& node, Findings* findings) {
  node.WarnOfUnknownKeys(kReferenceKeys, &findings->warnings);
  ReferenceEntry entry;
  entry.file = node.At("file").Text();
  if (const auto frames = node.Find("frames"))
    entry.frames = OneOf(*frames, "segment", "cluster") == "cluster" ? Reference::Frames::kCluster
                                                                     : Reference::Frames::kSegment;
  else
    NoteDefault(node, "frames", "segment", findings);
  if (const auto columns = node.Find("columns"))
    for (const auto& [name, in_file] : columns->Members()) {
      if (!IsKnownName(name))
        in_file.Fail("is neither a segment nor a joint; expected a segment's name, or one of " +
                     Listed(kJoints));
      entry.columns[name] = in_file.Text();
    }
  if (const auto up = node.Find("up")) entry.up_is_y = OneOf(*up, "z", "y") == "y";
  if (const auto clusters = node.Find("clusters"))
    entry.q_BC = ParseClusters(*clusters, entry.frames, findings);
  if (const auto offset = node.Find("clock_offset_s")) entry.clock_offset = offset->Number();
  return entry;
}

ReferenceFile ParseReference(std::string_view text, const std::string& file,
                             const ReferenceEntry& entry, const std::set<Segment>& recorded,
                             Findings* findings) {
  const CsvTable table = ParseMotion(text, file, WantedColumns(entry));
  const ReferenceReader reader(table, entry);
  CheckMappedNames(reader, entry, table);
  ReferenceFile result;
  Reference& reference = result.reference;
  reference.time = reader.Times();
  reference.frames = entry.frames;
  reference.clock_offset = entry.clock_offset;
  for (const Segment segment : kSegments)
    if (const std::string name(Name(segment)); reader.HasRotation(name))
      reference.q_VB[segment] = reader.Rotations(name);
  for (const std::string& name : PointNames(recorded))
    if (reader.HasPosition(name)) reference.p_V[name] = reader.Positions(name);
  if (reference.q_VB.empty() && reference.p_V.empty())
    throw InputError(file, 1,
                     "has no column of a known segment or joint; expected NAME_qw.._qz or "
                     "NAME_px.._pz, or reference.columns to say which name is which");
  if (!entry.q_BC.empty()) AlignClusters(entry, reference, findings);
  WarnOfMillimetres(reference, entry.file, findings);
  const Steps steps = MeasureSteps(reference.time);
  CheckStepUnit(steps, file);
  ReportRows(table, reader.Usable(), steps, entry.file, findings);
  result.facts = {.file = entry.file,
                  .samples = reference.time.size(),
                  .rate_hz = 1.0 / steps.median,
                  .start_s = reference.time.front(),
                  .duration_s = reference.time.back() - reference.time.front(),
                  .gaps = steps.gaps};
  return result;
}

}  // namespace brachium
