#include "problems/designed_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace brachium {
namespace {

using Eigen::Matrix3Xd, Eigen::Vector3d;

const DesignedPath kPaths[] = {DesignedPath::Circle(0.1), DesignedPath::Rectangle(0.2, 0.14)};

RigidMotion SomePose() {
  return {.R = Eigen::AngleAxisd(1.1, Vector3d(1, 2, -0.5).normalized()).toRotationMatrix(),
          .t = Vector3d(0.3, 0.2, 0.75)};
}

std::vector<double> Turns(int n) {
  std::vector<double> turns;
  for (int i = 0; i < n; ++i) turns.push_back(0.013 + 2.0 * i / n);
  return turns;
}

Matrix3Xd Drawn(const DesignedPath& path, const std::vector<double>& turns) {
  Matrix3Xd points(3, static_cast<Eigen::Index>(turns.size()));
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    points.col(i) = path.At(turns[static_cast<std::size_t>(i)]);
  return points;
}

TEST(DesignedPath, IsClosedAndRunAtEvenSpeed) {
  EXPECT_NEAR(kPaths[0].Length(), 0.2 * std::numbers::pi, 1e-14);
  EXPECT_NEAR(kPaths[1].Length(), 0.68, 1e-14);
  for (const DesignedPath& path : kPaths) {
    EXPECT_LT((path.At(0.0) - path.At(1.0)).norm(), 1e-12);
    double length = 0.0;
    for (int i = 0; i < 6800; ++i)
      length += (path.At((i + 1) / 6800.0) - path.At(i / 6800.0)).norm();
    EXPECT_NEAR(length, path.Length(), 1e-5);
  }
}

TEST(DesignedPath, HasItsClosestPointOnItself) {
  for (const DesignedPath& path : kPaths)
    for (int i = 0; i < 200; ++i) {
      const Vector3d point = 0.15 * Vector3d::Random();
      const double distance = (path.Closest(point) - point).norm();
      for (double turns = 0.0; turns < 1.0; turns += 0.01)
        EXPECT_LE(distance, (path.At(turns) - point).norm() + 1e-12);
    }
}

TEST(PathErrors, AreZeroForAPerfectDrawingAnywhere) {
  for (const DesignedPath& path : kPaths) {
    const Matrix3Xd points = SomePose().Apply(Drawn(path, Turns(400)));
    EXPECT_LT(CompareWithPath(points, path).distance.rmse, 1e-7);
    EXPECT_LT(CompareWithPath(points, Turns(400), path).distance.rmse, 1e-12);
  }
}

TEST(PathErrors, SeeADrawingThatIsTooLarge) {
  const Matrix3Xd points = SomePose().Apply(1.05 * Drawn(kPaths[0], Turns(400)));
  EXPECT_NEAR(CompareWithPath(points, kPaths[0]).distance.rmse, 0.005, 1e-9);
  EXPECT_NEAR(CompareWithPath(points, Turns(400), kPaths[0]).distance.rmse, 0.005, 1e-9);
}

TEST(PathErrors, SeeALagOnlyAgainstTheTime) {
  std::vector<double> late = Turns(400);
  for (std::size_t i = 0; i < late.size(); ++i)
    late[i] += 0.02 * std::sin(2.0 * std::numbers::pi * 3.0 * static_cast<double>(i) / 400.0);
  const Matrix3Xd points = SomePose().Apply(Drawn(kPaths[1], late));
  EXPECT_LT(CompareWithPath(points, kPaths[1]).distance.rmse, 1e-6);
  const PathErrors timed = CompareWithPath(points, Turns(400), kPaths[1]);
  EXPECT_GT(timed.distance.rmse, 0.005);
  EXPECT_GT(timed.axis[0].correlation.value(), 0.95);
}

TEST(PathErrors, LeaveOutUnknownPoints) {
  Matrix3Xd points = Drawn(kPaths[0], Turns(100));
  points.col(7).setConstant(std::nan(""));
  for (const PathErrors& errors :
       {CompareWithPath(points, kPaths[0]), CompareWithPath(points, Turns(100), kPaths[0])}) {
    EXPECT_EQ(errors.distance.used, 99u);
    EXPECT_EQ(errors.distance.left_out, 1u);
  }
}

}  // namespace
}  // namespace brachium
