#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/scenarios.h"

namespace brachium {
namespace {

using Seconds = std::vector<std::pair<std::string, double>>;

// Luinge et al. 2007, section 2.4.
const Seconds kEating = {
    {"pouring", 10}, {"soup", 20}, {"spaghetti", 20}, {"meat", 30}, {"drinking", 10}};
const Seconds kMorning = {
    {"face", 10}, {"deodorant", 10}, {"buttoning", 10}, {"combing", 20}, {"brushing_teeth", 30}};

TEST(Routine, HasThePapersActivitiesInOrderAndForAsLong) {
  for (const auto& [name, activities] : {std::pair{"eating", kEating}, {"morning", kMorning}}) {
    const Scenario scenario = MakeUsual(name);
    ASSERT_EQ(scenario.intervals.size(), activities.size());
    double start = kRestAtStart;
    for (std::size_t i = 0; i < activities.size(); ++i) {
      EXPECT_EQ(scenario.intervals[i].label, "task:" + activities[i].first);
      EXPECT_NEAR(scenario.intervals[i].start, start, 1e-9);
      start += activities[i].second;
      EXPECT_NEAR(scenario.intervals[i].end, start, 1e-9);
    }
  }
}

TEST(Routine, KeepsTheHandBusyInEveryActivity) {
  for (const char* name : {"eating", "morning"}) {
    const Scenario scenario = MakeUsual(name);
    for (const Interval& task : scenario.intervals) {
      double moving = 0.0;
      for (double t = task.start; t < task.end; t += 0.01)
        if (scenario.At(t).wrist_W.v.norm() > 0.02) moving += 0.01;
      EXPECT_GT(moving, 0.4 * (task.end - task.start)) << task.label;
    }
  }
}

TEST(Routine, BringsTheHandToTheMouthAndBendsTheElbowForIt) {
  const Scenario scenario = MakeUsual("eating");
  for (const char* label : {"task:soup", "task:spaghetti", "task:meat", "task:drinking"})
    for (const Interval& task : scenario.intervals) {
      if (task.label != label) continue;
      double most = 0.0;
      for (double t = task.start; t < task.end; t += 0.02)
        most = std::max(most, Elbow(scenario, t).flexion);
      EXPECT_GT(most, 115 * kDegree) << label;
    }
}

// What informs the relative heading, n_z of n = z_U x y_F, is little while teeth are brushed.
TEST(Routine, BrushesTeethWhereTheElbowTellsLittleOfHeading) {
  const Scenario scenario = MakeUsual("morning");
  const auto mean_nz = [&](const Interval& task) {
    double sum = 0.0;
    int count = 0;
    for (double t = task.start + 1.0; t < task.end; t += 0.05, ++count) {
      const ArmMotion arm = scenario.At(t);
      sum += std::abs((arm.upper_arm.turning.q_AB * Eigen::Vector3d::UnitZ())
                          .cross(arm.forearm.turning.q_AB * Eigen::Vector3d::UnitY())
                          .z());
    }
    return sum / count;
  };
  EXPECT_LT(mean_nz(scenario.intervals[4]), 0.2);
  EXPECT_GT(mean_nz(scenario.intervals[2]), 0.5);  // buttoning, the upper arm hanging
}

TEST(Routine, CombsWithARaisedArm) {
  const Scenario scenario = MakeUsual("morning");
  double sum = 0.0;
  int count = 0;
  for (double t = scenario.intervals[3].start + 2.0; t < scenario.intervals[3].end;
       t += 0.1, ++count)
    sum += ShoulderElevation(scenario.At(t).upper_arm.turning.q_AB);
  EXPECT_NEAR(sum / count, 105 * kDegree, 15 * kDegree);
}

}  // namespace
}  // namespace brachium
