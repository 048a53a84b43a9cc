// All scenarios by name, and how a composition becomes motions.
#pragma once

#include <string>
#include <string_view>

#include "problems/simulation/movement.h"
#include "problems/simulation/scenario.h"

namespace brachium {

// One scenario: what it is called, and how it differs from the others.
struct ScenarioKind {
  std::string_view name;
  std::string_view help;
  Choreography (*compose)(const Task& task, Draws& draws);
  double time_scale = 1.0;
  double shoulder_share = 1.0;   // of the options' shoulder rms
  double adduction_share = 1.0;  // of the options' adduction rms
  double shortest = 10.0;        // time that it needs, before the time scale [s]
  double usual = 0.0;            // time that it usually takes; 0: 60 s, rests included [s]
  StepShape shape = StepShape::kMinimumJerk;
  bool joints_apart = false;  // each joint has an onset of its own
  bool along_paths = false;   // the hand moves in straight lines, or in circles
  bool four_sensors = false;  // girdle and hand are worn too
  bool rig = false;           // a goniometer
  bool has_patient = false;   // ScenarioOptions::patient_week counts
};

// The kind of that name; none: nullptr.
const ScenarioKind* FindScenario(std::string_view name);

// How many times slower than composed: the scenario's own slowness times the options', times a
// patient's.
double TimeScale(const ScenarioOptions& options);

// Fills the scenario's motions and what is known of them. Reads its options and its shape; both are
// those of a right arm. Requires options.IsValid().
void Perform(const ScenarioKind& kind, Scenario& scenario);

}  // namespace brachium
