#include "bin/experiments/run_experiment.h"

#include <algorithm>
#include <iostream>
#include <map>
#include <utility>

#include "bin/commands.h"
#include "bin/compare_pair.h"
#include "bin/in_parallel.h"
#include "bin/method_flags.h"
#include "bin/run_facts.h"
#include "bin/table.h"
#include "bin/termination.h"
#include "io/comparison_folder.h"

namespace brachium {
namespace {

std::string TruthJson(const SimulatedTrial& simulated) {
  nlohmann::ordered_json truth;
  for (const auto& [name, value] : simulated.truth) {
    if (value.size() == 1)
      truth[name] = value[0];
    else
      truth[name] = value;
  }
  return nlohmann::ordered_json{{"simulated", true}, {"truth", truth}}.dump(2) + "\n";
}

// A sensor alone is followed itself, not the end of its segment; soft tissue beneath it left out.
void FollowOnlySensor(SimulatedTrial& simulated) {
  if (simulated.trial.observations.recordings.size() != 1) return;
  const Segment segment = simulated.trial.observations.recordings.front().segment;
  Reference& reference = *simulated.trial.reference;
  const std::string name(Name(segment));
  const Eigen::Vector3d p_BS(simulated.True(name + ".p_BS_m").data());
  std::vector<Eigen::Vector3d> places = reference.p_V.at(std::string(ProximalJointName(segment)));
  for (std::size_t i = 0; i < places.size(); ++i) places[i] += reference.q_VB.at(segment)[i] * p_BS;
  reference.p_V = {{name, places}};
}

SimulatedTrial SimulateInto(const ExperimentTask& task, const ExperimentTrial& planned) {
  SimulatedTrial simulated = Simulate(MakeScenario(planned.movement), planned.errors);
  simulated.trial.name = planned.name;
  FollowOnlySensor(simulated);
  const WithoutInterruption writing;
  WriteTrial(TrialFolderIn(task.folder, planned.name), simulated.trial,
             {.simulated = true, .truth_json = TruthJson(simulated)}, task.overwrite);
  return simulated;
}

std::map<std::string, SimulatedTrial> SimulateAll(const ExperimentTask& task,
                                                  const ExperimentPlan& plan) {
  std::vector<SimulatedTrial> trials(plan.trials.size());
  InParallel(trials.size(), task.threads,
             [&](std::size_t i) { trials[i] = SimulateInto(task, plan.trials[i]); });
  std::map<std::string, SimulatedTrial> by_name;
  for (std::size_t i = 0; i < trials.size(); ++i)
    by_name[plan.trials[i].name] = std::move(trials[i]);
  return by_name;
}

std::string MethodOf(const MethodOptions& options) { return MethodNames()[options.index()]; }

std::vector<ComparedPair> EstimateAll(const ExperimentTask& task, const ExperimentPlan& plan) {
  std::vector<PairTask> tasks;
  for (const ExperimentRun& run : plan.runs)
    tasks.push_back({.trial = {run.trial, TrialFolderIn(task.folder, run.trial)},
                     .method = MethodOf(run.options),
                     .options = run.options,
                     .estimate = EstimateFolderIn(task.folder, run.trial, run.name),
                     .overwrite = task.overwrite,
                     .command_line = task.command_line});
  std::vector<ComparedPair> pairs = RunPairs(tasks, task.threads);
  for (std::size_t i = 0; i < pairs.size(); ++i) pairs[i].method = plan.runs[i].name;
  return pairs;
}

Comparison ComparisonOf(const ExperimentPlan& plan, const std::vector<ComparedPair>& pairs) {
  Comparison comparison{.trials = {}, .methods = {}, .pairs = pairs};
  for (const ExperimentTrial& trial : plan.trials) comparison.trials.push_back(trial.name);
  for (const ExperimentRun& run : plan.runs)
    if (std::find(comparison.methods.begin(), comparison.methods.end(), run.name) ==
        comparison.methods.end())
      comparison.methods.push_back(run.name);
  return comparison;
}

std::string DoubtsText(const std::vector<ComparedPair>& pairs) {
  std::vector<std::string> sentences;
  for (const ComparedPair& pair : pairs)
    if (!pair.reason.empty())
      sentences.push_back(pair.method + " on " + pair.trial + ": " + pair.reason);
  return Listing("\nWithout a result, or one that is not to be trusted", sentences);
}

ComparisonInfo InfoOf(const Experiment& experiment, const ExperimentPlan& plan,
                      const ExperimentTask& task, const ExperimentReport& report) {
  ComparisonInfo info{.options = nlohmann::ordered_json::object(),
                      .flags = task.flags,
                      .versions = Versions(),
                      .markdown = "# " + experiment.name + "\n\n```\n" + report.text + "```\n",
                      .host = HostName(),
                      .command_line = task.command_line};
  for (const ExperimentRun& run : plan.runs) info.options[run.name] = ToJson(run.options);
  return info;
}

}  // namespace

int RunExperiment(const Experiment& experiment, const ExperimentTask& task) {
  CheckComparable(task.folder, task.flags, task.overwrite);
  const ExperimentPlan plan = experiment.plan(task.quick);
  std::map<std::string, SimulatedTrial> trials = SimulateAll(task, plan);
  const ExperimentResults results(task.folder, std::move(trials), EstimateAll(task, plan));
  const bool complete = std::all_of(
      results.pairs().begin(), results.pairs().end(),
      [](const ComparedPair& pair) { return pair.outcome == ComparedPair::Outcome::kDone; });
  ExperimentReport report = complete ? experiment.report(results, task.quick) : ExperimentReport{};
  report.text += DoubtsText(results.pairs());
  {
    const WithoutInterruption writing;
    WriteComparison(task.folder, ComparisonOf(plan, results.pairs()),
                    InfoOf(experiment, plan, task, report), report.figures, task.overwrite);
  }
  std::cout << experiment.source << ", on simulated trials\n\n"
            << report.text << "\nTables and figures in " << task.folder << "\n";
  return complete ? kGood : kNotToBeTrusted;
}

}  // namespace brachium
