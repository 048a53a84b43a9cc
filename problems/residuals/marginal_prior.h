// Marginal prior: what the knots that left a window said about those that stay.
//
//   r = r̄ + J (x ⊟ x̄)        ⊟: Log(R̄ᵀ R) for an attitude, the difference otherwise
//
// Unknowns  the first knot that stays, the bias nodes about it, the constants; any number of blocks.
// Weight    JᵀJ is the Schur complement of the information of all that left, r̄ its gradient; x̄ is
//           where it was linearised and stays so.
// Jacobian  J, with J Jr⁻¹(Log(R̄ᵀ R)) for an attitude.
// Blind to  what the departed residuals were blind to, as long as x stays near x̄.
// Source    Schur complement: Triggs et al., Bundle Adjustment, a Modern Synthesis (2000), section 6.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "problems/residuals/cost.h"

namespace brachium {

class MarginalPrior final : public TangentCost {
 public:
  // `sizes`: of the blocks (4: attitude); `point`: the blocks' values x̄, one after another;
  // `jacobian`, `residual`: J (columns in tangent space) and r̄.
  MarginalPrior(const std::vector<int>& sizes, const Eigen::VectorXd& point,
                const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& residual);

  std::unique_ptr<MarginalPrior> Copy() const;

  // Lets an unknown of one number go a random step of this mean and sd, so that all this speaks of
  // where it came from: its covariance grows by the step's, and no other mean moves. The step's
  // departure from its mean is an unknown that is eliminated by one Householder reflection.
  // Source: time update of the square-root information filter, Bierman, Factorization Methods for
  // Discrete Sequential Estimation (1977), chapter VI.
  void Step(std::size_t block, double mean, double sigma);

  bool Evaluate(const double* const* x, double* r, double** J) const override;
  void EvaluateTangent(const double* const* x, double* r, double* const* J) const override;

 private:
  Eigen::VectorXd Difference(const double* const* x) const;
  // J of block i in the tangent space at x.
  Eigen::MatrixXd TangentJacobian(std::size_t block, const double* x) const;

  std::vector<int> sizes_, ambient_begin_, tangent_begin_;
  Eigen::VectorXd point_;
  Eigen::MatrixXd jacobian_;
  Eigen::VectorXd residual_;
};

}  // namespace brachium
