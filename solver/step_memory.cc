#include "solver/step_memory.h"

#include <Eigen/Core>
#include <Eigen/SVD>

namespace brachium {
namespace {

constexpr std::size_t kMostMoves = 4;

// Steps that shrink below this share of their squared length by themselves need no memory.
constexpr double kWellShrunk = 0.25;

// Directions that the moves tell apart by less are one.
constexpr double kApart = 1e-6;

auto Vector(const std::vector<double>& numbers) {
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(),
                                           static_cast<Eigen::Index>(numbers.size()));
}

std::vector<double> Difference(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> difference(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) difference[i] = a[i] - b[i];
  return difference;
}

}  // namespace

void StepMemory::Stand(const std::vector<double>& step, const std::vector<double>& gradient,
                       double length_2) {
  const bool slow = !moves_.empty() || length_2 > kWellShrunk * length_2_;
  if (!gone_.empty() && slow)
    moves_.push_back({std::move(gone_), Difference(step, step_), Difference(gradient, gradient_)});
  if (moves_.size() > kMostMoves) moves_.pop_front();
  gone_.clear();
  step_ = step;
  gradient_ = gradient;
  length_2_ = length_2;
}

void StepMemory::Go(const std::vector<double>& step, double share) {
  gone_ = step;
  for (double& d : gone_) d *= share;
}

bool StepMemory::Mix(std::vector<double>& mixed) const {
  if (moves_.empty()) return false;
  const auto n = static_cast<Eigen::Index>(moves_.size());
  Eigen::MatrixXd products(n, n);  // Δfᵀ H Δf
  Eigen::VectorXd with_step(n);    // Δfᵀ H f
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto f = Vector(moves_[static_cast<std::size_t>(i)].f);
    for (Eigen::Index j = 0; j < n; ++j)
      products(i, j) = -f.dot(Vector(moves_[static_cast<std::size_t>(j)].g));
    with_step[i] = -f.dot(Vector(gradient_));
  }
  const Eigen::MatrixXd symmetric = 0.5 * (products + products.transpose());
  Eigen::JacobiSVD<Eigen::MatrixXd> parts(symmetric, Eigen::ComputeThinU | Eigen::ComputeThinV);
  parts.setThreshold(kApart);
  const Eigen::VectorXd gamma = parts.solve(with_step);
  mixed = step_;
  for (Eigen::Index i = 0; i < n; ++i) {
    const Move& move = moves_[static_cast<std::size_t>(i)];
    for (std::size_t k = 0; k < mixed.size(); ++k) mixed[k] -= gamma[i] * (move.x[k] + move.f[k]);
  }
  return true;
}

}  // namespace brachium
