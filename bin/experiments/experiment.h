// The experiments of the papers, on simulated trials whose truth is known. An experiment is a plan,
// fixed before any method runs, and a report of what came out beside what the paper printed.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "problems/comparison.h"
#include "problems/simulation/simulate.h"
#include "solver/estimators.h"

namespace brachium {

struct ExperimentTrial {
  std::string name;
  ScenarioOptions movement;
  SimulationOptions errors;
};

// A method on a trial, by the name under which it appears: one method may appear with several options.
struct ExperimentRun {
  std::string trial;
  std::string name;
  MethodOptions options;
};

struct ExperimentPlan {
  std::vector<ExperimentTrial> trials;
  std::vector<ExperimentRun> runs;
};

// What came out, by the names of the plan; absent names are the programmer's mistake and throw
// std::out_of_range.
class ExperimentResults {
 public:
  ExperimentResults(std::string folder, std::map<std::string, SimulatedTrial> trials,
                    std::vector<ComparedPair> pairs);

  const SimulatedTrial& TrialOf(const std::string& trial) const { return trials_.at(trial); }
  const ComparedPair& PairOf(const std::string& trial, const std::string& name) const;
  Estimate EstimateOf(const std::string& trial, const std::string& name) const;

  const std::vector<ComparedPair>& pairs() const { return pairs_; }

 private:
  std::string folder_;
  std::map<std::string, SimulatedTrial> trials_;
  std::vector<ComparedPair> pairs_;
  std::map<std::pair<std::string, std::string>, std::size_t> places_;
};

struct ExperimentReport {
  std::string text;
  std::map<std::string, std::string> figures;  // SVG documents by file name
};

struct Experiment {
  std::string name;
  std::string source;
  ExperimentPlan (*plan)(bool quick);  // quick: fewer and shorter runs, for a first look
  ExperimentReport (*report)(const ExperimentResults& results, bool quick);
};

// Throws UsageError for a name that is not known.
const Experiment& ExperimentFrom(const std::string& name);

// Where the folder of an experiment keeps a trial, and an estimate.
std::string TrialFolderIn(const std::string& folder, const std::string& trial);
std::string EstimateFolderIn(const std::string& folder, const std::string& trial,
                             const std::string& name);

}  // namespace brachium
