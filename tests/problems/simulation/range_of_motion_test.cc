#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "problems/simulation/patient.h"
#include "tests/support/scenarios.h"

namespace brachium {
namespace {

TEST(RangeOfMotion, TestsSevenFreedomsThreeTimesEach) {
  const Scenario scenario = MakeUsual("range_of_motion");
  std::map<std::string, int> count;
  for (const Interval& interval : scenario.intervals) ++count[interval.label];
  for (const char* name :
       {"shoulder_flexion", "shoulder_abduction", "shoulder_rotation", "elbow_flexion",
        "forearm_pronation", "wrist_flexion", "wrist_deviation"}) {
    EXPECT_EQ(count[std::string("task:") + name], 1) << name;
    EXPECT_EQ(count[std::string("cycle:") + name], 3) << name;
  }
}

double AbductionReached(const Scenario& scenario) {
  double most = 0.0;
  for (const Interval& cycle : scenario.intervals)
    if (cycle.label == "cycle:shoulder_abduction")
      for (double t = cycle.start; t < cycle.end; t += 0.01)
        most = std::max(most, scenario.JointsAt(t)[kShoulderAbduction].value);
  return most;
}

TEST(RangeOfMotion, GrowsOverThePatientsWeeksButForTheSetback) {
  std::map<int, double> reached;
  for (int week = 1; week <= kPatientWeeks; ++week)
    reached[week] = AbductionReached(MakeUsual("range_of_motion", Side::kRight, 4, week));
  EXPECT_NEAR(reached[1], 60 * kDegree, 5 * kDegree);
  EXPECT_NEAR(reached[10], 120 * kDegree, 5 * kDegree);
  EXPECT_LT(reached[5], reached[4]);
  EXPECT_LT(reached[6], reached[4]);
  EXPECT_GT(reached[7], reached[4]);
  const double healthy = AbductionReached(MakeUsual("range_of_motion"));
  EXPECT_GT(healthy, 135 * kDegree);
  EXPECT_LT(healthy, 175 * kDegree);
}

}  // namespace
}  // namespace brachium
