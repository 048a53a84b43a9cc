#include "solver/hinge_axes.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "problems/arm_model.h"

namespace brachium {
namespace {

using Eigen::Matrix3d, Eigen::Vector3d;
using Vector9d = Eigen::Matrix<double, 9, 1>;
using Matrix9d = Eigen::Matrix<double, 9, 9>;

constexpr double kBetaSigma = 12 * kDegree;
constexpr double kLeastAdduction = 2 * kDegree;
constexpr double kCorrelationTime = 1.5;  // [s]
constexpr int kStarts = 200;
constexpr int kSweeps = 400;
constexpr int kReweightings = 5;
constexpr double kHuber = 1.5;  // of the rms
constexpr double kSameAxis = 5 * kDegree;

Vector9d Entries(const Matrix3d& R_AB) {
  Vector9d entries;
  for (int a = 0; a < 3; ++a) entries.segment<3>(3 * a) = R_AB.row(a).transpose();
  return entries;
}

Vector9d Product(const Vector3d& j1, const Vector3d& j2) { return Entries(j1 * j2.transpose()); }

// Moments of the entries over all instants.
struct Moments {
  Vector9d mean;
  Matrix9d scatter;  // about the mean
  Matrix9d K;
};

Moments MomentsOf(const std::vector<Vector9d>& entries, const std::vector<double>& weights) {
  Moments moments{Vector9d::Zero(), Matrix9d::Zero(), Matrix9d::Zero()};
  double sum = 0.0;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    moments.mean += weights[i] * entries[i];
    sum += weights[i];
  }
  moments.mean /= sum;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const Vector9d apart = entries[i] - moments.mean;
    moments.scatter += weights[i] / sum * apart * apart.transpose();
  }
  const double nu = kLeastAdduction * kLeastAdduction / (kBetaSigma * kBetaSigma);
  moments.K = moments.scatter + nu * moments.mean * moments.mean.transpose();
  return moments;
}

Vector3d LeastEigenvector(const Matrix3d& A) {
  return Eigen::SelfAdjointEigenSolver<Matrix3d>(A).eigenvectors().col(0);
}

struct Pair {
  Vector3d j1, j2;
  double cost;
};

Vector3d BestSecond(const Matrix9d& K, const Vector3d& j1) {
  Eigen::Matrix<double, 9, 3> with = Eigen::Matrix<double, 9, 3>::Zero();
  for (int a = 0; a < 3; ++a) with.block<3, 3>(3 * a, 0) = j1[a] * Matrix3d::Identity();
  return LeastEigenvector(with.transpose() * K * with);
}

Vector3d BestFirst(const Matrix9d& K, const Vector3d& j2) {
  Eigen::Matrix<double, 9, 3> with = Eigen::Matrix<double, 9, 3>::Zero();
  for (int a = 0; a < 3; ++a) with.block<3, 1>(3 * a, a) = j2;
  return LeastEigenvector(with.transpose() * K * with);
}

Pair Descend(const Matrix9d& K, Vector3d j1, int sweeps) {
  Vector3d j2 = BestSecond(K, j1);
  for (int i = 0; i < sweeps; ++i) {
    const Vector3d before = j1;
    j1 = BestFirst(K, j2);
    j2 = BestSecond(K, j1);
    if (std::abs(before.dot(j1)) > 1 - 1e-15) break;
  }
  const Vector9d m = Product(j1, j2);
  return {j1, j2, m.dot(K * m)};
}

// Directions evenly over half a sphere.
Vector3d Direction(int i) {
  const double z = (i + 0.5) / kStarts, turn = i * std::numbers::pi * (3 - std::sqrt(5.0));
  const double across = std::sqrt(1 - z * z);
  return {across * std::cos(turn), across * std::sin(turn), z};
}

bool IsSameAxis(const Vector3d& a, const Vector3d& b) {
  return std::abs(a.dot(b)) > std::cos(kSameAxis);
}

// The best pair and the cost of the next one.
std::pair<Pair, double> Search(const Matrix9d& K) {
  std::vector<Pair> pairs;
  for (int i = 0; i < kStarts; ++i) pairs.push_back(Descend(K, Direction(i), kSweeps));
  const auto cheaper = [](const Pair& a, const Pair& b) { return a.cost < b.cost; };
  const Pair best = *std::min_element(pairs.begin(), pairs.end(), cheaper);
  double next = std::numeric_limits<double>::infinity();
  for (const Pair& pair : pairs)
    if (!IsSameAxis(pair.j1, best.j1) || !IsSameAxis(pair.j2, best.j2))
      next = std::min(next, pair.cost);
  return {best, next};
}

std::vector<double> HuberWeights(const std::vector<Vector9d>& entries, const Moments& moments,
                                 const Pair& pair) {
  const Vector9d m = Product(pair.j1, pair.j2);
  const double scale = std::max(std::sqrt(m.dot(moments.scatter * m)), 1e-9);
  std::vector<double> weights;
  for (const Vector9d& r : entries) {
    const double e = std::abs(m.dot(r - moments.mean)) / scale;
    weights.push_back(e > kHuber ? kHuber / e : 1.0);
  }
  return weights;
}

// Sds from the information of the motion about both axes and what is known of β.
void SetSds(const Moments& moments, double span, HingeAxes& axes) {
  Eigen::Matrix<double, 9, 4> J;
  const Vector3d across1 = axes.j1_A.unitOrthogonal(), across2 = axes.j2_B.unitOrthogonal();
  J.col(0) = Product(across1, axes.j2_B);
  J.col(1) = Product(axes.j1_A.cross(across1), axes.j2_B);
  J.col(2) = Product(axes.j1_A, across2);
  J.col(3) = Product(axes.j1_A, axes.j2_B.cross(across2));
  const double sigma = std::max(axes.misfit, kLeastAdduction);
  const double count = span / (2 * kCorrelationTime);
  const Eigen::Vector4d mean = J.transpose() * moments.mean;
  const Eigen::Matrix4d information =
      count / (sigma * sigma) * J.transpose() * moments.scatter * J +
      mean * mean.transpose() / (kBetaSigma * kBetaSigma) + Eigen::Matrix4d::Identity();
  const Eigen::Matrix4d P = information.inverse();
  const auto largest = [](const Eigen::Matrix2d& block) {
    return std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(block).eigenvalues()[1]);
  };
  axes.j1_sd = largest(P.topLeftCorner<2, 2>());
  axes.j2_sd = largest(P.bottomRightCorner<2, 2>());
}

}  // namespace

HingeAxes FindHingeAxes(const std::vector<Matrix3d>& R_AB, double period) {
  std::vector<Vector9d> entries;
  for (const Matrix3d& R : R_AB) entries.push_back(Entries(R));
  std::vector<double> weights(entries.size(), 1.0);
  Moments moments = MomentsOf(entries, weights);
  auto [pair, next] = Search(moments.K);
  for (int i = 0; i < kReweightings; ++i) {
    weights = HuberWeights(entries, moments, pair);
    moments = MomentsOf(entries, weights);
    pair = Descend(moments.K, pair.j1, kSweeps);
  }
  HingeAxes axes{.j1_A = pair.j1, .j2_B = pair.j2};
  const Vector9d m = Product(pair.j1, pair.j2);
  axes.misfit = std::sqrt(m.dot(moments.scatter * m));
  axes.next_misfit = std::sqrt(next);
  SetSds(moments, static_cast<double>(R_AB.size()) * period, axes);
  return axes;
}

}  // namespace brachium
