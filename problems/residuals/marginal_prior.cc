#include "problems/residuals/marginal_prior.h"

#include <cmath>

namespace brachium {
namespace {

using Quaternion = Eigen::Map<const Eigen::Quaterniond>;

}  // namespace

MarginalPrior::MarginalPrior(const std::vector<int>& sizes, const Eigen::VectorXd& point,
                             const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& residual)
    : sizes_(sizes), point_(point), jacobian_(jacobian), residual_(residual) {
  int ambient = 0, tangent = 0;
  for (const int size : sizes_) {
    ambient_begin_.push_back(ambient);
    tangent_begin_.push_back(tangent);
    ambient += size;
    tangent += TangentSize(size);
  }
  set_num_residuals(static_cast<int>(residual.size()));
  *mutable_parameter_block_sizes() = sizes_;
}

std::unique_ptr<MarginalPrior> MarginalPrior::Copy() const {
  return std::make_unique<MarginalPrior>(sizes_, point_, jacobian_, residual_);
}

// The step s enters as [-J e; 1/sigma] s. The reflection turns that column onto its last row, which
// then is all that knows of s.
void MarginalPrior::Step(std::size_t block, double mean, double sigma) {
  point_[ambient_begin_[block]] += mean;
  const Eigen::VectorXd v = -jacobian_.col(tangent_begin_[block]);
  const double last = 1 / sigma + std::sqrt(v.squaredNorm() + 1 / (sigma * sigma));
  const double factor = 2 / (v.squaredNorm() + last * last);
  residual_ -= factor * v.dot(residual_) * v;
  jacobian_ -= factor * v * (v.transpose() * jacobian_).eval();
}

Eigen::VectorXd MarginalPrior::Difference(const double* const* x) const {
  Eigen::VectorXd difference(jacobian_.cols());
  for (std::size_t i = 0; i < sizes_.size(); ++i) {
    const double* point = point_.data() + ambient_begin_[i];
    const int begin = tangent_begin_[i];
    if (sizes_[i] == 4)
      difference.segment<3>(begin) = Log<double>(Quaternion(point).conjugate() * Quaternion(x[i]));
    else
      for (int j = 0; j < sizes_[i]; ++j) difference[begin + j] = x[i][j] - point[j];
  }
  return difference;
}

Eigen::MatrixXd MarginalPrior::TangentJacobian(std::size_t block, const double* x) const {
  const auto J = jacobian_.middleCols(tangent_begin_[block], TangentSize(sizes_[block]));
  if (sizes_[block] != 4) return J;
  const double* point = point_.data() + ambient_begin_[block];
  return J * InverseRightJacobian(Log<double>(Quaternion(point).conjugate() * Quaternion(x)));
}

void MarginalPrior::EvaluateTangent(const double* const* x, double* r, double* const* J) const {
  const auto rows = residual_.size();
  Eigen::Map<Eigen::VectorXd>{r, rows} = residual_ + jacobian_ * Difference(x);
  using Block = Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;
  for (std::size_t i = 0; i < sizes_.size(); ++i)
    Block(J[i], rows, TangentSize(sizes_[i])) = TangentJacobian(i, x[i]);
}

bool MarginalPrior::Evaluate(const double* const* x, double* r, double** J) const {
  const auto rows = residual_.size();
  Eigen::Map<Eigen::VectorXd>{r, rows} = residual_ + jacobian_ * Difference(x);
  if (J == nullptr) return true;
  using Block = Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;
  for (std::size_t i = 0; i < sizes_.size(); ++i) {
    if (J[i] == nullptr) continue;
    if (sizes_[i] == 4) {
      RowMajor<3, 4> minus;
      RotationManifold().MinusJacobian(x[i], minus.data());
      Block(J[i], rows, 4) = TangentJacobian(i, x[i]) * minus;
    } else {
      Block(J[i], rows, sizes_[i]) = TangentJacobian(i, x[i]);
    }
  }
  return true;
}

}  // namespace brachium
