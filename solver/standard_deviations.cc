#include "solver/standard_deviations.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "problems/arm_angles.h"
#include "problems/rotation.h"

namespace brachium {
namespace {

using Eigen::Matrix3d, Eigen::MatrixXd, Eigen::Quaterniond, Eigen::Vector3d;

std::size_t U(int i) { return static_cast<std::size_t>(i); }

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
const std::string kRelativeHeading = "relative_heading";  // forearm against upper arm
constexpr double kNearby = 1e-6;  // [rad], over which gradients of angles are taken

const std::array<Quaterniond, 3> kNudges = {Exp<double>(kNearby * Vector3d::UnitX()),
                                            Exp<double>(kNearby* Vector3d::UnitY()),
                                            Exp<double>(kNearby* Vector3d::UnitZ())};

double StandardDeviation(const ArmAngle& angle, const Quaterniond& q_AB, const Matrix3d& P_B) {
  Vector3d gradient;
  const double here = angle.of(q_AB);
  for (int axis = 0; axis < 3; ++axis) {
    const double there = angle.of(q_AB * kNudges[U(axis)]);
    gradient[axis] = std::remainder(there - here, 2 * std::numbers::pi) / kNearby;
  }
  return std::sqrt(std::max(0.0, gradient.dot(P_B * gradient)));
}

// Of the error of one sensor's attitude against another's, in world axes.
Matrix3d Relative(const MatrixXd& P, int proximal, int distal) {
  const auto block = [&](int a, int b) { return P.block<3, 3>(3 * a, 3 * b); };
  if (proximal < 0) return block(distal, distal);
  return block(distal, distal) + block(proximal, proximal) - block(distal, proximal) -
         block(proximal, distal);
}

std::set<Segment> Known(const Estimate& estimate) {
  std::set<Segment> known;
  for (const auto& [segment, q_WB] : estimate.q_WB) known.insert(segment);
  return known;
}

class Filler {
 public:
  Filler(const ArmProblem& problem, const PoseCovariance& covariance, Estimate& estimate)
      : problem_(problem),
        covariance_(covariance),
        estimate_(estimate),
        angles_(ArmAngles(Known(estimate), estimate.side)) {
    const std::size_t samples = estimate.time.size();
    for (const auto& [segment, q_WB] : estimate.q_WB)
      estimate.sd_B[segment].assign(samples, Vector3d::Constant(kNaN));
    for (const auto& [name, p_W] : estimate.p_W)
      estimate.sd_W[name].assign(samples, Vector3d::Constant(kNaN));
    for (const ArmAngle& angle : angles_) estimate.sd_angle[angle.name].assign(samples, kNaN);
    upper_ = problem.SensorOn(Segment::kUpperArm);
    fore_ = problem.SensorOn(Segment::kForearm);
    if (upper_ >= 0 && fore_ >= 0) estimate.sd_angle[kRelativeHeading].assign(samples, kNaN);
  }

  void Fill(std::size_t sample, int knot, double fraction) {
    const MatrixXd P = covariance_.Attitudes(knot, fraction);
    for (int sensor = 0; sensor < problem_.size().sensors; ++sensor) {
      const Matrix3d R_WB = Attitude(sensor, sample).toRotationMatrix();
      const Matrix3d P_B = R_WB.transpose() * P.block<3, 3>(3 * sensor, 3 * sensor) * R_WB;
      estimate_.sd_B[SegmentOf(sensor)][sample] = P_B.diagonal().cwiseMax(0.0).cwiseSqrt();
    }
    for (const ArmAngle& angle : angles_) FillAngle(angle, P, sample);
    if (upper_ >= 0 && fore_ >= 0)
      estimate_.sd_angle[kRelativeHeading][sample] =
          std::sqrt(std::max(0.0, Relative(P, upper_, fore_)(2, 2)));
    FillPlaces(covariance_.Joints(knot, fraction), sample);
  }

 private:
  Segment SegmentOf(int sensor) const {
    return problem_.observations().recordings[U(sensor)].segment;
  }
  Quaterniond Attitude(int sensor, std::size_t sample) const {
    return sensor < 0 ? Quaterniond::Identity() : estimate_.q_WB.at(SegmentOf(sensor))[sample];
  }

  void FillAngle(const ArmAngle& angle, const MatrixXd& P, std::size_t sample) {
    const int proximal = angle.proximal ? problem_.SensorOn(*angle.proximal) : -1;
    const int distal = problem_.SensorOn(angle.distal);
    const Quaterniond q_WB = Attitude(distal, sample);
    const Matrix3d R_WB = q_WB.toRotationMatrix();
    const Matrix3d P_B = R_WB.transpose() * Relative(P, proximal, distal) * R_WB;
    const Quaterniond q_AB = Attitude(proximal, sample).conjugate() * q_WB;
    estimate_.sd_angle[angle.name][sample] = StandardDeviation(angle, q_AB, P_B);
  }

  // Places in the order in which the chain has them: the root, then each distal joint.
  void FillPlaces(const std::vector<Vector3d>& variances, std::size_t sample) {
    const auto store = [&](const std::string& name, const Vector3d& variance) {
      const auto found = estimate_.sd_W.find(name);
      if (found != estimate_.sd_W.end()) found->second[sample] = variance.cwiseSqrt();
    };
    if (problem_.size().sensors == 1)
      return store(std::string(Name(SegmentOf(0))), variances.front());
    store(std::string(ProximalJointName(SegmentOf(problem_.FirstOfArm()))), variances.front());
    for (std::size_t i = 1; i < variances.size(); ++i)
      store(
          std::string(DistalJointName(SegmentOf(problem_.FirstOfArm() + static_cast<int>(i) - 1))),
          variances[i]);
  }

  const ArmProblem& problem_;
  const PoseCovariance& covariance_;
  Estimate& estimate_;
  std::vector<ArmAngle> angles_;
  int upper_ = -1, fore_ = -1;  // sensors
};

}  // namespace

void FillStandardDeviations(const ArmProblem& problem, const PoseCovariance& covariance,
                            Estimate& estimate) {
  const auto& knots = problem.timeline().knots;
  Filler filler(problem, covariance, estimate);
  int knot = 0;
  for (std::size_t sample = 0; sample < estimate.time.size(); ++sample) {
    const double time = estimate.time[sample];
    if (time < knots.front() || time > knots.back()) continue;
    while (knot + 2 < problem.size().knots && knots[U(knot) + 1] < time) ++knot;
    filler.Fill(sample, knot, (time - knots[U(knot)]) / (knots[U(knot) + 1] - knots[U(knot)]));
  }
}

void ScaleStandardDeviations(double factor, Estimate& estimate) {
  const auto scale = [factor](auto& values) {
    for (auto& value : values) value *= factor;
  };
  for (auto& [name, sd] : estimate.sd_W) scale(sd);
  for (auto& [segment, sd] : estimate.sd_B) scale(sd);
  for (auto& [angle, sd] : estimate.sd_angle) scale(sd);
  for (Constant& constant : estimate.diagnostics.constants) scale(constant.sd);
  for (HeadingSupport& heading : estimate.diagnostics.headings) {
    scale(heading.sd);
    for (auto& [relation, sd] : heading.sd_by) scale(sd);
  }
}

}  // namespace brachium
