#include "solver/baselines/drift_gains.h"

#include <gtest/gtest.h>

#include <cmath>

#include "problems/simulation/draws.h"
#include "tests/support/smooth_motion.h"

namespace brachium {
namespace {

using Eigen::Vector3d;
using Vectors = std::vector<Vector3d>;

const std::vector<double> kTimes = EvenTimes(0.0, 0.05, 1200);
const std::vector<Interval> kStill = {{"calibration:shoulder_still", 5.0, 55.0}};

Vectors Disagreement() {
  return Sampled(kTimes, [](double t) -> Vector3d { return 0.01 * t * t * SmoothPoint(t); });
}

TEST(DriftGains, AreRecoveredWhateverTheVelocityAtTheStartOfEachRepetition) {
  const Vectors S = Disagreement();
  Vectors A;
  for (std::size_t i = 0; i < S.size(); ++i)
    A.push_back(Vector3d(-0.3, -0.7, 0.2).cwiseProduct(S[i]) +
                Vector3d(1.0, 2.0, -3.0) * kTimes[i] + Vector3d(0.1, 0.2, 0.3));
  const auto gains = LearnDriftGains(kTimes, A, S, kStill, 20);
  ASSERT_TRUE(gains.has_value());
  EXPECT_LT((gains->value - Vector3d(-0.3, -0.7, 0.2)).norm(), 1e-9);
  EXPECT_LT(gains->half_width_95.maxCoeff(), 1e-9);
  EXPECT_EQ(gains->repetitions, 20);
}

TEST(DriftGains, HaveAnIntervalThatHoldsTheTruthNineteenTimesInTwenty) {
  const Vectors S = Disagreement();
  int held = 0, trials = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Draws draws(seed, "gains");
    Vectors A;
    Vector3d wander = Vector3d::Zero();
    for (std::size_t i = 0; i < S.size(); ++i) {
      wander = 0.95 * wander + 0.05 * draws.Normal3();
      A.push_back(-0.4 * S[i] + wander);
    }
    const auto gains = LearnDriftGains(kTimes, A, S, kStill, 20);
    for (int axis = 0; axis < 3; ++axis, ++trials)
      held += std::abs(gains->value[axis] + 0.4) < gains->half_width_95[axis];
  }
  EXPECT_GT(held, 0.88 * trials);
  EXPECT_LT(held, 0.995 * trials);
}

TEST(DriftGains, OfEqualIndependentDriftsAreMinusAHalfAndLeaveSeventyOnePercentOfTheDrift) {
  Draws draws(3, "drift");
  Vectors A, S;
  double before = 0.0, after = 0.0;
  std::vector<double> time;
  std::vector<Interval> intervals;
  for (int r = 0; r < 400; ++r) {
    const Vector3d upper = draws.Normal3(), fore = draws.Normal3();
    for (int i = 0; i < 20; ++i) {
      const double u = 0.05 * i;
      time.push_back(r + u);
      A.push_back(upper * (0.5 * u * u));
      S.push_back((fore - upper) * (0.5 * u * u));
      before += A.back().squaredNorm();
      after += (A.back() - kEqualDriftGain * S.back()).squaredNorm();
    }
    intervals.push_back({"calibration:shoulder_still", r - 0.01, r + 0.99});
  }
  const auto gains = LearnDriftGains(time, A, S, intervals, 400);
  EXPECT_NEAR(gains->value.mean(), kEqualDriftGain, 0.03);
  EXPECT_NEAR(std::sqrt(after / before), std::sqrt(0.5), 0.02);
}

TEST(DriftGains, AreAbsentWithoutAnIntervalOrWithoutADisagreement) {
  const Vectors S = Disagreement();
  EXPECT_FALSE(LearnDriftGains(kTimes, S, S, {}, 20).has_value());
  EXPECT_FALSE(LearnDriftGains(kTimes, S, S, {{"", 100.0, 200.0}}, 20).has_value());
  EXPECT_FALSE(
      LearnDriftGains(kTimes, S, Vectors(S.size(), Vector3d::Zero()), kStill, 20).has_value());
}

}  // namespace
}  // namespace brachium
