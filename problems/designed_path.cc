#include "problems/designed_path.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace brachium {
namespace {

using Eigen::Matrix3d, Eigen::Matrix3Xd, Eigen::Vector3d;

constexpr int kStarts = 8;          // turns in the plane
constexpr int kRounds = 500;        // of one start
constexpr double kSettled = 1e-14;  // relative change of the sum of squares

Matrix3Xd KnownOnly(const Matrix3Xd& points) {
  Matrix3Xd known(3, points.cols());
  Eigen::Index n = 0;
  for (const auto& point : points.colwise())
    if (point.allFinite()) known.col(n++) = point;
  return known.leftCols(n);
}

// The points' plane in the x-y plane, their mean at the origin, their longest extent along x.
RigidMotion IntoPlane(const Matrix3Xd& points) {
  const Vector3d mean = points.rowwise().mean();
  const Matrix3Xd centred = points.colwise() - mean;
  const Eigen::SelfAdjointEigenSolver<Matrix3d> axes(centred * centred.transpose());
  RigidMotion motion;
  motion.R = axes.eigenvectors().rowwise().reverse().transpose();
  if (motion.R.determinant() < 0.0) motion.R.row(2) = -motion.R.row(2);
  motion.t = -motion.R * mean;
  return motion;
}

Matrix3Xd ClosestTo(const Matrix3Xd& points, const DesignedPath& path) {
  Matrix3Xd closest(3, points.cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i) closest.col(i) = path.Closest(points.col(i));
  return closest;
}

struct Fit {
  RigidMotion pose;
  double square = std::numeric_limits<double>::infinity();
};

// Closest points and rigid alignment in turns; the sum of squares only falls.
Fit Refined(const Matrix3Xd& points, const DesignedPath& path, RigidMotion pose) {
  Fit fit{.pose = pose};
  for (int round = 0; round < kRounds; ++round) {
    const Matrix3Xd closest = ClosestTo(fit.pose.Apply(points), path);
    const RigidMotion next = AlignRigidly(points, closest);
    const double square = (next.Apply(points) - closest).squaredNorm();
    const bool settled = fit.square - square <= kSettled * square;
    fit = {.pose = next, .square = square};
    if (settled) break;
  }
  return fit;
}

PathErrors ErrorsOf(const Matrix3Xd& points, const Matrix3Xd& targets, const RigidMotion& pose) {
  const Matrix3Xd placed = pose.Apply(points);
  PathErrors errors{.pose = pose, .distance = StatisticsOf(placed - targets), .axis = {}};
  errors.distance.correlation = Correlation(placed, targets);
  for (int i = 0; i < 3; ++i) {
    Statistics& axis = errors.axis[static_cast<std::size_t>(i)];
    axis = StatisticsOf(placed.row(i) - targets.row(i));
    axis.correlation = Correlation(placed.row(i), targets.row(i));
  }
  return errors;
}

}  // namespace

DesignedPath DesignedPath::Circle(double radius) { return {radius, 0.0, 0.0}; }

DesignedPath DesignedPath::Rectangle(double width, double height) { return {0.0, width, height}; }

double DesignedPath::Length() const {
  return radius_ > 0.0 ? 2.0 * std::numbers::pi * radius_ : 2.0 * (width_ + height_);
}

Vector3d DesignedPath::At(double turns) const {
  const double part = turns - std::floor(turns), angle = 2.0 * std::numbers::pi * part;
  if (radius_ > 0.0) return {radius_ * std::cos(angle), radius_ * std::sin(angle), 0.0};
  double s = part * Length();
  const double x = width_ / 2.0, y = height_ / 2.0;
  if (s < height_) return {x, s - y, 0.0};
  if ((s -= height_) < width_) return {x - s, y, 0.0};
  if ((s -= width_) < height_) return {-x, y - s, 0.0};
  return {s - height_ - x, -y, 0.0};
}

Vector3d DesignedPath::Closest(const Vector3d& point) const {
  if (radius_ > 0.0) {
    const double distance = point.head<2>().norm();
    if (distance == 0.0) return {radius_, 0.0, 0.0};
    return {radius_ / distance * point.x(), radius_ / distance * point.y(), 0.0};
  }
  const double x = width_ / 2.0, y = height_ / 2.0;
  Vector3d closest(std::clamp(point.x(), -x, x), std::clamp(point.y(), -y, y), 0.0);
  const double to_side = x - std::abs(closest.x()), to_end = y - std::abs(closest.y());
  if (to_side > 0.0 && to_end > 0.0) {  // inside: to the nearest edge
    if (to_side < to_end)
      closest.x() = std::copysign(x, closest.x());
    else
      closest.y() = std::copysign(y, closest.y());
  }
  return closest;
}

PathErrors CompareWithPath(const Matrix3Xd& points, const DesignedPath& path) {
  const Matrix3Xd known = KnownOnly(points);
  if (known.cols() == 0) return {};
  const RigidMotion plane = IntoPlane(known);
  Fit best;
  for (int i = 0; i < kStarts; ++i) {
    const Matrix3d turn = Eigen::AngleAxisd(2.0 * std::numbers::pi * i / kStarts, Vector3d::UnitZ())
                              .toRotationMatrix();
    const Fit fit = Refined(known, path, {.R = turn * plane.R, .t = turn * plane.t});
    if (fit.square < best.square) best = fit;
  }
  PathErrors errors = ErrorsOf(known, ClosestTo(best.pose.Apply(known), path), best.pose);
  errors.distance.left_out = static_cast<std::size_t>(points.cols() - known.cols());
  return errors;
}

PathErrors CompareWithPath(const Matrix3Xd& points, const std::vector<double>& turns,
                           const DesignedPath& path) {
  Matrix3Xd targets(3, points.cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    targets.col(i) = path.At(turns[static_cast<std::size_t>(i)]);
  return ErrorsOf(points, targets, AlignRigidly(points, targets));
}

}  // namespace brachium
