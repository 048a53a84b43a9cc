#include "io/trial_folder.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>
#include <string_view>

#include "io/arm_json.h"
#include "io/contacts_json.h"
#include "io/file_bytes.h"
#include "io/file_parts.h"
#include "io/formats/read_export.h"
#include "io/input_error.h"
#include "io/json_input.h"
#include "io/mounting_json.h"
#include "io/protocol_json.h"
#include "io/streamed_recording.h"
#include "io/text.h"
#include "io/trial_checks.h"

namespace brachium {
namespace {

namespace fs = std::filesystem;

constexpr double kVersion = 1;
constexpr std::array<std::string_view, 13> kTrialKeys = {
    "brachium_trial", "name",     "arm",         "recordings", "intervals",
    "start_pose",     "end_pose", "contacts",    "reference",  "simulated",
    "calibration",    "imported", "gravity_m_s2"};
constexpr std::array<std::string_view, 7> kRecordingKeys = {
    "segment", "file", "format", "mounting", "noise", "rate_hz", "sensor"};

// One entry of `recordings`, before its file is read.
struct Entry {
  JsonNode node;
  Segment segment;
};

std::string FolderName(const std::string& folder) {
  fs::path path = fs::absolute(folder).lexically_normal();
  if (!path.has_filename()) path = path.parent_path();
  return path.filename().string();
}

std::vector<Entry> ParseEntries(const JsonNode& recordings, Findings* findings) {
  std::vector<Entry> entries;
  for (const JsonNode& node : recordings.Elements()) {
    node.WarnOfUnknownKeys(kRecordingKeys, &findings->warnings);
    const Segment segment = ParseSegment(node.At("segment"));
    for (const Entry& other : entries)
      if (other.segment == segment)
        node.At("segment").Fail("is '" + std::string(Name(segment)) + "' as in " +
                                other.node.path() + "; expected each segment once");
    entries.push_back({node, segment});
  }
  if (entries.empty()) recordings.Fail("is empty; expected one recording or more");
  return entries;
}

std::set<Segment> SegmentsOf(const std::vector<Entry>& entries) {
  std::set<Segment> segments;
  for (const Entry& entry : entries) segments.insert(entry.segment);
  return segments;
}

void CheckChain(const JsonNode& recordings, const std::set<Segment>& recorded) {
  if (recorded.contains(Segment::kHand) && recorded.contains(Segment::kUpperArm) &&
      !recorded.contains(Segment::kForearm))
    recordings.Fail(
        "has hand and upper_arm without the forearm between them; expected a forearm recording, or "
        "one of the two alone");
}

class Reader {
 public:
  Reader(const std::string& folder, TrialParts parts)
      : folder_(folder), parts_(parts), root_(ParseRoot()), entries_(), recorded_() {}

  // Leaves samples in their files and hands them out through these.
  void StreamInto(std::vector<std::unique_ptr<SampleSource>>* samples) { samples_ = samples; }

  TrialFolder Read() {
    CheckVersion();
    root_.WarnOfUnknownKeys(kTrialKeys, &result_.warnings);
    if (const auto simulated = root_.Find("simulated")) result_.simulated = simulated->Truth();
    const auto name = root_.Find("name");
    result_.trial.name = name ? name->Text() : FolderName(folder_);
    entries_ = ParseEntries(root_.At("recordings"), &result_);
    recorded_ = SegmentsOf(entries_);
    CheckChain(root_.At("recordings"), recorded_);
    Observations& observations = result_.trial.observations;
    observations.gravity = ParseGravity(root_, &result_);
    observations.arm = ParseArm(root_.At("arm"), recorded_, &result_);
    for (const Entry& entry : entries_) ReadRecording(entry);
    const Interval common = CommonTime();
    observations.intervals = ParseIntervals(root_, common, &result_);
    observations.start_pose = ParseStartPose(root_, common, &result_);
    observations.end_pose = ParseEndPose(root_, common, &result_);
    observations.contacts = ParseContacts(root_, recorded_, common, &result_);
    if (const auto reference = root_.Find("reference")) ReadReference(*reference, common);
    CheckTrial(observations, &result_);
    return std::move(result_);
  }

 private:
  JsonNode ParseRoot() {
    const std::string file = InFolder("trial.json");
    const FileBytes bytes(file);
    result_.inputs.push_back({"trial.json", Sha256(bytes.text())});
    return JsonNode::Parse(bytes.text(), file);
  }

  std::string InFolder(const std::string& file) const {
    return (fs::path(folder_) / file).string();
  }

  void CheckVersion() const {
    const JsonNode version = root_.At("brachium_trial");
    if (version.Number() != kVersion)
      version.Fail("is " + Shortest(version.Number()) + "; expected version " + Shortest(kVersion));
  }

  std::string FileOf(const JsonNode& node) const {
    const JsonNode file = node.At("file");
    if (!fs::is_regular_file(InFolder(file.Text())))
      file.Fail("names '" + file.Text() + "', which is not a file in the trial folder");
    return file.Text();
  }

  // The export format of a recording; none: the program's own csv.
  const ExportFormat* FormatOf(const JsonNode& node) const {
    const auto format = node.Find("format");
    if (!format || format->Text() == "csv") return nullptr;
    if (const ExportFormat* const found = FindExportFormat(format->Text())) return found;
    std::vector<std::string_view> names = {"csv"};
    for (const ExportFormat& known : ExportFormats()) names.push_back(known.name);
    format->Fail("is '" + format->Text() + "'; expected one of " + Listed(names));
  }

