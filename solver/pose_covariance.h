// How certain the pose is at every knot, and between.
//
// Errors of attitudes are small rotations θ in world axes: q_true = Exp(θ) q. Between knots, with
// a = (t - t_k) / D,
//   P(t) = (1-a)² P_k + a² P_k+1 + a(1-a) (P_k,k+1 + P_k,k+1ᵀ) + a(1-a) D N²/2 I,
// the last the white noise of a gyroscope that is tied down at both ends. Joints are places along the
// chain, p_j = p + Σ R_i d_i; their variances are interpolated straight.
// Source: conditional (bridge) covariance of a Gauss-Markov process, Gelb, Applied Optimal
// Estimation (1974), section 5.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "problems/arm_problem.h"
#include "solver/elimination.h"

namespace brachium {

class PoseCovariance {
 public:
  // The problem and the state must outlive this.
  PoseCovariance(const ArmProblem& problem, const State& state);

  // Takes what it needs from the joint covariance of a front.
  void Collect(int knot, const BlockIndex& index, const CovarianceView& covariance);

  // Of [θ_1; θ_2; ...], by sensor, a fraction in [0, 1] of the way from a knot to the next [rad²].
  Eigen::MatrixXd Attitudes(int knot, double fraction) const;

  // Of the joints of the arm, its root first, each axis of W [m²].
  std::vector<Eigen::Vector3d> Joints(int knot, double fraction) const;

 private:
  using Block = Eigen::Map<const Eigen::MatrixXd>;

  Block At(const std::vector<double>& blocks, int knot) const;
  void CollectAttitudes(int knot, const BlockIndex& index, const CovarianceView& covariance);
  void CollectJoints(int knot, const BlockIndex& index, const CovarianceView& covariance);
  Eigen::Vector3d LengthVariance(int sensor) const;

  const ArmProblem& problem_;
  const State& state_;
  int size_, joints_;
  std::vector<double> here_, across_;             // P_k and P_k,k+1 by knot, one after another
  std::vector<Eigen::Vector3d> joints_variance_;  // by knot, then joint
};

}  // namespace brachium
