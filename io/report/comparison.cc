#include "io/report/comparison.h"

#include <algorithm>
#include <cctype>

namespace brachium {
namespace {

void AddOnce(const std::string& name, std::vector<std::string>* names) {
  if (std::find(names->begin(), names->end(), name) == names->end()) names->push_back(name);
}

ComparedPair PairOf(const std::vector<const ReportedEstimate*>& judged, const std::string& trial,
                    const std::string& method) {
  const auto found =
      std::find_if(judged.begin(), judged.end(), [&](const ReportedEstimate* reported) {
        return reported->run.trial == trial && reported->label == method;
      });
  if (found == judged.end())
    return {.trial = trial,
            .method = method,
            .outcome = ComparedPair::Outcome::kRefused,
            .reason = "not in this report"};
  const Diagnostics& diagnostics = (*found)->estimate.diagnostics;
  return {.trial = trial,
          .method = method,
          .trusted = diagnostics.converged && !diagnostics.singular,
          .evaluation = *(*found)->evaluation};
}

}  // namespace

SideBySide SideBySideOf(const std::vector<ReportedEstimate>& estimates) {
  SideBySide sides;
  std::vector<const ReportedEstimate*> judged;
  for (const ReportedEstimate& reported : estimates) {
    auto trial = std::find_if(sides.by_trial.begin(), sides.by_trial.end(),
                              [&](const auto& item) { return item.first == reported.run.trial; });
    if (trial == sides.by_trial.end())
      trial = sides.by_trial.insert(sides.by_trial.end(), {reported.run.trial, {}});
    trial->second.push_back(&reported);
    if (reported.evaluation) judged.push_back(&reported);
  }
  std::erase_if(sides.by_trial, [](const auto& item) { return item.second.size() < 2; });
  if (judged.size() < 2) return sides;
  Comparison& comparison = sides.comparison;
  for (const ReportedEstimate* reported : judged) {
    AddOnce(reported->run.trial, &comparison.trials);
    AddOnce(reported->label, &comparison.methods);
  }
  for (const std::string& trial : comparison.trials)
    for (const std::string& method : comparison.methods)
      comparison.pairs.push_back(PairOf(judged, trial, method));
  return sides;
}

std::string ComparisonCaption(const std::string& file) {
  if (file == "errors.svg")
    return "Errors by trial and method: boxes of the quartiles, whiskers to 5 and 95 %, a dot at "
           "the "
           "rmse.";
  return file.starts_with("position")
             ? "Distance of a point from its reference over time, after one heading and shift."
             : "Error of the orientation between segments over time.";
}

std::string SweepCaption(const std::string& file) {
  return file.starts_with("sweep_map") ? "The median error over two of the varied numbers."
                                       : "Adduction and error over the varied number: a thin line "
                                         "per trial, the median and the "
                                         "quartiles.";
}

std::string SafeFileName(const std::string& name) {
  std::string safe = name;
  for (char& letter : safe)
    if (std::isalnum(static_cast<unsigned char>(letter)) == 0 &&
        std::string("-_.()").find(letter) == std::string::npos)
      letter = '_';
  return safe;
}

}  // namespace brachium
