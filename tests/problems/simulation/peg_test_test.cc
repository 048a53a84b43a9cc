#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "problems/simulation/patient.h"
#include "tests/support/scenarios.h"

namespace brachium {
namespace {

using Eigen::Vector3d;

Vector3d Place(const Scenario& scenario, const std::string& name) {
  for (const TrueValue& fact : scenario.facts)
    if (fact.name == name) return Vector3d(fact.value.data());
  throw std::out_of_range(name);
}

TEST(NineHolePegTest, PutsTheFingertipIntoEveryHoleInOrder) {
  for (const Side side : {Side::kRight, Side::kLeft})
    for (const int week : {0, 1, 10}) {
      ScenarioOptions options = MakeUsual("nine_hole_peg_test", side, 4, week).options;
      const Scenario scenario = MakeScenario(options);
      int peg = 0;
      for (const Interval& cycle : scenario.intervals) {
        if (!cycle.label.starts_with("cycle:")) continue;
        ++peg;
        EXPECT_EQ(cycle.label, "cycle:peg_" + std::to_string(peg));
        // The dwell at the end of a cycle; a tremor of 0.3 deg moves the fingertip by millimetres.
        const Vector3d tip = scenario.At(cycle.end - 0.05).fingertip_W.p;
        const Vector3d hole = Place(scenario, "peg_" + std::to_string(peg) + ".position_m");
        EXPECT_LT((tip - hole).norm(), week == 0 ? 1e-9 : 0.015) << week << ' ' << peg;
      }
      EXPECT_EQ(peg, 9);
    }
}

// Where the bowl is told to be within 15 mm, it is; the height of the desk is exact.
TEST(NineHolePegTest, IsStillAtThePlacesThatItTouches) {
  for (const int week : {0, 5}) {
    const Scenario scenario = MakeUsual("nine_hole_peg_test", Side::kLeft, 4, week);
    ASSERT_EQ(scenario.contacts.size(), 2u);
    for (const Contact& contact : scenario.contacts) {
      const auto tip = [&](double t) { return scenario.At(t).fingertip_W; };
      const Vector3d first = tip(contact.times.front()).p;
      for (const double time : contact.times) {
        const double tremor = week == 0 ? 1e-9 : 0.02;
        EXPECT_LT((tip(time + 0.03).p - tip(time).p).norm(), tremor);
        EXPECT_NEAR(tip(time).p.z(), first.z(), tremor);
        if (contact.height_only) continue;
        EXPECT_LT((tip(time).p - first).norm(), 2 * std::sqrt(2.0) * 0.015 + tremor);
      }
    }
  }
}

TEST(NineHolePegTest, HasItsHolesThirtyTwoMillimetresApartInRowsAndColumns) {
  const Scenario scenario = MakeUsual("nine_hole_peg_test");
  const auto hole = [&](int i) {
    return Place(scenario, "peg_" + std::to_string(i) + ".position_m");
  };
  for (const int peg : {1, 2, 4, 5, 7, 8})
    EXPECT_NEAR((hole(peg + 1) - hole(peg)).norm(), 0.032, 1e-12);
  for (int peg = 1; peg <= 6; ++peg) EXPECT_NEAR((hole(peg + 3) - hole(peg)).norm(), 0.032, 1e-12);
  EXPECT_NEAR((hole(2) - hole(1)).dot(hole(4) - hole(1)), 0.0, 1e-12);
}

// The furthest that the shoulder goes from where it was in the rest.
double ShoulderShift(const Scenario& scenario) {
  const Vector3d start = scenario.At(0.0).upper_arm.joint_W.p;
  double most = 0.0;
  for (double t = 0.0; t < scenario.options.duration; t += 0.05)
    most = std::max(most, (scenario.At(t).upper_arm.joint_W.p - start).norm());
  return most;
}

double TestTime(const Scenario& scenario) {
  for (const Interval& task : scenario.intervals)
    if (task.label.starts_with("task:")) return task.end - task.start;
  return 0.0;
}

TEST(NineHolePegTest, IsSlowerWithTheTrunksHelpAndWithTremorForThePatient) {
  const Scenario healthy = MakeUsual("nine_hole_peg_test");
  const Scenario first = MakeUsual("nine_hole_peg_test", Side::kRight, 4, 1);
  const Scenario last = MakeUsual("nine_hole_peg_test", Side::kRight, 4, 10);
  EXPECT_NEAR(TestTime(healthy), 18.0, 2.0);
  EXPECT_NEAR(TestTime(first), 3.0 * TestTime(healthy), 5.0);
  EXPECT_NEAR(TestTime(last), 2.0 * TestTime(healthy), 4.0);
  EXPECT_LT(ShoulderShift(healthy), 0.03);
  for (const Scenario& patient : {first, last}) {
    EXPECT_GT(ShoulderShift(patient), 0.05);
    EXPECT_LT(ShoulderShift(patient), 0.12);
  }
  EXPECT_GT(PatientTremor(1), PatientTremor(10));
}

TEST(Tremor, LiesBetweenFourAndSixHertzAndIsAbsentAtRest) {
  ScenarioOptions options{.name = "static_pose", .tremor = 1 * kDegree};
  options.duration = UsualDuration(options);
  const Scenario scenario = MakeScenario(options);
  double squares = 0.0, rates = 0.0;
  int count = 0;
  for (double t = 5.0; t < 60.0; t += 0.003, ++count) {
    const Moving wrist = scenario.JointsAt(t)[kWristFlexion];
    squares += wrist.value * wrist.value;
    rates += wrist.rate * wrist.rate;
  }
  EXPECT_NEAR(std::sqrt(squares / count), 1 * kDegree, 0.1 * kDegree);
  const double frequency = std::sqrt(rates / squares) / (2 * M_PI);
  EXPECT_GT(frequency, 4.0);
  EXPECT_LT(frequency, 6.0);
  EXPECT_EQ(scenario.JointsAt(1.0)[kWristFlexion].rate, 0.0);
}

}  // namespace
}  // namespace brachium
