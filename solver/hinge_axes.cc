#include "solver/hinge_axes.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "problems/arm_model.h"
#include "problems/statistics.h"

namespace brachium {
namespace {

using Eigen::Matrix3d, Eigen::Vector3d;
using Vector9d = Eigen::Matrix<double, 9, 1>;
using Matrix9d = Eigen::Matrix<double, 9, 9>;

constexpr double kUsualAdduction = 8 * kDegree;  // rms on people: Luinge et al. (2007)
constexpr double kCorrelationTime = 1.0;         // [s]
constexpr int kStarts = 200;
constexpr int kSweeps = 400;
constexpr int kReweightings = 5;
constexpr int kDescents = 20;
constexpr double kHuber = 1.5;
constexpr double kOneSigma = 0.68;
constexpr double kLeastTurn = 2 * kDegree;
constexpr double kSameAxis = 5 * kDegree;

Vector9d Entries(const Matrix3d& R_AB) {
  Vector9d entries;
  for (int a = 0; a < 3; ++a) entries.segment<3>(3 * a) = R_AB.row(a).transpose();
  return entries;
}

Vector9d Product(const Vector3d& j1, const Vector3d& j2) { return Entries(j1 * j2.transpose()); }

// Moments of the entries over all instants.
struct Moments {
  Vector9d mean = Vector9d::Zero();
  Matrix9d scatter = Matrix9d::Zero();  // about the mean
};

Moments MomentsOf(const std::vector<Vector9d>& entries, const std::vector<double>& weights) {
  Moments moments;
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
  return moments;
}

// mᵀ K m with what anatomy says of the axes but for the sign of β; `variance` is that of the mean of e.
Matrix9d WithAnatomy(const Moments& moments, const HingeAnatomy& anatomy, double variance) {
  const Vector3d &l = anatomy.to_shoulder_A, &u = anatomy.to_elbow_B;
  const Matrix3d off_u = Matrix3d::Identity() - u * u.transpose();
  Matrix9d K = moments.mean * moments.mean.transpose() /
               (anatomy.beta_sd * anatomy.beta_sd + anatomy.beta * anatomy.beta);
  for (int a = 0; a < 3; ++a) {
    K.block<3, 3>(3 * a, 3 * a) += off_u / (anatomy.to_elbow_sd * anatomy.to_elbow_sd);
    for (int b = 0; b < 3; ++b)
      K.block<3, 3>(3 * a, 3 * b) +=
          l[a] * l[b] / (anatomy.to_shoulder_sd * anatomy.to_shoulder_sd) * Matrix3d::Identity();
  }
  return moments.scatter + variance * K;
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

// About the weighted mean, by the spread of all, which weights cannot shrink.
std::vector<double> HuberWeights(const std::vector<Vector9d>& entries, const Moments& moments,
                                 const Pair& pair) {
  const Vector9d m = Product(pair.j1, pair.j2);
  std::vector<double> apart;
  for (const Vector9d& r : entries) apart.push_back(std::abs(m.dot(r - moments.mean)));
  const double most = kHuber * std::max(Quantile(apart, kOneSigma), kUsualAdduction);
  std::vector<double> weights;
  for (const double e : apart) weights.push_back(e > most ? most / e : 1.0);
  return weights;
}

// The instants between which the elbow has moved: a rest counts once, however long it is.
std::vector<Vector9d> MovingEntries(const std::vector<Matrix3d>& R_AB) {
  std::vector<Vector9d> moving;
  for (const Matrix3d& R : R_AB) {
    const Vector9d entries = Entries(R);
    if (moving.empty() || (entries - moving.back()).norm() > std::sqrt(2.0) * kLeastTurn)
      moving.push_back(entries);
  }
  return moving;
}

double RmsOf(const Moments& moments, const Pair& pair) {
  const Vector9d m = Product(pair.j1, pair.j2);
  return std::sqrt(m.dot(moments.scatter * m));
}

void SetSigns(const std::vector<Matrix3d>& R_AB, const HingeAnatomy& anatomy, Pair& pair) {
  if (pair.j2.dot(anatomy.to_elbow_B) < 0) pair.j2 = -pair.j2;
  double bending = 0.0;
  for (const Matrix3d& R : R_AB) bending += pair.j1.dot(anatomy.to_shoulder_A.cross(R * pair.j2));
  if (bending < 0) pair.j1 = -pair.j1;
}

// Two directions at right angles to an axis and to one another.
Eigen::Matrix<double, 3, 2> Across(const Vector3d& axis) {
  Eigen::Matrix<double, 3, 2> across;
  across.col(0) = axis.unitOrthogonal();
  across.col(1) = axis.cross(across.col(0));
  return across;
}

// The last descent, whose unknowns are the turns of j1 and j2 along Across(); gives the covariance.
Eigen::Matrix4d Refine(const Moments& moments, const HingeAnatomy& anatomy, double variance,
                       Pair& pair) {
  const Vector3d &l = anatomy.to_shoulder_A, &u = anatomy.to_elbow_B;
  Eigen::Matrix4d H;
  for (int i = 0; i < kDescents; ++i) {
    const auto across1 = Across(pair.j1), across2 = Across(pair.j2);
    Eigen::Matrix<double, 9, 4> J;
    for (int k = 0; k < 2; ++k) {
      J.col(k) = Product(across1.col(k), pair.j2);
      J.col(2 + k) = Product(pair.j1, across2.col(k));
    }
    const Vector9d m = Product(pair.j1, pair.j2);
    H = J.transpose() * moments.scatter * J / variance;
    Eigen::Vector4d g = J.transpose() * moments.scatter * m / variance;
    const auto add = [&](double r, const Eigen::Vector4d& dr, double sd) {
      H += dr * dr.transpose() / (sd * sd);
      g += dr * r / (sd * sd);
    };
    add(moments.mean.dot(m) - std::sin(anatomy.beta), J.transpose() * moments.mean,
        anatomy.beta_sd);
    Eigen::Vector4d dr = Eigen::Vector4d::Zero();
    dr.head<2>() = across1.transpose() * l;
    add(l.dot(pair.j1), dr, anatomy.to_shoulder_sd);
    for (const Vector3d& v :
         {Vector3d(u.unitOrthogonal()), Vector3d(u.cross(u.unitOrthogonal()))}) {
      dr.setZero();
      dr.tail<2>() = across2.transpose() * v;
      add(v.dot(pair.j2), dr, anatomy.to_elbow_sd);
    }
    const Eigen::Vector4d step = -H.ldlt().solve(g);
    pair.j1 = (pair.j1 + across1 * step.head<2>()).normalized();
    pair.j2 = (pair.j2 + across2 * step.tail<2>()).normalized();
  }
  return H.inverse();
}

double LargestSd(const Eigen::Matrix2d& P) {
  return std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(P).eigenvalues()[1]);
}

}  // namespace

HingeAxes FindHingeAxes(const std::vector<Matrix3d>& R_AB, double period,
                        const HingeAnatomy& anatomy) {
  const std::vector<Vector9d> entries = MovingEntries(R_AB);
  const double count = static_cast<double>(entries.size()) * period / (2 * kCorrelationTime);
  double variance = kUsualAdduction * kUsualAdduction / count;
  Moments moments = MomentsOf(entries, std::vector<double>(entries.size(), 1.0));
  auto [pair, next] = Search(WithAnatomy(moments, anatomy, variance));
  const double next_misfit = std::sqrt(next);
  for (int i = 0; i < kReweightings; ++i) {
    moments = MomentsOf(entries, HuberWeights(entries, moments, pair));
    pair = Descend(WithAnatomy(moments, anatomy, variance), pair.j1, kSweeps);
  }
  SetSigns(R_AB, anatomy, pair);
  const double sigma = std::max(RmsOf(moments, pair), kUsualAdduction);
  variance = sigma * sigma / count;
  const Eigen::Matrix4d P = Refine(moments, anatomy, variance, pair);
  return {.j1_A = pair.j1,
          .j2_B = pair.j2,
          .j1_sd = LargestSd(P.topLeftCorner<2, 2>()),
          .j2_sd = LargestSd(P.bottomRightCorner<2, 2>()),
          .misfit = RmsOf(moments, pair),
          .next_misfit = next_misfit};
}

}  // namespace brachium
