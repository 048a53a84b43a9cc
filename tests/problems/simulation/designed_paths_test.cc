#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/scenarios.h"

namespace brachium {
namespace {

using Eigen::Vector3d;

const std::vector<double>& Fact(const Scenario& scenario, const std::string& name) {
  for (const TrueValue& fact : scenario.facts)
    if (fact.name == name) return fact.value;
  throw std::out_of_range(name);
}

Vector3d Place(const Scenario& scenario, const std::string& name) {
  return Vector3d(Fact(scenario, name).data());
}

double DistanceToSegment(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
  const double share = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (a + share * (b - a) - p).norm();
}

// Calls check(wrist) through all cycles, and expects that they take a minute at least.
template <typename Check>
void ThroughCycles(const Scenario& scenario, const Check& check) {
  double total = 0.0;
  for (const Interval& cycle : scenario.intervals) {
    total += cycle.end - cycle.start;
    for (double t = cycle.start; t <= cycle.end; t += 0.01) check(scenario.At(t).wrist_W.p);
  }
  EXPECT_GT(total, 90.0);
}

TEST(Circle, IsMetByTheWristWhateverShoulderAndElbowDo) {
  for (const Side side : {Side::kRight, Side::kLeft}) {
    const Scenario scenario = MakeUsual("circle", side);
    const Vector3d centre = Place(scenario, "circle.centre_m");
    ThroughCycles(scenario, [&](const Vector3d& wrist) {
      EXPECT_NEAR((wrist - centre).norm(), 0.1, 1e-9);
      EXPECT_NEAR(wrist.z(), centre.z(), 1e-9);
    });
  }
}

TEST(Circle, GoesOnceAroundInEachCycle) {
  const Scenario scenario = MakeUsual("circle");
  const Vector3d centre = Place(scenario, "circle.centre_m");
  for (const Interval& cycle : scenario.intervals) {
    EXPECT_NEAR(cycle.end - cycle.start, 4.0, 0.41);
    double turned = 0.0;
    Vector3d before = scenario.At(cycle.start).wrist_W.p - centre;
    for (double t = cycle.start; t < cycle.end - 1e-9; t += (cycle.end - cycle.start) / 100) {
      const Vector3d after = scenario.At(t + (cycle.end - cycle.start) / 100).wrist_W.p - centre;
      turned += std::atan2(before.cross(after).z(), before.dot(after));
      before = after;
    }
    EXPECT_NEAR(turned, 2 * M_PI, 0.01);
  }
}

TEST(Rectangle, IsMetByTheWristOnAllFourSides) {
  for (const Side side : {Side::kRight, Side::kLeft}) {
    const Scenario scenario = MakeUsual("rectangle", side);
    std::array<Vector3d, 4> corner;
    for (std::size_t i = 0; i < 4; ++i)
      corner[i] = Place(scenario, "rectangle.corner_" + std::to_string(i + 1) + "_m");
    EXPECT_NEAR((corner[1] - corner[0]).norm(), 0.2, 1e-12);
    EXPECT_NEAR((corner[2] - corner[1]).norm(), 0.14, 1e-12);
    std::array<double, 4> nearest{1, 1, 1, 1};
    ThroughCycles(scenario, [&](const Vector3d& wrist) {
      double distance = 1.0;
      for (std::size_t i = 0; i < 4; ++i) {
        distance = std::min(distance, DistanceToSegment(wrist, corner[i], corner[(i + 1) % 4]));
        nearest[i] = std::min(nearest[i], (wrist - corner[i]).norm());
      }
      EXPECT_LT(distance, 1e-9);
    });
    for (const double distance : nearest) EXPECT_LT(distance, 1e-9);
  }
}

TEST(Rectangle, HasTheWristStillAtItsCornersInEachLap) {
  for (const Side side : {Side::kRight, Side::kLeft}) {
    const Scenario scenario = MakeUsual("rectangle", side);
    ASSERT_EQ(scenario.contacts.size(), 4u);
    for (const Contact& contact : scenario.contacts) {
      EXPECT_GE(contact.times.size(), 20u);
      const Vector3d corner = Place(scenario, "rectangle." + contact.place + "_m");
      for (const double time : contact.times)
        EXPECT_LT((scenario.At(time).wrist_W.p - corner).norm(), 1e-9) << contact.place;
    }
  }
}

TEST(DesignedPath, IsLeftByATremblingHand) {
  ScenarioOptions options = MakeUsual("circle").options;
  options.tremor = 0.3 * kDegree;
  const Scenario scenario = MakeScenario(options);
  const Vector3d centre = Place(scenario, "circle.centre_m");
  double worst = 0.0;
  for (double t = 30.0; t < 60.0; t += 0.01)
    worst = std::max(worst, std::abs((scenario.At(t).wrist_W.p - centre).norm() - 0.1));
  EXPECT_GT(worst, 5e-4);
  EXPECT_LT(worst, 1e-2);
}

}  // namespace
}  // namespace brachium
