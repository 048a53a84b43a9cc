#include "solver/baselines/drift_gains.h"

#include <cmath>

namespace brachium {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kFewestRepetitions = 3;
constexpr Eigen::Index kFewestSamples = 10;
constexpr double kLeastMotion = 1e-9;  // rms of S about its line below which it says nothing [m]

std::vector<Interval> CutInto(const std::vector<Interval>& intervals, int repetitions) {
  const int count = static_cast<int>(intervals.size());
  const int parts = (repetitions + count - 1) / count;
  std::vector<Interval> cut;
  for (const Interval& whole : intervals) {
    const double length = (whole.end - whole.start) / parts;
    for (int i = 0; i < parts; ++i)
      cut.push_back({whole.label, whole.start + i * length, whole.start + (i + 1) * length});
  }
  return cut;
}

// Rows of samples within an interval: times and values.
struct Piece {
  Eigen::VectorXd time;
  Eigen::MatrixX3d A, S;
};

Piece PieceOf(const std::vector<double>& time, const std::vector<Vector3d>& A,
              const std::vector<Vector3d>& S, const Interval& interval) {
  std::vector<std::size_t> inside;
  for (std::size_t i = 0; i < time.size(); ++i)
    if (time[i] >= interval.start && time[i] < interval.end && (A[i] + S[i]).allFinite())
      inside.push_back(i);
  const auto n = static_cast<Eigen::Index>(inside.size());
  Piece piece{Eigen::VectorXd(n), Eigen::MatrixX3d(n, 3), Eigen::MatrixX3d(n, 3)};
  for (Eigen::Index row = 0; row < n; ++row) {
    const std::size_t i = inside[static_cast<std::size_t>(row)];
    piece.time[row] = time[i];
    piece.A.row(row) = A[i];
    piece.S.row(row) = S[i];
  }
  return piece;
}

void TakeOffLine(const Eigen::VectorXd& time, Eigen::MatrixX3d& values) {
  const Eigen::VectorXd t = time.array() - time.mean();
  values.rowwise() -= Eigen::RowVector3d(values.colwise().mean());
  values -= t * Eigen::RowVector3d(t.transpose() * values / t.squaredNorm());
}

// 97.5 % point of Student's t: Abramowitz & Stegun 26.7.5, 3 % too small at two degrees of freedom.
double StudentQuantile(double freedom) {
  const double z = 1.959964, z3 = z * z * z, z5 = z3 * z * z, z7 = z5 * z * z;
  return z + (z3 + z) / (4 * freedom) + (5 * z5 + 16 * z3 + 3 * z) / (96 * freedom * freedom) +
         (3 * z7 + 19 * z5 + 17 * z3 - 15 * z) / (384 * freedom * freedom * freedom);
}

}  // namespace

std::optional<DriftGains> LearnDriftGains(const std::vector<double>& time,
                                          const std::vector<Vector3d>& A,
                                          const std::vector<Vector3d>& S,
                                          const std::vector<Interval>& intervals, int repetitions) {
  if (intervals.empty()) return std::nullopt;
  std::vector<Vector3d> xx, xy;
  double samples = 0.0;
  for (const Interval& interval : CutInto(intervals, repetitions)) {
    Piece piece = PieceOf(time, A, S, interval);
    if (piece.time.size() < kFewestSamples) continue;
    TakeOffLine(piece.time, piece.A);
    TakeOffLine(piece.time, piece.S);
    xx.push_back(piece.S.colwise().squaredNorm());
    xy.push_back(piece.S.cwiseProduct(piece.A).colwise().sum());
    samples += static_cast<double>(piece.time.size());
  }
  if (xx.size() < kFewestRepetitions) return std::nullopt;

  Vector3d sum_xx = Vector3d::Zero(), sum_xy = Vector3d::Zero(), scatter = Vector3d::Zero();
  for (const Vector3d& x : xx) sum_xx += x;
  for (const Vector3d& y : xy) sum_xy += y;
  if (sum_xx.minCoeff() < samples * kLeastMotion * kLeastMotion) return std::nullopt;
  DriftGains gains{.value = sum_xy.cwiseQuotient(sum_xx),
                   .repetitions = static_cast<int>(xx.size())};
  for (std::size_t r = 0; r < xx.size(); ++r)
    scatter += (xy[r] - gains.value.cwiseProduct(xx[r])).cwiseAbs2();
  const double n = static_cast<double>(xx.size());
  gains.sd = (scatter * (n / (n - 1))).cwiseSqrt().cwiseQuotient(sum_xx);
  gains.half_width_95 = StudentQuantile(n - 1) * gains.sd;
  return gains;
}

}  // namespace brachium
