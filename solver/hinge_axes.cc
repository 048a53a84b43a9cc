#include "solver/hinge_axes.h"

#include <ceres/ceres.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

namespace brachium {
namespace {

using Eigen::Matrix3d, Eigen::Vector3d;

constexpr double kUsualAdduction = 5 * kDegree;  // rms
constexpr double kUsualCount = 4.0;              // residuals that this size counts for
constexpr double kUsualMemory = 10.0;            // residuals that count as one, to begin with
constexpr double kLeastTurn = 2 * kDegree;
constexpr int kStarts = 8;
constexpr int kWeightings = 3;

struct Unknowns {
  Vector3d j1, j2;
  Eigen::Vector2d carrying;  // k0, k1
};

struct Weight {
  double sigma = kUsualAdduction;
  double memory = kUsualMemory;  // m
};

// The elbow's departure from its hinge [rad], and how much of a turn of the upper arm's sensor about
// y_U it takes for departure.
template <typename T>
struct Departure {
  T angle, gain;
};

struct Adduction {
  Matrix3d R_AB;
  Vector3d to_shoulder_A;
  double s;

  template <typename T>
  Departure<T> Of(const T* j1_data, const T* j2_data, const T* carrying) const {
    const Eigen::Map<const Eigen::Vector3<T>> j1(j1_data), j2(j2_data);
    const Eigen::Vector3<T> y_F = R_AB.cast<T>() * j2;
    const Eigen::Vector3<T> l = to_shoulder_A.cast<T>();
    const Eigen::Vector3<T> y_U = (l - l.dot(j1) * j1).normalized();
    const T k = carrying[0] + carrying[1] * y_U.dot(y_F);
    return {(j1.dot(y_F) + s * sin(k)) / cos(k), j1.dot(y_U.cross(y_F))};
  }

  template <typename T>
  bool operator()(const T* j1, const T* j2, const T* carrying, T* r) const {
    const Departure<T> departure = Of(j1, j2, carrying);
    r[0] = departure.angle / sqrt(1.0 + departure.gain * departure.gain);
    return true;
  }
};

struct SquareTo {
  Vector3d direction;
  double sigma;

  template <typename T>
  bool operator()(const T* axis, T* r) const {
    r[0] = Eigen::Map<const Eigen::Vector3<T>>(axis).dot(direction.cast<T>()) / sigma;
    return true;
  }
};

struct Along {
  Vector3d direction;
  double sigma;

  template <typename T>
  bool operator()(const T* axis, T* r) const {
    const Eigen::Map<const Eigen::Vector3<T>> j(axis);
    Eigen::Map<Eigen::Vector3<T>> across(r);
    across = j.cross(direction.cast<T>()) / T(sigma);
    return true;
  }
};

struct Carrying {
  ElbowModel elbow;

  template <typename T>
  bool operator()(const T* carrying, T* r) const {
    r[0] = (carrying[0] - elbow.carrying_angle) / elbow.carrying_angle_sigma;
    r[1] = carrying[1] / elbow.carrying_slope_sigma;
    return true;
  }
};

// The least-squares problem about one set of unknowns.
class HingeProblem {
 public:
  HingeProblem(const std::vector<Matrix3d>& R_AB, const HingeAnatomy& anatomy, const Weight& weight,
               Unknowns& x)
      : x_(x) {
    const double share = 1 / (weight.sigma * weight.sigma * weight.memory);
    for (const Matrix3d& R : R_AB)
      problem_.AddResidualBlock(new ceres::AutoDiffCostFunction<Adduction, 1, 3, 3, 2>(
                                    new Adduction{R, anatomy.to_shoulder_A, Sign(anatomy.side)}),
                                new ceres::ScaledLoss(nullptr, share, ceres::TAKE_OWNERSHIP),
                                x.j1.data(), x.j2.data(), x.carrying.data());
    problem_.AddResidualBlock(new ceres::AutoDiffCostFunction<SquareTo, 1, 3>(
                                  new SquareTo{anatomy.to_shoulder_A, anatomy.to_shoulder_sd}),
                              nullptr, x.j1.data());
    problem_.AddResidualBlock(new ceres::AutoDiffCostFunction<Along, 3, 3>(
                                  new Along{anatomy.to_elbow_B, anatomy.to_elbow_sd}),
                              nullptr, x.j2.data());
    problem_.AddResidualBlock(
        new ceres::AutoDiffCostFunction<Carrying, 2, 2>(new Carrying{anatomy.elbow}), nullptr,
        x.carrying.data());
    problem_.SetManifold(x.j1.data(), new ceres::SphereManifold<3>);
    problem_.SetManifold(x.j2.data(), new ceres::SphereManifold<3>);
  }

  // Returns the cost.
  double Solve() {
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
    options.function_tolerance = 1e-10;
    options.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem_, &summary);
    return summary.final_cost;
  }

