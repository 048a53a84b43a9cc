#include "io/report/read_report.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>
#include <utility>

#include "io/estimate_folder.h"
#include "io/file_bytes.h"
#include "io/input_error.h"
#include "io/trial_folder.h"

namespace brachium {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

bool Same(const std::vector<InputFile>& a, const std::vector<InputFile>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const InputFile& x, const InputFile& y) {
                      return x.path == y.path && x.sha256 == y.sha256;
                    });
}

// The trials at hand, each read once.
class Trials {
 public:
  explicit Trials(const std::vector<std::string>& told) : told_(told) {
    for (const std::string& path : told) Read(path);
  }

  // The trial that the estimate in `folder` was made from; none with the reason in `why`.
  const TrialFolder* Of(const RunInfo& run, const std::string& folder, std::string* why) {
    if (!told_.empty()) return AmongTold(run, folder);
    const auto flag = std::find_if(run.flags.begin(), run.flags.end(),
                                   [](const NameValue& f) { return f.first == "trial"; });
    if (flag == run.flags.end()) return *why = "The estimate names no trial folder.", nullptr;
    const std::string& path = flag->second;
    try {
      const TrialFolder* const trial = Read(path);
      if (Same(trial->inputs, run.inputs)) return trial;
      *why = "The trial folder " + path + " has changed since.";
    } catch (const InputError&) {
      *why = "The trial folder " + path + " is not there; --trial says where it is.";
    }
    return nullptr;
  }

 private:
  const TrialFolder* Read(const std::string& path) {
    auto& trial = read_[path];
    if (!trial) trial = std::make_unique<TrialFolder>(ReadTrial(path));
    return trial.get();
  }

  const TrialFolder* AmongTold(const RunInfo& run, const std::string& folder) {
    for (const std::string& path : told_)
      if (const TrialFolder* const trial = Read(path); Same(trial->inputs, run.inputs))
        return trial;
    throw InputError(folder, 0,
                     "was made from none of the trials told; expected the folder that it was made "
                     "from, unchanged");
  }

  std::vector<std::string> told_;
  std::map<std::string, std::unique_ptr<TrialFolder>> read_;
};

void AddReference(const TrialFolder& folder, ReportedEstimate* reported) {
  if (!folder.trial.reference) {
    reported->reference_note = "The trial has no reference.";
    return;
  }
  Evaluation evaluation = Evaluate(reported->estimate, *folder.trial.reference);
  if (evaluation.used == 0) {
    reported->reference_note = "The estimate and the trial's reference have nothing in common.";
    return;
  }
  reported->reference = folder.trial.reference;
  reported->reference_note = std::to_string(evaluation.used) + " of " +
                             std::to_string(evaluation.reference_samples) +
                             " instants of the trial's reference compared.";
  reported->evaluation = std::move(evaluation);
}

ReportedEstimate ReadOne(const std::string& folder, Trials* trials) {
  ReportedEstimate reported{.estimate = ReadEstimate(folder), .run = ReadRun(folder)};
  reported.label = reported.estimate.method;
  if (const TrialFolder* const trial = trials->Of(reported.run, folder, &reported.reference_note))
    AddReference(*trial, &reported);
  return reported;
}

std::string LastPart(const std::string& folder) {
  const fs::path path = fs::path(folder).lexically_normal();
  return (path.has_filename() ? path : path.parent_path()).filename().string();
}

ReportedFolder ReadFolder(const std::string& folder, const std::string& file,
                          ReportedFolder::Kind kind) {
  ReportedFolder reported{.kind = kind, .name = LastPart(folder)};
  reported.json = Json::parse(FileBytes(file).text(), nullptr, false);
  const char* const key =
      kind == ReportedFolder::Kind::kSweep ? "brachium_sweep" : "brachium_comparison";
  if (!reported.json.is_object() || !reported.json.contains(key) || reported.json[key] != 1)
    throw InputError(file, 0, std::string("is not \"") + key + "\": 1; expected version 1");
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".svg" && entry.is_regular_file())
      reported.pictures[entry.path().filename().string()] = FileBytes(entry.path().string()).text();
  return reported;
}

// Estimates of one trial that are called the same get numbers.
void TellApart(std::vector<ReportedEstimate>* estimates) {
  std::set<std::string> names;
  for (ReportedEstimate& reported : *estimates) {
    const std::string method = reported.label;
    const auto name = [&] { return reported.run.trial + ", " + reported.label; };
    for (int number = 2; names.contains(name()); ++number)
      reported.label = method + " (" + std::to_string(number) + ")";
    reported.name = name();
    names.insert(reported.name);
  }
}

}  // namespace

Report ReadReport(const std::vector<std::string>& folders, const std::vector<std::string>& trials) {
  Report report;
  Trials at_hand(trials);
  for (const std::string& folder : folders) {
    const auto file = [&](const char* name) { return (fs::path(folder) / name).string(); };
    if (fs::exists(file("summary.json")))
      report.estimates.push_back(ReadOne(folder, &at_hand));
    else if (fs::exists(file("comparison.json")))
      report.folders.push_back(
          ReadFolder(folder, file("comparison.json"), ReportedFolder::Kind::kComparison));
    else if (fs::exists(file("sweep.json")))
      report.folders.push_back(
          ReadFolder(folder, file("sweep.json"), ReportedFolder::Kind::kSweep));
    else
      throw InputError(folder, 0,
                       "is no result; expected the folder of an estimate (summary.json), of a "
                       "comparison (comparison.json) or of a merged sweep (sweep.json)");
  }
  TellApart(&report.estimates);
  return report;
}

}  // namespace brachium
