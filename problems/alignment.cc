#include "problems/alignment.h"

#include <Eigen/Cholesky>
#include <Eigen/SVD>
#include <cmath>
#include <numbers>

#include "problems/rotation.h"

namespace brachium {
namespace {

using Eigen::Matrix2d, Eigen::Matrix3d, Eigen::Matrix4d, Eigen::Quaterniond, Eigen::Vector2d,
    Eigen::Vector3d, Eigen::Vector4d;

// Coefficients in Eigen's order x, y, z, w.
Quaterniond Hamilton(const Vector4d& coefficients) {
  return Quaterniond(coefficients.normalized());
}

// Rotations as points q, s of four-space, their signs such that neighbours in time lie close. If
// one series is the other with a constant on either side, both make the same turns, so that the
// signs agree up to one common one.
class ContinuousPairs {
 public:
  explicit ContinuousPairs(const RotationPairs& pairs) {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (!pairs.Known(i)) continue;
      q_.push_back(pairs.estimate[i]);
      s_.push_back(pairs.reference[i]);
      if (q_.size() > 1) {
        MakeClose(q_[q_.size() - 2], &q_.back());
        MakeClose(s_[s_.size() - 2], &s_.back());
      }
    }
  }

  std::size_t size() const { return q_.size(); }
  const Quaterniond& q(std::size_t i) const { return q_[i]; }
  const Quaterniond& s(std::size_t i) const { return s_[i]; }

  // Takes each reference's sign from an alignment instead. Returns whether any changed.
  bool TakeSigns(const RotationAlignment& alignment) {
    bool changed = false;
    for (std::size_t i = 0; i < size(); ++i)
      changed |= MakeClose(alignment.proximal * q_[i] * alignment.distal, &s_[i]);
    return changed;
  }

 private:
  static bool MakeClose(const Quaterniond& to, Quaterniond* q) {
    if (to.dot(*q) >= 0.0) return false;
    q->coeffs() = -q->coeffs();
    return true;
  }

  std::vector<Quaterniond> q_, s_;
};

constexpr int kSignRounds = 5;
constexpr double kTowardsNoTurn = 1e-12;  // weight beside one sample; decides only what is open

// The map q -> a q b is a rotation M of four-space, and each such rotation is one (van Elfrinkhof).
// The best M is the orthogonal Procrustes solution (Schönemann 1966, with determinant +1).
RotationAlignment BestFourRotation(const ContinuousPairs& pairs) {
  Matrix4d C = Matrix4d::Zero();
  for (std::size_t i = 0; i < pairs.size(); ++i)
    C += pairs.s(i).coeffs() * pairs.q(i).coeffs().transpose();
  if (C.trace() < 0.0) C = -C;
  C.diagonal().array() += kTowardsNoTurn * static_cast<double>(pairs.size());
  const Eigen::JacobiSVD<Matrix4d> svd(C, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Vector4d signs = Vector4d::Ones();
  signs(3) = (svd.matrixU() * svd.matrixV().transpose()).determinant() > 0.0 ? 1.0 : -1.0;
  const Matrix4d M = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();

  const Quaterniond ab = Hamilton(M.col(3));  // M 1 = a b;  M e (a b)* = a e a*
  Matrix3d A;
  for (int axis = 0; axis < 3; ++axis) A.col(axis) = (Hamilton(M.col(axis)) * ab.conjugate()).vec();
  const Quaterniond a = Quaterniond(A).normalized();
  return {.proximal = a, .distal = a.conjugate() * ab};
}

// Steps on Σ|Log(s* a q b)|² with a Exp(α), b Exp(β): ∂Log = Jr⁻¹ ((q b)ᵀ α + β). Jr⁻¹ is left out,
// which leaves the gradient as it is (Jr⁻ᵀ φ = φ) and makes steps at most shorter.
RotationAlignment LeastSquaredAngle(const ContinuousPairs& pairs, RotationAlignment alignment) {
  constexpr int kSteps = 30;
  constexpr double kStepDone = 1e-9;
  for (int step = 0; step < kSteps; ++step) {
    Eigen::Matrix<double, 6, 6> H = Eigen::Matrix<double, 6, 6>::Zero();
    Eigen::Matrix<double, 6, 1> g = Eigen::Matrix<double, 6, 1>::Zero();
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const Quaterniond qb = pairs.q(i) * alignment.distal;
      const Matrix3d R = qb.toRotationMatrix();
      const Vector3d phi = Log(Quaterniond(pairs.s(i).conjugate() * alignment.proximal * qb));
      H.topRightCorner<3, 3>() += R;
      g.head<3>() += R * phi;
      g.tail<3>() += phi;
    }
    const auto n = static_cast<double>(pairs.size());
    H.bottomLeftCorner<3, 3>() = H.topRightCorner<3, 3>().transpose();
    H.diagonal().array() += n * (1.0 + 1e-6);  // holds still what a hinge leaves open
    const Eigen::Matrix<double, 6, 1> d = H.ldlt().solve(-g);
    alignment.proximal = (alignment.proximal * Exp(Vector3d(d.head<3>()))).normalized();
    alignment.distal = (alignment.distal * Exp(Vector3d(d.tail<3>()))).normalized();
    if (d.norm() < kStepDone) break;
  }
  return alignment;
}

// Σ s · (Rz q b) = uᵀ Q b with u = (cos, sin) of half the heading and b as coefficients.
using HeadingSums = Eigen::Matrix<double, 2, 4>;

HeadingSums SumsOf(const ContinuousPairs& pairs) {
  const Quaterniond k(0, 0, 0, 1);
  HeadingSums Q = HeadingSums::Zero();
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    Q.row(0) += (pairs.q(i).conjugate() * pairs.s(i)).coeffs().transpose();
    Q.row(1) += ((k * pairs.q(i)).conjugate() * pairs.s(i)).coeffs().transpose();
  }
  return Q;
}