  // In the order of the instants; not divided by the weight.
  std::vector<double> Residuals(std::size_t count) {
    ceres::Problem::EvaluateOptions options;
    options.apply_loss_function = false;
    std::vector<double> residuals;
    problem_.Evaluate(options, nullptr, &residuals, nullptr, nullptr);
    residuals.resize(count);  // those of anatomy come last
    return residuals;
  }

  void SetCovariance(HingeAxes& axes) {
    ceres::Covariance::Options options;
    options.algorithm_type = ceres::DENSE_SVD;
    ceres::Covariance covariance(options);
    const double *j1 = x_.j1.data(), *j2 = x_.j2.data();
    covariance.Compute({{j1, j1}, {j2, j2}}, &problem_);
    covariance.GetCovarianceBlock(j1, j1, axes.j1_covariance.data());
    covariance.GetCovarianceBlock(j2, j2, axes.j2_covariance.data());
  }

 private:
  Unknowns& x_;
  ceres::Problem problem_;
};

// The instants between which the elbow has moved. |R - R'| of a turn by φ is 2 √2 sin(φ/2).
std::vector<Matrix3d> Moving(const std::vector<Matrix3d>& R_AB) {
  std::vector<Matrix3d> moving;
  for (const Matrix3d& R : R_AB)
    if (moving.empty() || (R - moving.back()).norm() > std::sqrt(2.0) * kLeastTurn)
      moving.push_back(R);
  return moving;
}

bool Bends(const std::vector<Matrix3d>& R_AB, const HingeAnatomy& anatomy, const Unknowns& x) {
  double bending = 0.0;
  for (const Matrix3d& R : R_AB) bending += x.j1.dot(anatomy.to_shoulder_A.cross(R * x.j2));
  return bending > 0;
}

// The cheapest minimum that bends; where none does, the cheapest.
Unknowns Search(const std::vector<Matrix3d>& R_AB, const HingeAnatomy& anatomy) {
  const Vector3d& l = anatomy.to_shoulder_A;
  Unknowns best;
  std::pair least(true, std::numeric_limits<double>::infinity());
  for (int i = 0; i < kStarts; ++i) {
    const Eigen::AngleAxisd turn(2 * std::numbers::pi * i / kStarts, l);
    Unknowns x{.j1 = turn * l.unitOrthogonal(),
               .j2 = anatomy.to_elbow_B,
               .carrying = {anatomy.elbow.carrying_angle, 0.0}};
    const double cost = HingeProblem(R_AB, anatomy, Weight{}, x).Solve();
    const std::pair here(!Bends(R_AB, anatomy, x), cost);
    if (here >= least) continue;
    best = x;
    least = here;
  }
  return best;
}

// m = 1 + 2 Σ ρ_n until ρ crosses zero.
double MemoryOf(const std::vector<double>& r) {
  const double square = std::inner_product(r.begin(), r.end(), r.begin(), 0.0);
  double memory = 1.0;
  for (std::size_t n = 1; n < r.size(); ++n) {
    const auto shift = static_cast<std::ptrdiff_t>(n);
    const double rho = std::inner_product(r.begin() + shift, r.end(), r.begin(), 0.0) / square;
    if (!(rho > 0.0)) break;
    memory += 2 * rho;
  }
  return memory;
}

Weight WeightFrom(const std::vector<double>& r) {
  const double memory = MemoryOf(r);
  const double square = std::inner_product(r.begin(), r.end(), r.begin(), 0.0) / memory;
  const double count = static_cast<double>(r.size()) / memory;
  const double usual = kUsualCount * kUsualAdduction * kUsualAdduction;
  return {.sigma = std::sqrt((square + usual) / (count + kUsualCount)), .memory = memory};
}

double RmsDeparture(const std::vector<Matrix3d>& R_AB, const HingeAnatomy& anatomy,
                    const Unknowns& x) {
  double square = 0.0;
  for (const Matrix3d& R : R_AB) {
    const Adduction adduction{R, anatomy.to_shoulder_A, Sign(anatomy.side)};
    const double angle = adduction.Of(x.j1.data(), x.j2.data(), x.carrying.data()).angle;
    square += angle * angle;
  }
  return std::sqrt(square / static_cast<double>(R_AB.size()));
}

}  // namespace

HingeAxes FindHingeAxes(const std::vector<Matrix3d>& R_AB, const HingeAnatomy& anatomy) {
  const std::vector<Matrix3d> moving = Moving(R_AB);
  Unknowns x = Search(moving, anatomy);
  Weight weight;
  for (int i = 0; i < kWeightings; ++i) {
    HingeProblem problem(moving, anatomy, weight, x);
    problem.Solve();
    weight = WeightFrom(problem.Residuals(moving.size()));
  }
  HingeProblem problem(moving, anatomy, weight, x);
  problem.Solve();
  HingeAxes axes;
  problem.SetCovariance(axes);
  axes.j1_A = x.j1;
  axes.j2_B = x.j2;
  axes.misfit = RmsDeparture(moving, anatomy, x);
  return axes;
}

}  // namespace brachium
