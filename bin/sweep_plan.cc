// brachium sweep plan: which tasks a sweep has.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <thread>

#include "bin/commands.h"
#include "bin/help.h"
#include "bin/judge.h"
#include "bin/lists.h"
#include "bin/method_flags.h"
#include "bin/run_facts.h"
#include "bin/sweep_grid.h"
#include "bin/sweep_task.h"
#include "bin/sweep_text.h"
#include "bin/termination.h"
#include "io/streamed_file.h"
#include "io/text.h"

namespace brachium {
namespace {

namespace fs = std::filesystem;

struct PlanFlags {
  std::string trials;
  std::string method = "smoother";
  std::string vary;
  std::string output;

  template <typename Flags, typename Visitor>
  static void Visit(Flags& flags, Visitor&& visit) {
    visit("trials", flags.trials,
          "The trial folders, each with a reference: a list with commas, or a pattern in quotes "
          "such as 'trials/rig_*'.");
    visit("method", flags.method,
          "The methods: a list with commas, or a pattern in quotes such as 'luinge*'; each brings "
          "flags of its own, which go to all that have them.");
    visit("vary", flags.vary,
          "What is varied: NAME=VALUES, parted by semicolons; values are a list with commas or "
          "from:to:count:spacing, spacing lin or log. Each method takes every combination of those "
          "that it has.");
    visit("output", flags.output, "The folder for manifest.jsonl and, beside it, the results.");
  }
};

const CommandHelp kHelp = {
    "--trials=LIST --output=DIR [--method=A,B] [--vary='NAME=1:30:15:log;NAME=1,2'] [flags]",
    "Writes OUTPUT/manifest.jsonl, a task a line: trial, method, all its options, checksums of the "
    "inputs. A manifest is never changed: the same plan again is fine, another one is refused. "
    "Says how many tasks there are and, from one solve by each method, how long they will take. "
    "Standard deviations enter no figure of a sweep, so --covariance is off here."};

struct PlannedTrial {
  NamedFolder place;
  std::string inputs;
  double duration = 0.0;  // [s]
};

struct PlannedMethod {
  std::string name;
  std::vector<SweepPoint> points;
  double pace = 0.0;  // seconds for a second of trial
};

double DurationOf(const Observations& observations) {
  const auto& time = observations.recordings.front().time;
  return time.back() - time.front();
}

nlohmann::ordered_json VariedJson(const SweepPoint& point) {
  auto json = nlohmann::ordered_json::object();
  for (const auto& [name, value] : point.varied)
    std::visit([&json, &key = name](const auto& number) { json[key] = number; }, value);
  return json;
}

// Solves the first trial at the first point of each method.
void MeasurePace(const TrialFolder& folder, double duration, std::vector<PlannedMethod>* methods) {
  for (PlannedMethod& method : *methods) {
    const Stopwatch watch;
    RunSweepTask(method.points.front().options, folder);
    method.pace = watch.Seconds() / std::max(duration, 1e-3);
  }
}

std::vector<PlannedTrial> ReadTrials(const std::string& list, std::vector<PlannedMethod>* methods) {
  std::vector<PlannedTrial> trials;
  for (NamedFolder& place : TrialFolders(list)) {
    place.path = fs::weakly_canonical(fs::absolute(place.path)).string();
    const TrialFolder folder = ReadTrial(place.path);
    RequireReference(folder, place.path);
    const double duration = DurationOf(folder.trial.observations);
    if (trials.empty()) MeasurePace(folder, duration, methods);
    trials.push_back({place, InputsHash(folder.inputs), duration});
  }
  return trials;
}

std::size_t WriteTasks(const std::string& file, const std::vector<PlannedTrial>& trials,
                       const std::vector<PlannedMethod>& methods) {
  StreamedFile manifest(file);
  SweepTask task{.versions = VersionsJson(Versions())};
  for (const PlannedTrial& trial : trials) {
    task.trial = trial.place.name;
    task.path = trial.place.path;
    task.inputs = trial.inputs;
    task.duration = trial.duration;
    for (const PlannedMethod& method : methods) {
      task.method = method.name;
      for (const SweepPoint& point : method.points) {
        task.options = ToJson(point.options);
        task.varied = VariedJson(point);
        task.key = KeyOf(task);
        manifest.Append(ManifestLine(task));
        ++task.index;
      }
    }
  }
  const WithoutInterruption writing;
  manifest.Commit(false, "says otherwise, and a plan is never changed; choose another folder");
  return task.index;
}

double SecondsOfWork(const std::vector<PlannedTrial>& trials,
                     const std::vector<PlannedMethod>& methods) {
  double pace = 0.0, duration = 0.0;
  for (const PlannedMethod& method : methods)
    pace += method.pace * static_cast<double>(method.points.size());
  for (const PlannedTrial& trial : trials) duration += trial.duration;
  return pace * duration;
}

}  // namespace

int RunSweepPlan(CommandLine& line) {
  PlanFlags flags;
  const std::vector<std::string> names = MethodsFrom("method", line.Peek("method", flags.method));
  MethodFlags method_flags("method", names);
  method_flags.Preset("covariance", false);  // enters no figure of a sweep
  line.Add("Flags", flags);
  line.Add("Flags of the methods", method_flags);
  if (ShowHelp(line, kHelp, {MethodList()})) return kGood;
  line.Read();
  RequireGiven(flags.trials, "trials");
  RequireGiven(flags.method, "method");
  RequireGiven(flags.output, "output");
  method_flags.Share();
  const auto varied = ParseVary(flags.vary, method_flags.options());
  std::vector<PlannedMethod> methods;
  for (std::size_t m = 0; m < names.size(); ++m)
    methods.push_back({names[m], PointsOf(method_flags.options()[m], varied)});
  const auto trials = ReadTrials(flags.trials, &methods);
  const std::string file = (fs::path(flags.output) / "manifest.jsonl").string();
  const std::size_t tasks = WriteTasks(file, trials, methods);
  const double seconds = SecondsOfWork(trials, methods);
  const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
  std::cout << tasks << " tasks in " << file << ": about " << DurationText(seconds) << " of work, "
            << DurationText(seconds / cores) << " on the " << cores << " cores of this machine\n";
  return kGood;
}

}  // namespace brachium