// Half the heading that makes Σ sqrt(uᵀ G u) greatest: the best of a grid, then Newton's steps.
double BestHalfHeading(const std::vector<Matrix2d>& G) {
  constexpr int kGrid = 360, kNewton = 20;
  struct Slope {
    double value = 0.0, first = 0.0, second = 0.0;
  };
  const auto at = [&](double half) {
    const Vector2d u(std::cos(half), std::sin(half)), du(-u.y(), u.x());
    Slope sum;
    for (const Matrix2d& g : G) {
      const double uu = u.dot(g * u), ud = u.dot(g * du), dd = du.dot(g * du), f = std::sqrt(uu);
      if (!(f > 0.0)) continue;
      sum.value += f;
      sum.first += ud / f;
      sum.second += (dd - uu) / f - ud * ud / (uu * f);
    }
    return sum;
  };
  double best = 0.0, greatest = at(0.0).value * (1.0 + 1e-12);  // no turn where all are equal
  for (int i = 1; i < kGrid; ++i) {
    const double half = std::numbers::pi * i / kGrid;
    if (const double value = at(half).value; value > greatest) best = half, greatest = value;
  }
  for (int i = 0; i < kNewton; ++i) {
    const Slope slope = at(best);
    if (!(slope.second < -1e-9 * slope.value)) break;
    best -= slope.first / slope.second;
  }
  return best;
}

}  // namespace

RotationPairs RelativeOf(const RotationPairs& proximal, const RotationPairs& distal) {
  RotationPairs relative;
  for (std::size_t i = 0; i < proximal.size(); ++i) {
    relative.estimate.push_back(proximal.estimate[i].conjugate() * distal.estimate[i]);
    relative.reference.push_back(proximal.reference[i].conjugate() * distal.reference[i]);
  }
  return relative;
}

std::vector<Quaterniond> RotationAlignment::Apply(const std::vector<Quaterniond>& estimate) const {
  std::vector<Quaterniond> aligned;
  aligned.reserve(estimate.size());
  for (const Quaterniond& q : estimate) aligned.push_back(proximal * q * distal);
  return aligned;
}

