#include "solver/pose_covariance.h"

#include "problems/rotation.h"

namespace brachium {
namespace {

using Eigen::Matrix3d, Eigen::MatrixXd, Eigen::Quaterniond, Eigen::Vector3d;
using Attitude = Eigen::Map<const Quaterniond>;
using Vector = Eigen::Map<const Vector3d>;

std::size_t U(int i) { return static_cast<std::size_t>(i); }

// What one unknown does to a vector: its derivative by the three columns from `offset`.
struct Influence {
  int offset;
  Matrix3d J;
};
using Influences = std::vector<Influence>;

Matrix3d Covariance(const Influences& rows, const Influences& columns,
                    const CovarianceView& covariance) {
  Matrix3d P = Matrix3d::Zero();
  for (const Influence& a : rows)
    for (const Influence& b : columns)
      P += a.J * covariance.block<3, 3>(a.offset, b.offset) * b.J.transpose();
  return P;
}

Vector3d VarianceOf(const Influences& influences, const CovarianceView& covariance) {
  return Covariance(influences, influences, covariance).diagonal().cwiseMax(0.0);
}

// On θ_B of a sensor's segment: of what the sensor shows and, where these are not certain, of its
// mounting and of the skin.
Influences OnAttitude(const ArmProblem& problem, const State& state, int knot, int sensor,
                      const BlockIndex& index) {
  Influences influences{{index.OffsetOf(problem.Attitude(knot, sensor)),
                         Attitude(state.Attitude(knot, sensor)).toRotationMatrix()}};
  const Vector3d turn =
      Vector(state.Constant(UnknownKind::kMounting, sensor)) + Vector(state.Skin(knot, sensor));
  const Matrix3d back =
      -problem.SegmentAttitude(state, knot, sensor).toRotationMatrix() * RightJacobian(-turn);
  for (const int unknown :
       {problem.Constant(UnknownKind::kMounting, sensor), problem.Skin(knot, sensor)})
    if (const int offset = index.OffsetOf(unknown); offset >= 0)
      influences.push_back({offset, back});
  return influences;
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
  const auto all = [&](int k) {
    std::vector<Influences> influences;
    for (int sensor = 0; sensor < problem_.size().sensors; ++sensor)
      influences.push_back(OnAttitude(problem_, state_, k, sensor, index));
    return influences;
  };
  const std::vector<Influences> here = all(knot);
  const auto store = [&](const std::vector<Influences>& other, std::vector<double>& blocks) {
    Eigen::Map<MatrixXd> P(blocks.data() + U(knot) * U(size_ * size_), size_, size_);
    for (int a = 0; 3 * a < size_; ++a)
      for (int b = 0; 3 * b < size_; ++b)
        P.block<3, 3>(3 * a, 3 * b) = Covariance(here[U(a)], other[U(b)], covariance);
    for (int sensor = 0; 3 * sensor < size_; ++sensor) {
      const double untested = problem_.UntestedMountingSigma(sensor);
      P.diagonal().segment<3>(3 * sensor).array() += untested * untested;
    }
  };
  store(here, here_);
  const bool goes_on = knot + 1 < problem_.size().knots;  // and the covariance tells it
  if (goes_on && index.OffsetOf(problem_.Attitude(knot + 1, 0)) >= 0) store(all(knot + 1), across_);
}

void PoseCovariance::CollectJoints(int knot, const BlockIndex& index,
                                   const CovarianceView& covariance) {
  Vector3d* variance = &joints_variance_[U(knot * joints_)];
  Influences influences{
      {index.OffsetOf(problem_.Root(knot, problem_.size().roots - 1)), Matrix3d::Identity()}};
  *variance = VarianceOf(influences, covariance);
  Vector3d untested = Vector3d::Zero();  // by turns of mountings, which move what lies beyond
  const int sensors = problem_.size().sensors;
  for (int sensor = problem_.FirstOfArm(); joints_ > 1 && sensor < sensors; ++sensor) {
    const Matrix3d R_WB = problem_.SegmentAttitude(state_, knot, sensor).toRotationMatrix();
    const Vector3d d_W = R_WB * Vector(state_.Constant(UnknownKind::kJointVector, sensor));
    for (const Influence& turn : OnAttitude(problem_, state_, knot, sensor, index))
      influences.push_back({turn.offset, -Skew<double>(d_W) * turn.J});
    const int lever = index.OffsetOf(problem_.Constant(UnknownKind::kJointVector, sensor));
    if (lever >= 0) influences.push_back({lever, R_WB});
    const double turned = problem_.UntestedMountingSigma(sensor);
    untested.array() += turned * turned * (d_W.squaredNorm() - d_W.array().square());
    *++variance = VarianceOf(influences, covariance) + untested;
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
    const Preintegrated& interval = problem_.Interval(knot, sensor);
    P.diagonal().segment<3>(3 * sensor).array() +=
        a * b * (interval.duration * density * density / 2 + ArmProblem::GapVariance(interval));
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
