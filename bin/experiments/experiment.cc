#include "bin/experiments/experiment.h"

#include <filesystem>
#include <string_view>
#include <utility>

#include "bin/experiments/experiments.h"
#include "bin/flags.h"
#include "io/estimate_folder.h"
#include "io/text.h"

namespace brachium {
namespace {

namespace fs = std::filesystem;

const std::vector<Experiment>& Experiments() {
  static const auto* const experiments = new std::vector<Experiment>{
      {.name = "luinge2007",
       .source = "Luinge, Veltink & Baten, J. Biomech. 40 (2007)",
       .plan = PlanLuinge2007,
       .report = ReportLuinge2007},
      {.name = "zhou2008",
       .source = "Zhou, Stone, Hu & Harris, Med. Eng. Phys. 30 (2008)",
       .plan = PlanZhou2008,
       .report = ReportZhou2008},
      {.name = "bai2015",
       .source = "Bai et al., IEEE TNSRE 23 (2015)",
       .plan = PlanBai2015,
       .report = ReportBai2015},
  };
  return *experiments;
}

}  // namespace

ExperimentResults::ExperimentResults(std::string folder,
                                     std::map<std::string, SimulatedTrial> trials,
                                     std::vector<ComparedPair> pairs)
    : folder_(std::move(folder)), trials_(std::move(trials)), pairs_(std::move(pairs)) {
  for (std::size_t i = 0; i < pairs_.size(); ++i) places_[{pairs_[i].trial, pairs_[i].method}] = i;
}

const ComparedPair& ExperimentResults::PairOf(const std::string& trial,
                                              const std::string& name) const {
  return pairs_[places_.at({trial, name})];
}

Estimate ExperimentResults::EstimateOf(const std::string& trial, const std::string& name) const {
  return ReadEstimate(EstimateFolderIn(folder_, trial, name));
}

const Experiment& ExperimentFrom(const std::string& name) {
  std::vector<std::string_view> known;
  for (const Experiment& experiment : Experiments()) {
    if (experiment.name == name) return experiment;
    known.push_back(experiment.name);
  }
  throw UsageError("--experiment=" + name + " is not known" + DidYouMean(name, known) +
                   " (known: " + Listed(known) + ")");
}

std::string TrialFolderIn(const std::string& folder, const std::string& trial) {
  return (fs::path(folder) / "trials" / trial).string();
}

std::string EstimateFolderIn(const std::string& folder, const std::string& trial,
                             const std::string& name) {
  return (fs::path(folder) / "estimates" / trial / name).string();
}

}  // namespace brachium
