// Whether stated standard deviations can be believed: many simulated trials, whose errors are drawn
// as the estimator is told, and the errors of the estimates over the sds that they state.
//
//   uncertainty_campaign [--seeds=100] [--seconds=60] [--cases=stated,noise_x3] [--threads=0] ...
//
// Errors hardly change within a trial: three instants of each are looked at, and it is the number of
// trials that decides how sure the figures are. The same flags give the same table.
#include <gflags/gflags.h>

#include <cstdio>
#include <functional>
#include <sstream>
#include <stdexcept>

#include "bin/in_parallel.h"
#include "tests/support/normalised_errors.h"

DEFINE_string(cases, "stated,noise_x3,noise_third,soft_tissue", "See Cases() below.");
DEFINE_string(scenarios, "daily_brisk,daily_slow", "Movements, pooled.");
DEFINE_int32(first_seed, 1, "Of the trials of each movement.");
DEFINE_int32(seeds, 100, "How many trials of each movement.");
DEFINE_double(seconds, 60.0, "Length of a trial that goes on for as long as it is asked to.");
DEFINE_bool(scale_sd_by_residuals, false, "As the smoother's option of that name.");
DEFINE_int32(threads, 0, "0: as many as the machine has.");

namespace brachium {
namespace {

using Change = std::function<void(UncertainCase&)>;

// What differs from errors drawn as stated. What is left out stays stated: its sds are then too
// large, and what hides behind them shows.
const std::map<std::string, Change>& Cases() {
  static const std::map<std::string, Change> cases = {
      {"stated", [](UncertainCase&) {}},
      {"noise_x3", [](UncertainCase& drawn) { drawn.told_noise = 3.0; }},
      {"noise_third", [](UncertainCase& drawn) { drawn.told_noise = 1.0 / 3.0; }},
      {"soft_tissue", [](UncertainCase& drawn) { drawn.errors.soft_tissue = TypicalSoftTissue(); }},
      {"mountings_held",
       [](UncertainCase& drawn) { drawn.smoother.model.estimate_mountings = false; }},
      {"mountings_exact", [](UncertainCase& drawn) { drawn.errors.mounting_error = 0.0; }},
      {"no_misalignment", [](UncertainCase& drawn) { drawn.errors.misalignment = 0.0; }},
      {"no_adduction", [](UncertainCase& drawn) { drawn.scenario.adduction_rms = 0.0; }},
      {"no_shoulder", [](UncertainCase& drawn) { drawn.scenario.shoulder_rms = 0.0; }},
  };
  return cases;
}

std::vector<std::string> Words(const std::string& list) {
  std::vector<std::string> words;
  std::istringstream text(list);
  for (std::string word; std::getline(text, word, ',');) words.push_back(word);
  return words;
}

// Empty where the arm cannot be brought to where the movement leads it.
NormalisedErrors ErrorsOf(const std::string& scenario, const Change& change, int seed) try {
  ScenarioOptions usual{.name = scenario};
  UncertainCase drawn =
      DrawnAsStated(scenario, static_cast<std::uint64_t>(seed),
                    scenario.starts_with("daily") ? FLAGS_seconds : UsualDuration(usual));
  drawn.smoother.scale_sd_by_residuals = FLAGS_scale_sd_by_residuals;
  change(drawn);
  return NormalisedErrorsOf(drawn, {0.3, 0.6, 0.9});
} catch (const std::domain_error&) {
  return {};
}

void PrintRow(const std::string& quantity, const std::vector<double>& errors) {
  double sum = 0.0, largest = 0.0;
  for (const double error : errors) {
    sum += error;
    largest = std::max(largest, std::abs(error));
  }
  std::printf("  %-22s %6zu %7.1f %% %6.2f %6.2f %8.2f\n", quantity.c_str(), errors.size(),
              100 * Covered(errors), RmsOf(errors), sum / static_cast<double>(errors.size()),
              largest);
}

void Judge(const std::string& name) {
  const Change& change = Cases().at(name);
  const std::vector<std::string> scenarios = Words(FLAGS_scenarios);
  const auto seeds = static_cast<std::size_t>(FLAGS_seeds);
  std::vector<NormalisedErrors> trials(scenarios.size() * seeds);
  InParallel(trials.size(), FLAGS_threads, [&](std::size_t i) {
    trials[i] =
        ErrorsOf(scenarios[i / seeds], change, FLAGS_first_seed + static_cast<int>(i % seeds));
  });
  NormalisedErrors errors;
  std::size_t empty = 0;
  for (const NormalisedErrors& trial : trials) {
    Append(trial, errors);
    empty += trial.empty() ? 1 : 0;
  }
  std::printf("%s: %s, %zu trials\n", name.c_str(), FLAGS_scenarios.c_str(), trials.size() - empty);
  std::printf("  %-22s %6s %9s %6s %6s %8s\n", "error over sd", "n", "in 95 %", "rms", "mean",
              "largest");
  for (const auto& [quantity, values] : errors) PrintRow(quantity, values);
  PrintRow("pooled", Pooled(errors));
  std::fflush(stdout);
}

}  // namespace
}  // namespace brachium

int main(int argc, char** argv) {
  gflags::ParseCommandLineFlags(&argc, &argv, true);
  for (const std::string& name : brachium::Words(FLAGS_cases)) brachium::Judge(name);
}
