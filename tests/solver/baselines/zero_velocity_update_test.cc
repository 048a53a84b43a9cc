#include "solver/baselines/zero_velocity_update.h"

#include <gtest/gtest.h>

#include "tests/support/smooth_motion.h"

namespace brachium {
namespace {

using Eigen::Vector3d;

const std::vector<double> kTimes = EvenTimes(0.0, 0.01, 1001);
const std::vector<Epoch> kEpochs = {{Segment::kHand, 2.0, 4.0}, {Segment::kHand, 6.5, 8.0}};

// Moves within the epochs and stands still between them.
Vector3d Velocity(double t) {
  Vector3d v = Vector3d::Zero();
  for (const Epoch& epoch : kEpochs)
    if (t > epoch.start && t < epoch.end)
      v = Vector3d(1.0, -2.0, 0.5) *
          std::sin(3.14159265358979 * (t - epoch.start) / (epoch.end - epoch.start));
  return v;
}

TEST(ZeroVelocityUpdate, TakesOffADriftThatIsStraightExactly) {
  const auto truth = Sampled(kTimes, Velocity);
  auto v = truth;
  for (std::size_t i = 0; i < v.size(); ++i)
    v[i] += Vector3d(0.3, 0.2, -0.1) + Vector3d(-0.05, 0.04, 0.02) * kTimes[i];
  UpdateZeroVelocity(kTimes, kEpochs, v);
  for (std::size_t i = 0; i < v.size(); ++i) ASSERT_LT((v[i] - truth[i]).norm(), 1e-12) << i;
}

TEST(ZeroVelocityUpdate, HoldsStillOutsideOfEpochs) {
  auto v = Sampled(kTimes, [](double t) -> Vector3d { return Vector3d::Constant(t); });
  UpdateZeroVelocity(kTimes, {}, v);
  for (const Vector3d& held : v) EXPECT_EQ(held, Vector3d::Zero());
}

TEST(ZeroVelocityUpdate, KeepsTheDriftOfAnEpochThatNoRestFollows) {
  auto v = Sampled(kTimes, [](double t) -> Vector3d { return Vector3d(t, 0.0, 0.0); });
  UpdateZeroVelocity(kTimes, {{Segment::kHand, 8.0, 10.005}}, v);
  EXPECT_NEAR(v.back().x(), 2.0, 1e-9);
  EXPECT_EQ(v[700], Vector3d::Zero());
}

TEST(IntegrateOnce, IsExactForAStraightLine) {
  const auto rate = Sampled(kTimes, [](double t) -> Vector3d { return {1.0, t, -t}; });
  const Vector3d end = IntegrateOnce(kTimes, rate).back();
  EXPECT_LT((end - Vector3d(10.0, 50.0, -50.0)).norm(), 1e-9);
}

}  // namespace
}  // namespace brachium
