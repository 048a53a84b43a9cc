// The list of scenarios.
#include <algorithm>
#include <array>
#include <cmath>

#include "problems/simulation/choreography.h"
#include "problems/simulation/families.h"
#include "problems/simulation/patient.h"

namespace brachium {
namespace {

constexpr std::array kKinds = {
    ScenarioKind{.name = "daily_brisk",
                 .help = "whole-arm reaches to random poses, 0.5-1.2 s each, running into one "
                         "another, with a pause after every fifth",
                 .compose = Daily,
                 .shape = StepShape::kSmooth,
                 .joints_apart = true},
    ScenarioKind{.name = "daily_slow",
                 .help = "the same path four times slower",
                 .compose = Daily,
                 .time_scale = 4.0,
                 .shape = StepShape::kSmooth,
                 .joints_apart = true},
    ScenarioKind{.name = "reach",
                 .help = "the elbow flexes to 100 deg, the arm reaches forward, and both come back",
                 .compose = Reach,
                 .shoulder_share = 0.5,
                 .shape = StepShape::kSmooth,
                 .joints_apart = true},
    ScenarioKind{
        .name = "shrug",
        .help = "the shoulder rises 8 cm and comes back, the arm hanging; pauses of 0.2-4 s",
        .compose = Shrug,
        .shoulder_share = 0.1,
        .shape = StepShape::kSmooth,
        .joints_apart = true},
    ScenarioKind{.name = "forearm_rotation",
                 .help = "pronation and supination between 30 and 150 deg, the elbow at 90 deg",
                 .compose = ForearmRotation,
                 .shoulder_share = 0.1,
                 .adduction_share = 0.5},
    ScenarioKind{.name = "eating",
                 .help = "pouring 10 s, soup 20 s, spaghetti 20 s, meat 30 s, drinking 10 s",
                 .compose = Eating,
                 .shoulder_share = 0.5,
                 .shortest = 91.5,
                 .usual = 91.5,
                 .joints_apart = true},
    ScenarioKind{.name = "morning",
                 .help = "washing the face 10 s, deodorant 10 s, buttoning 10 s, combing 20 s, "
                         "brushing teeth 30 s",
                 .compose = Morning,
                 .shoulder_share = 0.5,
                 .shortest = 81.5,
                 .usual = 81.5,
                 .joints_apart = true},
    ScenarioKind{.name = "circle",
                 .help = "the wrist draws a circle of radius 0.1 m on a desk, 4 s a lap, for 2 min",
                 .compose = Circle,
                 .shoulder_share = 0.2,
                 .shortest = 15.0,
                 .usual = 120.0,
                 .along_paths = true},
    ScenarioKind{.name = "rectangle",
                 .help = "the wrist draws a rectangle of 0.2 x 0.14 m on a desk, for 2 min",
                 .compose = Rectangle,
                 .shoulder_share = 0.2,
                 .shortest = 10.0,
                 .usual = 120.0,
                 .along_paths = true},
    ScenarioKind{.name = "goniometer_steps",
                 .help = "a hinge opens from 0 to 80 deg in steps of 10 deg, 3 s at each",
                 .compose = GoniometerSteps,
                 .shortest = 31.0,
                 .usual = 31.0,
                 .rig = true},
    ScenarioKind{.name = "goniometer_swing",
                 .help = "a hinge swings through 90 deg in the vertical plane, its end 10 cm away",
                 .compose = GoniometerSwing,
                 .shortest = 27.0,
                 .usual = 27.0,
                 .rig = true},
    ScenarioKind{.name = "nine_hole_peg_test",
                 .help = "nine pegs from a bowl into holes 1 to 9, with four sensors; see "
                         "--patient_week",
                 .compose = PegTest,
                 .shoulder_share = 0.1,
                 .shortest = 25.0,
                 .usual = 25.0,
                 .four_sensors = true,
                 .has_patient = true},
    ScenarioKind{.name = "range_of_motion",
                 .help = "seven degrees of freedom, each three times to both ends, with four "
                         "sensors; see --patient_week",
                 .compose = RangeOfMotion,
                 .shoulder_share = 0.2,
                 .shortest = 120.0,
                 .usual = 120.0,
                 .four_sensors = true,
                 .has_patient = true},
    ScenarioKind{.name = "calibration",
                 .help = "five times each, still in between: supination and pronation, endo- and "
                         "exorotation, abduction; labelled for brachium calibrate",
                 .compose = CalibrationMovements,
                 .shoulder_share = 0.2,
                 .adduction_share = 0.2,
                 .shortest = 55.0,
                 .shape = StepShape::kSmooth,
                 .joints_apart = true},
    ScenarioKind{.name = "shoulder_still",
                 .help = "twenty reaches with the shoulder kept still, labelled for zhou",
                 .compose = ShoulderStill,
                 .shoulder_share = 0.05,
                 .shortest = 72.0,
                 .usual = 72.0,
                 .joints_apart = true},
    ScenarioKind{.name = "static_pose",
                 .help = "a minute without movement, the arm hanging",
                 .compose = StaticPose,
                 .shortest = 1.0,
                 .usual = 60.0}};

}  // namespace

const ScenarioKind* FindScenario(std::string_view name) {
  const auto kind = std::find_if(kKinds.begin(), kKinds.end(),
                                 [name](const ScenarioKind& k) { return k.name == name; });
  return kind == kKinds.end() ? nullptr : &*kind;
}

std::vector<std::string> ScenarioNames() {
  std::vector<std::string> names;
  for (const ScenarioKind& kind : kKinds) names.emplace_back(kind.name);
  return names;
}

std::string_view ScenarioHelp(const std::string& name) { return FindScenario(name)->help; }

double TimeScale(const ScenarioOptions& options) {
  return options.time_scale * FindScenario(options.name)->time_scale *
         Slowness(options.patient_week);
}

double UsualDuration(const ScenarioOptions& options) {
  constexpr double kOpenEnded = 60.0;
  const double usual = FindScenario(options.name)->usual;
  const bool is_week = options.patient_week >= 0 && options.patient_week <= kPatientWeeks;
  return usual == 0.0 || !is_week
             ? kOpenEnded
             : std::ceil(kRestAtStart + kRestAtEnd + usual * TimeScale(options));
}

}  // namespace brachium