RotationAlignment AlignBothSides(const RotationPairs& pairs) {
  ContinuousPairs continuous(pairs);
  if (continuous.size() == 0) return {};
  RotationAlignment alignment = BestFourRotation(continuous);
  for (int round = 0; round < kSignRounds && continuous.TakeSigns(alignment); ++round)
    alignment = BestFourRotation(continuous);
  return LeastSquaredAngle(continuous, alignment);
}

std::vector<RotationAlignment> AlignHeading(const std::vector<RotationPairs>& segments,
                                            bool distal_constants) {
  std::vector<ContinuousPairs> continuous(segments.begin(), segments.end());
  std::vector<RotationAlignment> alignments(segments.size());
  bool changed = true;
  for (int round = 0; round < kSignRounds && changed; ++round) {
    std::vector<HeadingSums> Q;
    std::vector<Matrix2d> G;
    for (const ContinuousPairs& pairs : continuous) {
      Q.push_back(SumsOf(pairs));
      if (!distal_constants) Q.back().leftCols<3>().setZero();  // b = ±1
      G.push_back(Q.back() * Q.back().transpose());
    }
    const double half = BestHalfHeading(G);
    changed = false;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      if (continuous[i].size() == 0) continue;
      const Vector4d b = Q[i].transpose() * Vector2d(std::cos(half), std::sin(half));
      alignments[i].distal =
          distal_constants ? Hamilton(b) : Quaterniond(b.w() < 0 ? -1 : 1, 0, 0, 0);
      alignments[i].proximal = Quaterniond(std::cos(half), 0, 0, std::sin(half));
      changed |= continuous[i].TakeSigns(alignments[i]);
    }
  }
  return alignments;
}

double HeadingOf(const Quaterniond& q_VW) { return Log(q_VW).z(); }

Eigen::Matrix3Xd PointAlignment::Apply(const Eigen::Matrix3Xd& estimate) const {
  Eigen::Matrix3Xd aligned = estimate.colwise() + shift;  // a missing height stays its own matter
  aligned.topRows<2>() =
      (Eigen::Rotation2Dd(heading).toRotationMatrix() * estimate.topRows<2>()).colwise() +
      shift.head<2>();
  return aligned;
}

PointAlignment AlignPoints(const std::vector<PointPairs>& points) {
  Vector2d mean_e = Vector2d::Zero(), mean_r = Vector2d::Zero();
  double n = 0.0, n_z = 0.0, rise = 0.0, dot = 0.0, cross = 0.0;
  const auto each = [&points](const auto& visit) {
    for (const PointPairs& p : points)
      for (Eigen::Index i = 0; i < p.estimate.cols(); ++i)
        if (p.estimate.col(i).head<2>().allFinite() && p.reference.col(i).head<2>().allFinite())
          visit(Vector3d(p.estimate.col(i)), Vector3d(p.reference.col(i)));
  };
  each([&](const Vector3d& e, const Vector3d& r) {
    mean_e += e.head<2>();
    mean_r += r.head<2>();
    n += 1.0;
    if (!std::isfinite(r.z() - e.z())) return;
    rise += r.z() - e.z();
    n_z += 1.0;
  });
  if (n == 0.0) return {};
  mean_e /= n;
  mean_r /= n;
  each([&](const Vector3d& e, const Vector3d& r) {
    const Vector2d from = e.head<2>() - mean_e, to = r.head<2>() - mean_r;
    dot += from.dot(to);
    cross += from.x() * to.y() - from.y() * to.x();
  });
  PointAlignment alignment{.heading = std::atan2(cross, dot), .shift = Vector3d::Zero()};
  alignment.shift.head<2>() = mean_r - Eigen::Rotation2Dd(alignment.heading) * mean_e;
  if (n_z > 0.0) alignment.shift.z() = rise / n_z;
  return alignment;
}

}  // namespace brachium
