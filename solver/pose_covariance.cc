#include "solver/pose_covariance.h"

#include "problems/rotation.h"

namespace brachium {
namespace {

using Eigen::Matrix3d, Eigen::MatrixXd, Eigen::Quaterniond, Eigen::Vector3d;
using Attitude = Eigen::Map<const Quaterniond>;
using Vector = Eigen::Map<const Vector3d>;

std::size_t U(int i) { return static_cast<std::size_t>(i); }

// What one unknown does to a place: ∂p/∂(its three columns from `offset`).
struct Influence {
  int offset;
  Matrix3d J;
};

Vector3d VarianceOf(const std::vector<Influence>& influences, const CovarianceView& covariance) {
  Vector3d variance = Vector3d::Zero();
  for (const Influence& a : influences)
    for (const Influence& b : influences)
      variance +=
          (a.J * covariance.block<3, 3>(a.offset, b.offset)).cwiseProduct(b.J).rowwise().sum();
  return variance.cwiseMax(0.0);
}

}  // namespace

PoseCovariance::PoseCovariance(const ArmProblem& problem, const State& state)
    : problem_(problem),
      state_(state),
      size_(3 * problem.size().sensors),
      joints_(problem.size().sensors == 1 ? 1 : 1 + problem.size().sensors - problem.FirstOfArm()),
      here_(U(problem.size().knots * size_ * size_), 0.0),
      across_(here_.size(), 0.0),
      joints_variance_(U(problem.size().knots * joints_), Vector3d::Zero()) {}

PoseCovariance::Block PoseCovariance::At(const std::vector<double>& blocks, int knot) const {
  return Block(blocks.data() + U(knot) * U(size_ * size_), size_, size_);
}

void PoseCovariance::Collect(int knot, const BlockIndex& index, const CovarianceView& covariance) {
  CollectAttitudes(knot, index, covariance);
  CollectJoints(knot, index, covariance);
}

void PoseCovariance::CollectAttitudes(int knot, const BlockIndex& index,
                                      const CovarianceView& covariance) {
  const auto world = [&](int k, int sensor) -> Matrix3d {
    return Attitude(state_.Attitude(k, sensor)).toRotationMatrix();
  };
  const auto store = [&](int other, std::vector<double>& blocks) {
    Eigen::Map<MatrixXd> P(blocks.data() + U(knot) * U(size_ * size_), size_, size_);
    for (int a = 0; 3 * a < size_; ++a)
      for (int b = 0; 3 * b < size_; ++b)
        P.block<3, 3>(3 * a, 3 * b) =
            world(knot, a) *
            covariance.block<3, 3>(index.OffsetOf(problem_.Attitude(knot, a)),
                                   index.OffsetOf(problem_.Attitude(other, b))) *
            world(other, b).transpose();
  };
  store(knot, here_);
  if (knot + 1 < problem_.size().knots) store(knot + 1, across_);
}

void PoseCovariance::CollectJoints(int knot, const BlockIndex& index,
                                   const CovarianceView& covariance) {
  Vector3d* variance = &joints_variance_[U(knot * joints_)];
  std::vector<Influence> influences{
      {index.OffsetOf(problem_.Root(knot, problem_.size().roots - 1)), Matrix3d::Identity()}};
  *variance = VarianceOf(influences, covariance);
  const int sensors = problem_.size().sensors;
  for (int sensor = problem_.FirstOfArm(); joints_ > 1 && sensor < sensors; ++sensor) {
    const Matrix3d R_WB = Attitude(state_.Attitude(knot, sensor)).toRotationMatrix();
    const Vector d(state_.Constant(UnknownKind::kJointVector, sensor));
    influences.push_back(
        {index.OffsetOf(problem_.Attitude(knot, sensor)), -R_WB * Skew<double>(d)});
    const int lever = index.OffsetOf(problem_.Constant(UnknownKind::kJointVector, sensor));
    if (lever >= 0) influences.push_back({lever, R_WB});
    *++variance = VarianceOf(influences, covariance);
    if (lever < 0) *variance += LengthVariance(sensor);
  }
}

// Of the end of a segment beyond the last sensor, which no residual speaks of.
Vector3d PoseCovariance::LengthVariance(int sensor) const {
  const Observations& observations = problem_.observations();
  const auto segment = observations.arm.segments.find(observations.recordings[U(sensor)].segment);
  const double sigma = segment == observations.arm.segments.end() ? 0.0 : segment->second.sigma;
  return Vector3d::Constant(sigma * sigma);
}

MatrixXd PoseCovariance::Attitudes(int knot, double fraction) const {
  if (knot + 1 >= problem_.size().knots || fraction <= 0.0) return At(here_, knot);
  const double a = fraction, b = 1 - fraction;
  const Block across = At(across_, knot);
  MatrixXd P =
      b * b * At(here_, knot) + a * a * At(here_, knot + 1) + a * b * (across + across.transpose());
  for (int sensor = 0; 3 * sensor < size_; ++sensor) {
    const double density = problem_.observations().recordings[U(sensor)].noise.gyro_density;
    P.diagonal().segment<3>(3 * sensor).array() +=
        a * b * problem_.Interval(knot, sensor).duration * density * density / 2;
  }
  return P;
}

std::vector<Vector3d> PoseCovariance::Joints(int knot, double fraction) const {
  const auto first = joints_variance_.begin() + knot * joints_;
  std::vector<Vector3d> variance(first, first + joints_);
  if (knot + 1 < problem_.size().knots)
    for (int joint = 0; joint < joints_; ++joint)
      variance[U(joint)] = (1 - fraction) * first[joint] + fraction * first[joints_ + joint];
  return variance;
}

}  // namespace brachium
