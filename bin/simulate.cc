// brachium simulate: a trial folder whose truth is known.
#include "problems/simulation/simulate.h"

#include <iostream>
#include <stdexcept>
#include <string>

#include "bin/commands.h"
#include "bin/help.h"
#include "bin/options_json.h"
#include "bin/simulate_options.h"
#include "bin/termination.h"
#include "io/text.h"
#include "io/trial_folder.h"

namespace brachium {
namespace {

struct OutputFlags {
  std::string output;
  bool overwrite = false;

  template <typename Flags, typename Visitor>
  static void Visit(Flags& flags, Visitor&& visit) {
    visit("output", flags.output, "The trial folder to be written.");
    visit("overwrite", flags.overwrite, "Replace an older trial folder.");
  }
};

const CommandHelp kHelp = {
    "--scenario=NAME --output=DIR [flags]",
    "Writes a trial folder of sensors on an arm that moves in a known way. The truth stands in it "
    "as the reference, and truth.json holds all that was drawn. The folder says that it is "
    "simulated."};

HelpSection ScenarioList() {
  HelpSection list{"Scenarios", {}};
  for (const std::string& name : ScenarioNames())
    list.items.push_back({name, std::string(ScenarioHelp(name)) + "."});
  return list;
}

std::string TruthJson(const SimulatedTrial& simulated, const MovementFlags& movement,
                      const ErrorFlags& errors) {
  nlohmann::ordered_json truth;
  for (const auto& [name, value] : simulated.truth) {
    if (value.size() == 1)
      truth[name] = value[0];
    else
      truth[name] = value;
  }
  const nlohmann::ordered_json json = {{"simulated", true},
                                       {"scenario", ToJson(movement)},
                                       {"errors", ToJson(errors)},
                                       {"truth", truth}};
  return json.dump(2) + "\n";
}

// Notes how long the trial became. A hand cannot be brought everywhere, whatever the shoulder does.
SimulatedTrial SimulatedFrom(const ErrorFlags& errors, MovementFlags& movement) {
  try {
    const Scenario scenario = MakeScenario(ScenarioFrom(movement, errors.draw_errors));
    movement.duration_s = scenario.options.duration;
    return Simulate(scenario, ErrorsFrom(errors, movement.seed, scenario));
  } catch (const std::domain_error& unreachable) {
    throw UsageError(std::string(unreachable.what()) +
                     ": less of --shoulder_rms_m or --adduction_rms_deg was expected");
  }
}

}  // namespace

int RunSimulate(CommandLine& line) {
  OutputFlags place;
  MovementFlags movement;
  ErrorFlags errors;
  line.Add("Flags", place);
  line.Add("Movement", movement);
  line.Add("Errors of the sensors and of what trial.json states", errors);
  if (ShowHelp(line, kHelp, {ScenarioList()})) return kGood;
  line.Read();
  RequireGiven(movement.scenario, "scenario");
  RequireGiven(place.output, "output");

  const SimulatedTrial simulated = SimulatedFrom(errors, movement);
  {
    const WithoutInterruption writing;
    WriteTrial(place.output, simulated.trial,
               {.simulated = true, .truth_json = TruthJson(simulated, movement, errors)},
               place.overwrite);
  }
  std::cout << "Simulated trial " << simulated.trial.name << " (" << movement.side << " arm, "
            << Shortest(movement.duration_s) << " s) in " << place.output << "\n";
  return kGood;
}

}  // namespace brachium
