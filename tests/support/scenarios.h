// Scenarios as they are usually performed, and the angles of their poses.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "problems/joint_angles.h"
#include "problems/simulation/scenario.h"

namespace brachium {

inline Scenario MakeUsual(const std::string& name, Side side = Side::kRight, std::uint64_t seed = 4,
                          int patient_week = 0) {
  ScenarioOptions options{.name = name, .seed = seed, .side = side, .patient_week = patient_week};
  options.duration = UsualDuration(options);
  return MakeScenario(options);
}

// Calls check(scenario) for every scenario, of both sides and, where there is one, of a patient.
template <typename Check>
void ForAllScenarios(const Check& check) {
  for (const std::string& name : ScenarioNames())
    for (const Side side : {Side::kRight, Side::kLeft}) {
      SCOPED_TRACE(name + ", " + std::string(Name(side)));
      check(MakeUsual(name, side));
    }
  for (const char* name : {"nine_hole_peg_test", "range_of_motion"})
    for (const int week : {1, 6, 10}) {
      SCOPED_TRACE(name + std::string(", week ") + std::to_string(week));
      check(MakeUsual(name, Side::kLeft, 4, week));
    }
}

inline ElbowAngles Elbow(const Scenario& scenario, double t) {
  const ArmMotion arm = scenario.At(t);
  return ElbowAnglesFrom(arm.upper_arm.turning.q_AB.conjugate() * arm.forearm.turning.q_AB,
                         scenario.options.side);
}

inline WristAngles WristOf(const Scenario& scenario, double t) {
  const ArmMotion arm = scenario.At(t);
  return WristAnglesFrom(arm.forearm.turning.q_AB.conjugate() * arm.hand.turning.q_AB,
                         scenario.options.side);
}

}  // namespace brachium
