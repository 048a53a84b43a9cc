// The constants that an estimate and a reference may differ by without being wrong: the heading and
// origin of their worlds, and how a reference's frames were put on the segments.
#pragma once

#include <Eigen/Geometry>
#include <vector>

namespace brachium {

// Two series of one rotation, sample by sample; where one is NaN both are.
struct RotationPairs {
  std::vector<Eigen::Quaterniond> estimate;
  std::vector<Eigen::Quaterniond> reference;

  std::size_t size() const { return estimate.size(); }
  bool Known(std::size_t i) const { return estimate[i].coeffs().allFinite(); }
};

// The distal body in the proximal one, where both are known.
RotationPairs RelativeOf(const RotationPairs& proximal, const RotationPairs& distal);

// reference ≈ proximal * estimate * distal.
struct RotationAlignment {
  Eigen::Quaterniond proximal = Eigen::Quaterniond::Identity();
  Eigen::Quaterniond distal = Eigen::Quaterniond::Identity();

  std::vector<Eigen::Quaterniond> Apply(const std::vector<Eigen::Quaterniond>& estimate) const;
};

// One constant on either side, least mean squared angle: the best rotation of four-space, in closed
// form, refined by Gauss-Newton steps. What the motion leaves open (a hinge: a turn about its axis
// can go to either side) stays as close to no turn as the rest allows; it does not alter the error.
RotationAlignment AlignBothSides(const RotationPairs& pairs);

// One heading turn common to all of several segments in two worlds with vertical z (proximal) and,
// if asked for, a constant rotation of each segment's own frame (distal). Least sum of 1 - cos(θ/2)
// over the errors θ. One alignment per segment, in their order.
std::vector<RotationAlignment> AlignHeading(const std::vector<RotationPairs>& segments,
                                            bool distal_constants);

// The angle of a heading turn, (-π, π].
double HeadingOf(const Eigen::Quaterniond& q_VW);

// Two series of points, by columns; where one is NaN both are, but z may be missing alone.
struct PointPairs {
  Eigen::Matrix3Xd estimate;
  Eigen::Matrix3Xd reference;
};

// reference ≈ Rz(heading) * estimate + shift.
struct PointAlignment {
  double heading = 0.0;                             // [rad]
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();  // [m]

  Eigen::Matrix3Xd Apply(const Eigen::Matrix3Xd& estimate) const;
};

// Least squares over all points of all series together; z is fitted where it is known.
PointAlignment AlignPoints(const std::vector<PointPairs>& points);

}  // namespace brachium
