#include "problems/clock_offset.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "problems/rotation.h"
#include "tests/support/smooth_motion.h"

namespace brachium {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;
using Source = ClockOffset::Source;

const std::vector<double> kEstimateTimes = EvenTimes(0.0, 0.01, 3000);

Estimate MovingArm() {
  Estimate estimate;
  estimate.time = kEstimateTimes;
  estimate.q_WB[Segment::kForearm] =
      Sampled(kEstimateTimes, [](double t) { return SmoothRotation(t); });
  estimate.p_W["hand"] = Sampled(kEstimateTimes, SmoothPoint);
  return estimate;
}

// Turned by constants, at its own rate, on a clock that is ahead.
Reference SeenBy(double rate, double offset) {
  Reference reference;
  reference.frames = Reference::Frames::kCluster;
  reference.time = EvenTimes(1.0037, 1.0 / rate, static_cast<std::size_t>(25 * rate));
  reference.q_VB[Segment::kForearm] = Sampled(reference.time, [&](double t) {
    return Quaterniond(Exp(Vector3d(0, 0, 2)) * SmoothRotation(t - offset) *
                       Exp(Vector3d(1, 0.5, -2)));
  });
  return reference;
}

TEST(ClockOffset, IsTheGivenOneWhereThereIsOne) {
  Reference reference = SeenBy(100, 0.05);
  reference.clock_offset = -3.0;
  const ClockOffset offset = ClockOffsetOf(MovingArm(), reference);
  EXPECT_EQ(offset.seconds, -3.0);
  EXPECT_EQ(offset.source, Source::kGiven);
}

TEST(ClockOffset, IsFoundToHalfAMillisecondAtAnyRate) {
  for (const double rate : {30.0, 100.0, 285.714})
    for (const double seconds : {-0.1834, -0.0161, 0.0, 0.0042, 0.1777}) {
      const ClockOffset offset = ClockOffsetOf(MovingArm(), SeenBy(rate, seconds));
      EXPECT_NEAR(offset.seconds, seconds, 5e-4) << rate;
      EXPECT_EQ(offset.source, Source::kEstimated);
      EXPECT_GT(offset.correlation.value(), 0.99);
    }
}

TEST(ClockOffset, IsFoundDespiteNoiseDriftAndGaps) {
  Reference reference = SeenBy(100, 0.0337);
  std::mt19937 random(3);
  std::normal_distribution<double> normal(0.0, 0.003);
  std::vector<Quaterniond>& q_VB = reference.q_VB[Segment::kForearm];
  for (std::size_t i = 0; i < q_VB.size(); ++i) {
    const double drift = 0.0003 * static_cast<double>(i);
    q_VB[i] = Exp(Vector3d(0, 0, drift)) * q_VB[i] *
              Exp(Vector3d(normal(random), normal(random), normal(random)));
    if (i % 400 < 60) q_VB[i].w() = std::nan("");
  }
  EXPECT_NEAR(ClockOffsetOf(MovingArm(), reference).seconds, 0.0337, 5e-4);
}

TEST(ClockOffset, IsFoundWhereMostRowsOfTheReferenceAreLost) {
  Reference whole = SeenBy(100, 0.0337), lossy;
  for (std::size_t i = 0; i < whole.time.size(); ++i) {
    if (i % 50 >= 20) continue;
    lossy.time.push_back(whole.time[i]);
    lossy.q_VB[Segment::kForearm].push_back(whole.q_VB[Segment::kForearm][i]);
  }
  const ClockOffset offset = ClockOffsetOf(MovingArm(), lossy);
  EXPECT_NEAR(offset.seconds, 0.0337, 5e-4);
  EXPECT_GT(offset.correlation.value(), 0.999);
}

TEST(ClockOffset, IsFoundFromPositionsAloneInThePlane) {
  Reference reference = SeenBy(120, 0.0);
  reference.q_VB.clear();
  reference.p_V["hand"] = Sampled(reference.time, [](double t) {
    const Vector3d p = SmoothPoint(t + 0.0831);
    return Vector3d(5 - p.y(), 2 + p.x(), std::nan(""));
  });
  const ClockOffset offset = ClockOffsetOf(MovingArm(), reference);
  EXPECT_NEAR(offset.seconds, -0.0831, 5e-4);
  EXPECT_EQ(offset.source, Source::kEstimated);
}

TEST(ClockOffset, IsUnknownWhenTheMotionsDoNotTell) {
  Estimate still = MovingArm();
  for (Quaterniond& q_WB : still.q_WB[Segment::kForearm]) q_WB = Quaterniond::Identity();
  Reference absent = SeenBy(100, 0.0);
  for (Quaterniond& q_VB : absent.q_VB[Segment::kForearm]) q_VB.x() = std::nan("");
  for (const ClockOffset& offset :
       {ClockOffsetOf(still, SeenBy(100, 0.0)), ClockOffsetOf(MovingArm(), absent),
        ClockOffsetOf(MovingArm(), SeenBy(100, 0.6)), ClockOffsetOf(MovingArm(), Reference{}),
        ClockOffsetOf(Estimate{}, absent)}) {
    EXPECT_EQ(offset.seconds, 0.0);
    EXPECT_EQ(offset.source, Source::kUnknown);
  }
}

}  // namespace
}  // namespace brachium
