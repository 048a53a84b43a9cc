// A path that was to be drawn, a circle or a rectangle, and how far from it points were. Only the
// path's pose is fitted, never its size. After Zhou et al., Med. Eng. Phys. 30 (2008), section 3.1.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "problems/rigid_alignment.h"
#include "problems/statistics.h"

namespace brachium {

// A closed path in the x-y plane about the origin, run counter-clockwise from +x: a circle from
// (radius, 0), a rectangle from (width/2, -height/2).
class DesignedPath {
 public:
  static DesignedPath Circle(double radius);                   // [m]
  static DesignedPath Rectangle(double width, double height);  // along x and y [m]

  double Length() const;
  Eigen::Vector3d At(double turns) const;  // after that part of its length, any number
  Eigen::Vector3d Closest(const Eigen::Vector3d& point) const;

 private:
  DesignedPath(double radius, double width, double height)
      : radius_(radius), width_(width), height_(height) {}

  double radius_;  // 0: a rectangle
  double width_, height_;
};

// The points in the axes of the path, and what they are off.
struct PathErrors {
  RigidMotion pose;                // points -> path
  Statistics distance;             // in space
  std::array<Statistics, 3> axis;  // along the path's axes
};

// Against the closest point of the path, wherever the hand should have been; the pose with the
// least sum of squares, from several starts in the plane of the points. NaNs are left out.
PathErrors CompareWithPath(const Eigen::Matrix3Xd& points, const DesignedPath& path);

// Against where the hand should have been: `turns` per point. Pearson's correlation stands in each
// axis and in the distance. The pose is the least-squares one of those pairs.
PathErrors CompareWithPath(const Eigen::Matrix3Xd& points, const std::vector<double>& turns,
                           const DesignedPath& path);

}  // namespace brachium