  RecordingFile ParseFile(const Entry& entry, const ExportFile& file) {
    const ExportFormat* const format = FormatOf(entry.node);
    if (format == nullptr)
      return ParseRecording(file.text, file.path, file.name, entry.segment, &result_);
    const auto rate = entry.node.Find("rate_hz");
    clock_.rate_hz = rate ? std::optional(rate->Number()) : std::nullopt;
    const auto sensor = entry.node.Find("sensor");
    return ReadExport(*format, file, sensor ? sensor->Text() : "", entry.segment, &clock_,
                      &result_);
  }

  std::optional<Mounting> MountingOf(const Entry& entry) {
    const SegmentGeometry& geometry = result_.trial.observations.arm.segments.at(entry.segment);
    if (const auto mounting = entry.node.Find("mounting"))
      return ParseMounting(*mounting, geometry, &result_);
    if (entries_.size() > 1) return std::nullopt;
    result_.defaults.push_back(entry.node.path() +
                               ".mounting = identity (the segment's axes are the sensor's)");
    return Mounting{};
  }

  void ReadRecording(const Entry& entry) {
    const std::string name = FileOf(entry.node);
    const bool is_streamed = samples_ != nullptr && FormatOf(entry.node) == nullptr;
    RecordingFile read = is_streamed ? Survey(entry, name) : ReadWhole(entry, name);
    read.recording.noise = ParseNoise(entry.node, &result_);
    read.recording.mounting = MountingOf(entry);
    result_.trial.observations.recordings.push_back(std::move(read.recording));
    result_.recordings.push_back(std::move(read.facts));
  }

  RecordingFile ReadWhole(const Entry& entry, const std::string& name) {
    const std::string file = InFolder(name);
    const FileBytes bytes(file);
    result_.inputs.push_back({name, Sha256(bytes.text())});
    RecordingFile read = ParseFile(entry, {.path = file, .name = name, .text = bytes.text()});
    Covers(read.recording.time.front(), read.recording.time.back());
    if (samples_ != nullptr)
      samples_->push_back(
          std::make_unique<HeldSamples>(std::make_shared<const Recording>(read.recording)));
    return read;
  }

  // Of the samples, the head alone.
  RecordingFile Survey(const Entry& entry, const std::string& name) {
    RecordingSurvey survey = SurveyRecording(InFolder(name), name, entry.segment, &result_);
    result_.inputs.push_back({name, survey.sha256});
    Covers(survey.first, survey.last);
    samples_->push_back(std::make_unique<StreamedRecording>(InFolder(name), survey));
    return {std::move(survey.head), std::move(survey.facts)};
  }

  void Covers(double first, double last) {
    common_.start = std::max(common_.start, first);
    common_.end = std::min(common_.end, last);
  }

  // The time that all recordings cover.
  Interval CommonTime() const {
    if (!(common_.start < common_.end)) FailCommonTime();
    return common_;
  }

  [[noreturn]] void FailCommonTime() const {
    std::string spans;
    for (const RecordingFacts& facts : result_.recordings)
      spans += (spans.empty() ? "" : ", ") + facts.file + " from " + Shortest(facts.start_s) +
               " to " + Shortest(facts.start_s + facts.duration_s) + " s";
    root_.At("recordings").Fail("have no common time (" + spans + "); expected one clock");
  }

  void ReadReference(const JsonNode& node, const Interval& common) {
    const ReferenceEntry entry = ParseReferenceEntry(node, &result_);
    const std::string file = InFolder(FileOf(node));
    if (parts_ == TrialParts::kRecordings) {
      Sha256Sum sum;
      FileParts(file).ForEach([&](std::string_view part) { sum.Add(part); });
      result_.inputs.push_back({entry.file, sum.Text()});
      return;
    }
    const FileBytes bytes(file);
    result_.inputs.push_back({entry.file, Sha256(bytes.text())});
    ReferenceFile read = ParseReference(bytes.text(), file, entry, recorded_, &result_);
    const double offset = entry.clock_offset.value_or(0.0);
    const std::vector<double>& time = read.reference.time;
    if (entry.clock_offset &&
        (time.back() < common.start + offset || time.front() > common.end + offset))
      result_.warnings.push_back(entry.file + ": does not overlap the recordings in time");
    result_.trial.reference = std::move(read.reference);
    result_.reference = std::move(read.facts);
  }

  const std::string folder_;
  const TrialParts parts_;
  TrialFolder result_;
  const JsonNode root_;
  std::vector<Entry> entries_;
  std::set<Segment> recorded_;
  ExportClock clock_;
  Interval common_{.label = "", .start = -HUGE_VAL, .end = HUGE_VAL};
  std::vector<std::unique_ptr<SampleSource>>* samples_ = nullptr;  // null: all is held
};

void RequireFolder(const std::string& folder) {
  if (!fs::is_directory(folder))
    throw InputError(folder, 0, "is not a folder; expected a trial folder with a trial.json");
}

}  // namespace

TrialFolder ReadTrial(const std::string& folder, TrialParts parts) {
  RequireFolder(folder);
  return Reader(folder, parts).Read();
}

StreamedTrial OpenTrial(const std::string& folder) {
  RequireFolder(folder);
  StreamedTrial trial;
  Reader reader(folder, TrialParts::kRecordings);
  reader.StreamInto(&trial.samples);
  static_cast<TrialFolder&>(trial) = reader.Read();
  trial.trial.observations = WithoutSamples(std::move(trial.trial.observations));
  return trial;
}

}  // namespace brachium
