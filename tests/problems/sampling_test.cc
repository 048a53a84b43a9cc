#include "problems/sampling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace brachium {
namespace {

using Eigen::AngleAxisd, Eigen::Quaterniond, Eigen::Vector3d;

const double kNaN = std::nan("");

TEST(SampleTimes, FindTheStepThatHoldsAnInstant) {
  const SampleTimes times({0.0, 0.1, 0.2, 0.3});
  const auto place = times.Find(0.125);
  ASSERT_TRUE(place.has_value());
  EXPECT_EQ(place->index, 1u);
  EXPECT_NEAR(place->fraction, 0.25, 1e-12);
}

TEST(SampleTimes, HaveNoPlaceOutsideTheirSpan) {
  const SampleTimes times({0.0, 0.1, 0.2});
  EXPECT_FALSE(times.Find(-1e-6).has_value());
  EXPECT_FALSE(times.Find(0.2 + 1e-6).has_value());
  EXPECT_TRUE(times.Find(0.0).has_value());
  EXPECT_TRUE(times.Find(0.2).has_value());
}

TEST(SampleTimes, HaveNoPlaceInAStepOfNearlyTwiceTheMedian) {
  const SampleTimes longer({0.0, 0.1, 0.2, 0.39, 0.49});
  EXPECT_FALSE(longer.Find(0.3).has_value());
  EXPECT_TRUE(longer.Find(0.2).has_value());
  EXPECT_TRUE(longer.Find(0.39).has_value());
  const SampleTimes jitter({0.0, 0.1, 0.2, 0.37, 0.47});
  EXPECT_TRUE(jitter.Find(0.3).has_value());
}

TEST(SampleTimes, StandAloneOrEmptyWithoutTrouble) {
  EXPECT_FALSE(SampleTimes(std::vector<double>{}).Find(0.0).has_value());
  const SampleTimes one({1.0});
  EXPECT_TRUE(one.Find(1.0).has_value());
  EXPECT_FALSE(one.Find(1.1).has_value());
}

TEST(Interpolate, IsLinearForNumbersAndPoints) {
  const SampleTimes times({0.0, 1.0, 2.0});
  EXPECT_NEAR(Interpolate(times, std::vector<double>{1.0, 3.0, 4.0}, {0.5})[0], 2.0, 1e-14);
  const std::vector<Vector3d> points = {Vector3d(0, 0, 0), Vector3d(1, 2, 3), Vector3d(2, 2, 2)};
  EXPECT_LT((Interpolate(times, points, {1.5})[0] - Vector3d(1.5, 2, 2.5)).norm(), 1e-14);
}

TEST(Interpolate, TurnsARotationAtConstantRateAlongTheShortestArc) {
  const SampleTimes times({0.0, 1.0});
  const Quaterniond end(AngleAxisd(1.0, Vector3d::UnitX()));
  for (const double sign : {1.0, -1.0}) {
    const Quaterniond same(Eigen::Vector4d(sign * end.coeffs()));
    const Quaterniond q = Interpolate(times, {Quaterniond::Identity(), same}, {0.3})[0];
    EXPECT_LT(q.angularDistance(Quaterniond(AngleAxisd(0.3, Vector3d::UnitX()))), 1e-12);
  }
}

TEST(Interpolate, IsAbsentBesideASampleThatIs) {
  const SampleTimes times({0.0, 1.0, 2.0, 3.0});
  const auto values =
      Interpolate(times, std::vector<double>{0.0, kNaN, 2.0, 3.0}, {0.0, 0.5, 1.0, 1.5, 2.0, 2.5});
  EXPECT_EQ(values[0], 0.0);
  for (const std::size_t i : {1, 2, 3}) EXPECT_TRUE(std::isnan(values[i]));
  EXPECT_EQ(values[4], 2.0);
  EXPECT_EQ(values[5], 2.5);
}

TEST(Interpolate, KeepsWhatIsKnownOfAPointWithoutHeight) {
  const SampleTimes times({0.0, 1.0});
  const auto points =
      Interpolate(times, std::vector<Vector3d>{Vector3d(0, 0, kNaN), Vector3d(2, 4, kNaN)}, {0.5});
  EXPECT_EQ(points[0].x(), 1.0);
  EXPECT_EQ(points[0].y(), 2.0);
  EXPECT_TRUE(std::isnan(points[0].z()));
}

}  // namespace
}  // namespace brachium
