#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/scenarios.h"

namespace brachium {
namespace {

using Eigen::Vector3d;

TEST(GoniometerSteps, HoldEveryTenDegreesToEighty) {
  const Scenario scenario = MakeUsual("goniometer_steps");
  ASSERT_EQ(scenario.intervals.size(), 8u);
  for (std::size_t i = 0; i < 8; ++i) {
    const Interval& hold = scenario.intervals[i];
    EXPECT_GE(hold.end - hold.start, 2.9);
    for (double t = hold.start + 0.01; t < hold.end; t += 0.1) {
      const ArmMotion arm = scenario.At(t);
      const double angle = arm.upper_arm.turning.q_AB.angularDistance(arm.forearm.turning.q_AB);
      EXPECT_NEAR(angle, 10.0 * static_cast<double>(i + 1) * kDegree, 1e-12);
    }
  }
}

TEST(GoniometerSwing, RaisesTheEndOfTheArmByTenCentimetresInAVerticalPlane) {
  for (const Side side : {Side::kRight, Side::kLeft}) {
    const Scenario scenario = MakeUsual("goniometer_swing", side);
    const Vector3d hinge = scenario.At(0.0).forearm.joint_W.p;
    const Vector3d start = scenario.At(0.0).wrist_W.p - hinge;
    EXPECT_NEAR(start.z(), 0.0, 1e-12);
    double top = 0.0;
    for (double t = 0.0; t < scenario.options.duration; t += 0.01) {
      EXPECT_LT((scenario.At(t).forearm.joint_W.p - hinge).norm(), 1e-12);
      const Vector3d end = scenario.At(t).wrist_W.p - hinge;
      EXPECT_NEAR(end.dot(start.cross(Vector3d::UnitZ())), 0.0, 1e-12);
      top = std::max(top, end.z());
    }
    EXPECT_NEAR(top, 0.1, 1e-12);
  }
}

}  // namespace
}  // namespace brachium
