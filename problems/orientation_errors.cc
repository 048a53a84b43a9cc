#include "problems/orientation_errors.h"

#include <cmath>
#include <numbers>

#include "problems/rotation.h"

namespace brachium {
namespace {

using Eigen::Matrix3d, Eigen::Quaterniond, Eigen::Vector3d;

void StoreCosines(const Quaterniond& q, Eigen::Index i, Series* cosines) {
  const Matrix3d R = q.toRotationMatrix();
  cosines->col(i) = Eigen::Map<const Eigen::Matrix<double, 9, 1>>(R.data());
}

}  // namespace

SwingTwist SplitAbout(const Quaterniond& q, const Vector3d& axis) {
  double twist = 2.0 * std::atan2(q.vec().dot(axis), q.w());
  twist = std::remainder(twist, 2.0 * std::numbers::pi);
  const Quaterniond swing = Exp(Vector3d(-twist * axis)) * q;
  return {.swing = Log(swing), .twist = twist};
}

OrientationErrors OrientationErrorsOf(const std::vector<Quaterniond>& estimate,
                                      const std::vector<Quaterniond>& reference,
                                      const std::vector<Vector3d>& vertical) {
  const auto n = static_cast<Eigen::Index>(estimate.size());
  Series rotation(3, n), inclination(3, n), heading(1, n), cosines(9, n), cosines_reference(9, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Quaterniond error = reference[k].conjugate() * estimate[k];
    const SwingTwist split = SplitAbout(error, vertical[k]);
    rotation.col(i) = Log(error);
    inclination.col(i) = split.swing;
    heading(0, i) = split.twist;
    StoreCosines(estimate[k], i, &cosines);
    StoreCosines(reference[k], i, &cosines_reference);
  }
  OrientationErrors errors{.rotation = StatisticsOf(rotation),
                           .inclination = StatisticsOf(inclination),
                           .heading = StatisticsOf(heading),
                           .axis = {}};
  for (Eigen::Index i = 0; i < 3; ++i)
    errors.axis[static_cast<std::size_t>(i)] = StatisticsOf(rotation.row(i));
  errors.rotation.correlation = Correlation(cosines, cosines_reference);
  return errors;
}

}  // namespace brachium
