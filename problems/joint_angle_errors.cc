#include "problems/joint_angle_errors.h"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "problems/arm_angles.h"

namespace brachium {
namespace {

// The reference's angle and the one a turn away from it that is nearest to the estimate's, so that
// no correlation is lost where an angle passes ±π.
JointAngleError ErrorOf(const std::vector<double>& estimate, const std::vector<double>& reference) {
  std::vector<double> nearest;
  for (std::size_t i = 0; i < estimate.size(); ++i)
    nearest.push_back(reference[i] +
                      std::remainder(estimate[i] - reference[i], 2.0 * std::numbers::pi));
  const auto n = static_cast<Eigen::Index>(estimate.size());
  const Series r = Eigen::Map<const Eigen::RowVectorXd>(reference.data(), n);
  const Series e = Eigen::Map<const Eigen::RowVectorXd>(nearest.data(), n);
  JointAngleError error{StatisticsOf(e - r), Concordance(nearest, reference),
                        LimitsOf(nearest, reference)};
  error.correlation = Correlation(e, r);
  error.estimate = std::move(nearest);
  error.reference = reference;
  return error;
}

}  // namespace

std::map<std::string, JointAngleError> JointAngleErrors(
    const std::map<Segment, RotationPairs>& segments, Side side) {
  std::map<Segment, std::vector<Eigen::Quaterniond>> estimate, reference;
  for (const auto& [segment, pairs] : segments) {
    estimate[segment] = pairs.estimate;
    reference[segment] = pairs.reference;
  }
  const auto angles = JointAngleSeries(estimate, side);
  const auto true_angles = JointAngleSeries(reference, side);
  std::map<std::string, JointAngleError> errors;
  for (const auto& [name, series] : angles) errors[name] = ErrorOf(series, true_angles.at(name));
  return errors;
}

}  // namespace brachium
