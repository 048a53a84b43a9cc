// brachium compare: several methods on the same trials, side by side.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <mutex>
#include <string>
#include <vector>

#include "bin/commands.h"
#include "bin/compare_pair.h"
#include "bin/comparison_text.h"
#include "bin/help.h"
#include "bin/in_parallel.h"
#include "bin/lists.h"
#include "bin/method_flags.h"
#include "bin/progress_line.h"
#include "bin/run_facts.h"
#include "bin/termination.h"
#include "io/comparison_folder.h"

namespace brachium {
namespace {

using Outcome = ComparedPair::Outcome;

struct CompareFlags {
  std::string trial;
  std::string methods;
  std::string output;
  int threads = 0;
  bool overwrite = false;

  bool IsValid(std::string* why) const {
    if (threads < 0) return *why = "threads must not be negative", false;
    return true;
  }

  template <typename Flags, typename Visitor>
  static void Visit(Flags& flags, Visitor&& visit) {
    visit("trial", flags.trial,
          "The trial folders, each with a reference: a list with commas, or a pattern in quotes "
          "such as 'trials/rig_*'.");
    visit("methods", flags.methods,
          "The methods: a list with commas, or a pattern in quotes such as 'luinge*'; each brings "
          "flags of its own, which go to all that have them.");
    visit("output", flags.output, "The folder to be written.");
    visit("threads", flags.threads,
          "How many estimates are made at a time, one thread each; 0: as many as the machine has. "
          "The result does not depend on it.");
    visit("overwrite", flags.overwrite,
          "Replace an older comparison. Estimates that would come out the same are kept.");
  }
};

const CommandHelp kHelp = {
    "--trial=DIR[,DIR...] --methods=A[,B...] --output=DIR [flags]",
    "Runs each method on each trial, compares the estimates with the references and puts them side "
    "by side: prints a table, writes comparison.csv, comparison.json, comparison.md and figures, "
    "and keeps the estimates in estimates/TRIAL/METHOD. What was interrupted goes on where it "
    "ended: an estimate by the same method, options and version from the same input is not made "
    "again. A method that cannot use a trial is shown as -. Exits with 2 when a trial cannot be "
    "read or has no reference, with 3 when a method failed or its result is not to be trusted; "
    "all others are there nevertheless."};

std::vector<PairTask> TasksFor(const std::vector<NamedFolder>& trials,
                               const std::vector<std::string>& methods,
                               const MethodFlags& method_flags, const CompareFlags& flags,
                               const std::string& command_line) {
  const std::filesystem::path estimates = std::filesystem::path(flags.output) / "estimates";
  std::vector<PairTask> tasks;
  for (const NamedFolder& trial : trials)
    for (std::size_t m = 0; m < methods.size(); ++m)
      tasks.push_back({.trial = trial,
                       .method = methods[m],
                       .options = method_flags.options()[m],
                       .estimate = (estimates / trial.name / methods[m]).string(),
                       .overwrite = flags.overwrite,
                       .command_line = command_line});
  return tasks;
}

std::vector<ComparedPair> RunAll(const std::vector<PairTask>& tasks, int threads) {
  std::vector<ComparedPair> pairs(tasks.size());
  ProgressLine line;
  const Progress progress = line.callback();
  std::mutex mutex;
  std::size_t done = 0;
  InParallel(tasks.size(), threads, [&](std::size_t i) {
    pairs[i] = RunPair(tasks[i]);
    const std::lock_guard lock(mutex);
    ++done;
    if (progress)
      progress(std::to_string(done) + " of " + std::to_string(tasks.size()) + ": " +
                   tasks[i].method + " on " + tasks[i].trial.name,
               static_cast<double>(done) / static_cast<double>(tasks.size()));
  });
  return pairs;
}

ComparisonInfo InfoOf(const Comparison& comparison, const MethodFlags& methods,
                      const CommandLine& line, std::vector<NameValue> flags) {
  ComparisonInfo info{.options = nlohmann::ordered_json::object(),
                      .flags = std::move(flags),
                      .versions = Versions(),
                      .markdown = ComparisonMarkdown(comparison),
                      .host = HostName(),
                      .command_line = line.text()};
  for (std::size_t m = 0; m < comparison.methods.size(); ++m)
    info.options[comparison.methods[m]] = ToJson(methods.options()[m]);
  return info;
}

int Verdict(const Comparison& comparison) {
  const auto any = [&](auto is) {
    return std::any_of(comparison.pairs.begin(), comparison.pairs.end(), is);
  };
  if (any([](const ComparedPair& pair) { return pair.outcome == Outcome::kUnreadable; }))
    return kWrongInput;
  const bool doubtful = any(
      [](const ComparedPair& pair) { return pair.outcome == Outcome::kFailed || !pair.trusted; });
  return doubtful ? kNotToBeTrusted : kGood;
}

}  // namespace

int RunCompare(CommandLine& line) {
  CompareFlags flags;
  const std::string chosen = line.Peek("methods", "");
  const std::vector<std::string> methods = MethodsFrom("methods", chosen.empty() ? "*" : chosen);
  MethodFlags method_flags("methods", methods);
  line.Add("Flags", flags);
  line.Add("Flags of the methods", method_flags);
  if (ShowHelp(line, kHelp)) return kGood;
  line.Read();
  RequireGiven(flags.trial, "trial");
  RequireGiven(flags.methods, "methods");
  RequireGiven(flags.output, "output");
  RequireValid(flags);
  method_flags.Share();
  const std::vector<NamedFolder> trials = TrialFolders(flags.trial);
  const std::vector<NameValue> run_flags = line.RunFlags({"output", "overwrite", "threads"});
  CheckComparable(flags.output, run_flags, flags.overwrite);

  Comparison comparison{.trials = {}, .methods = methods, .pairs = {}};
  for (const NamedFolder& trial : trials) comparison.trials.push_back(trial.name);
  comparison.pairs =
      RunAll(TasksFor(trials, methods, method_flags, flags, line.text()), flags.threads);
  {
    const WithoutInterruption writing;
    WriteComparison(flags.output, comparison, InfoOf(comparison, method_flags, line, run_flags),
                    flags.overwrite);
  }
  std::cout << ComparisonText(comparison) << "Comparison in " << flags.output << "\n";
  return Verdict(comparison);
}

}  // namespace brachium
