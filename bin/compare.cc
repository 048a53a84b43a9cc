// brachium compare: several methods on the same trials, side by side.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "bin/commands.h"
#include "bin/compare_pair.h"
#include "bin/comparison_text.h"
#include "bin/experiments/run_experiment.h"
#include "bin/help.h"
#include "bin/lists.h"
#include "bin/method_flags.h"
#include "bin/run_facts.h"
#include "bin/termination.h"
#include "io/comparison_figures.h"
#include "io/comparison_folder.h"

namespace brachium {
namespace {

using Outcome = ComparedPair::Outcome;

struct CompareFlags {
  std::string experiment;
  bool quick = false;
  std::string trial;
  std::string methods;
  std::string output;
  int threads = 0;
  bool overwrite = false;

  bool IsValid(std::string* why) const {
    if (quick && experiment.empty()) return *why = "--quick goes with --experiment only", false;
    if (threads < 0) return *why = "--threads must not be negative", false;
    return true;
  }

  template <typename Flags, typename Visitor>
  static void Visit(Flags& flags, Visitor&& visit) {
    visit("experiment", flags.experiment,
          "In place of trials and methods: luinge2007, zhou2008 or bai2015. Simulates that paper's "
          "movements, runs its methods and the smoother, and prints its tables beside the paper's "
          "values.");
    visit("quick", flags.quick, "Of an experiment: fewer and shorter runs, for a first look.");
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
    "{--trial=DIR[,DIR...] --methods=A[,B...] | --experiment=NAME} --output=DIR [flags]",
    "Runs each method on each trial, compares the estimates with the references and puts them side "
    "by side: prints a table, writes comparison.csv, comparison.json, comparison.md and figures, "
    "and keeps the estimates in estimates/TRIAL/METHOD. What was interrupted goes on where it "
    "ended: an estimate by the same method, options and version from the same input is not made "
    "again. A method that cannot use a trial is shown as -. Exits with 2 when a trial cannot be "
    "read or has no reference, with 3 when a method failed or its result is not to be trusted; "
    "all others are there nevertheless. An experiment's trials and estimates stay in trials/ and "
    "estimates/TRIAL/NAME; it exits with 3 when a method failed."};

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

int RunExperimentOf(const CompareFlags& flags, const CommandLine& line) {
  if (!flags.trial.empty() || !flags.methods.empty())
    throw UsageError(
        "--experiment brings its trials and methods: --trial and --methods do not go "
        "with it");
  RequireGiven(flags.output, "output");
  RequireValid(flags);
  return RunExperiment(ExperimentFrom(flags.experiment),
                       {.folder = flags.output,
                        .quick = flags.quick,
                        .threads = flags.threads,
                        .overwrite = flags.overwrite,
                        .command_line = line.text(),
                        .flags = line.RunFlags({"output", "overwrite", "threads"})});
}

// An experiment fixes the options of its methods: their flags are not known then.
std::vector<std::string> MethodsOf(const CommandLine& line) {
  if (!line.Peek("experiment", "").empty()) return {};
  const std::string chosen = line.Peek("methods", "");
  return MethodsFrom("methods", chosen.empty() ? "*" : chosen);
}

}  // namespace

int RunCompare(CommandLine& line) {
  CompareFlags flags;
  const std::vector<std::string> methods = MethodsOf(line);
  MethodFlags method_flags("methods", methods);
  line.Add("Flags", flags);
  line.Add("Flags of the methods", method_flags);
  if (ShowHelp(line, kHelp, {MethodList()})) return kGood;
  line.Read();
  if (!flags.experiment.empty()) return RunExperimentOf(flags, line);
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
      RunPairs(TasksFor(trials, methods, method_flags, flags, line.text()), flags.threads);
  {
    const WithoutInterruption writing;
    WriteComparison(flags.output, comparison, InfoOf(comparison, method_flags, line, run_flags),
                    ComparisonFigures(comparison), flags.overwrite);
  }
  std::cout << ComparisonText(comparison) << "Comparison in " << flags.output << "\n";
  return Verdict(comparison);
}

}  // namespace brachium
