// Rotations and points that move, with exact first and second derivatives.
#pragma once

#include <Eigen/Geometry>

#include "problems/simulation/motion.h"

namespace brachium {

// Frame B turning in frame A: attitude, angular rate [rad/s] and its derivative [rad/s^2], both in
// B.
struct TurningFrame {
  Eigen::Quaterniond q_AB = Eigen::Quaterniond::Identity();
  Eigen::Vector3d omega_AB_B = Eigen::Vector3d::Zero();
  Eigen::Vector3d alpha_AB_B = Eigen::Vector3d::Zero();
};

// Turns about a fixed unit axis by an angle [rad].
TurningFrame About(const Eigen::Vector3d& axis, const Moving& angle);

// C in A, from B in A and C in B:
//   omega_AC_C = R_CB omega_AB_B + omega_BC_C,
//   alpha_AC_C = R_CB alpha_AB_B + alpha_BC_C - omega_BC_C x R_CB omega_AB_B.
TurningFrame operator*(const TurningFrame& a_to_b, const TurningFrame& b_to_c);

// Position, velocity and acceleration of a point, in the axes its name says [m, m/s, m/s^2].
struct MovingPoint {
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  Eigen::Vector3d v = Eigen::Vector3d::Zero();
  Eigen::Vector3d a = Eigen::Vector3d::Zero();
};

MovingPoint PointOf(const Moving& x, const Moving& y, const Moving& z);

MovingPoint operator+(const MovingPoint& a, const MovingPoint& b);
MovingPoint operator-(const MovingPoint& a, const MovingPoint& b);
MovingPoint operator*(const Moving& k, const MovingPoint& a);
Moving Dot(const MovingPoint& a, const MovingPoint& b);
MovingPoint Cross(const MovingPoint& a, const MovingPoint& b);
MovingPoint Unit(const MovingPoint& a);  // a is not zero

// A rigid segment B in the world: how it turns, and its proximal joint in world axes.
struct BodyMotion {
  TurningFrame turning;
  MovingPoint joint_W;
};

// The world motion of a point that has the motion `r_B` within the segment, in its axes from its
// proximal joint:  a = a_joint + R (alpha x r + omega x (omega x r) + 2 omega x r' + r'').
MovingPoint PointOn(const BodyMotion& body, const MovingPoint& r_B);

}  // namespace brachium
