#include "solver/elimination.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>

namespace brachium {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

std::size_t U(int i) { return static_cast<std::size_t>(i); }

// A pivot that loses this many digits against its diagonal is not determined.
constexpr double kSingular = 1e-13;

// Adds one term's JᵀJ and Jᵀr at the places of its unknowns.
class Accumulator {
 public:
  Accumulator(const ArmProblem& problem, State& state) : problem_(problem), state_(state) {}

  void Add(const TangentCost& cost, const std::vector<int>& unknowns,
           const std::vector<int>& offset_of, MatrixXd& H, VectorXd& g) {
    const int rows = cost.num_residuals();
    values_.clear();
    jacobians_.clear();
    sizes_.clear();
    int columns = 0;
    for (const int unknown : unknowns) {
      values_.push_back(problem_.Value(state_, unknown));
      sizes_.push_back(problem_.Describe(unknown).Tangent());
      columns += sizes_.back();
    }
    memory_.resize(U(rows * (columns + 1)));
    double* place = memory_.data() + rows;
    for (const int size : sizes_) {
      jacobians_.push_back(place);
      place += rows * size;
    }
    cost.EvaluateTangent(values_.data(), memory_.data(), jacobians_.data());
    const Eigen::Map<const VectorXd> r(memory_.data(), rows);
    using Block =
        Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
      const Block J_i(jacobians_[i], rows, sizes_[i]);
      const int at_i = offset_of[U(unknowns[i])];
      g.segment(at_i, sizes_[i]).noalias() += J_i.transpose() * r;
      for (std::size_t j = 0; j < unknowns.size(); ++j) {
        const int at_j = offset_of[U(unknowns[j])];
        if (at_j > at_i) continue;  // the lower triangle alone
        const Block J_j(jacobians_[j], rows, sizes_[j]);
        H.block(at_i, at_j, sizes_[i], sizes_[j]).noalias() += J_i.transpose() * J_j;
      }
    }
  }

 private:
  const ArmProblem& problem_;
  State& state_;
  std::vector<const double*> values_;
  std::vector<double*> jacobians_;
  std::vector<int> sizes_;
  std::vector<double> memory_;
};

}  // namespace

int BlockIndex::OffsetOf(int unknown) const {
  const auto found = std::find(unknowns.begin(), unknowns.end(), unknown);
  return found == unknowns.end() ? -1 : offset[U(static_cast<int>(found - unknowns.begin()))];
}

// Whether terms from `end_knot` on touch the unknown.
bool Elimination::IsTouchedFrom(const ArmProblem& problem, int end_knot, int unknown) {
  const int last_interval = problem.timeline().Intervals() - 1;
  if (end_knot > last_interval + 1) return false;
  const Unknown u = problem.Describe(unknown);
  if (u.place < 0) return true;
  if (u.kind != UnknownKind::kGyroBias) return u.place >= end_knot;
  const auto& nodes = problem.timeline().nodes;
  const std::size_t after = std::min(U(u.place) + 1, nodes.size() - 1);
  return nodes[after] > end_knot || (U(u.place) + 1 == nodes.size() && end_knot <= last_interval);
}

Elimination::Elimination(const ArmProblem& problem, State& state, const CarriedPrior& prior,
                         int start_knot, int end_knot, bool keep_fronts, Workspace& workspace) {
  const auto& terms = problem.terms();
  const auto by_knot = [](const Term& term, int knot) { return term.first_knot < knot; };
  const auto begin = std::lower_bound(terms.begin(), terms.end(), start_knot, by_knot);
  const auto end = std::lower_bound(begin, terms.end(), end_knot, by_knot);

  // The last knot whose terms touch an unknown; one that stays is touched for ever.
  auto& last_touch = workspace.last_touch;
  auto& offset_of = workspace.offset_of;
  last_touch.resize(U(problem.unknowns()));
  offset_of.resize(U(problem.unknowns()));
  const auto touch = [&](int unknown, int knot) {
    last_touch[U(unknown)] =
        IsTouchedFrom(problem, end_knot, unknown) ? std::numeric_limits<int>::max() : knot;
  };
  for (const int unknown : prior.unknowns) touch(unknown, start_knot);
  for (auto term = begin; term != end; ++term)
    for (const int unknown : term->unknowns) touch(unknown, term->first_knot);

  Accumulator accumulator(problem, state);
  std::vector<int> carried = prior.unknowns;  // what the last front handed on
  MatrixXd H_carried;
  VectorXd g_carried;
  bool first = true;
  for (auto term = begin; term != end;) {
    Front front;
    front.knot = term->first_knot;
    auto next = term;
    std::vector<int> touched = carried;
    for (; next != end && next->first_knot == front.knot; ++next)
      touched.insert(touched.end(), next->unknowns.begin(), next->unknowns.end());
    std::sort(touched.begin(), touched.end());
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    std::stable_partition(touched.begin(), touched.end(),
                          [&](int unknown) { return last_touch[U(unknown)] <= front.knot; });
    for (const int unknown : touched) {
      offset_of[U(unknown)] = front.index.dimension;
      front.index.offset.push_back(front.index.dimension);
      front.index.dimension += problem.Describe(unknown).Tangent();
      if (last_touch[U(unknown)] <= front.knot) front.eliminated = front.index.dimension;
    }
    front.index.unknowns = std::move(touched);

    MatrixXd H = MatrixXd::Zero(front.index.dimension, front.index.dimension);
    VectorXd g = VectorXd::Zero(front.index.dimension);
    if (first && prior.cost != nullptr)
      accumulator.Add(*prior.cost, prior.unknowns, offset_of, H, g);
    first = false;
    if (H_carried.size() > 0) {
      int from_i = 0;
      for (const int i : carried) {
        const int size_i = problem.Describe(i).Tangent(), at_i = offset_of[U(i)];
        g.segment(at_i, size_i) += g_carried.segment(from_i, size_i);
        int from_j = 0;
        for (const int j : carried) {
          const int size_j = problem.Describe(j).Tangent(), at_j = offset_of[U(j)];
          if (at_j <= at_i)
            H.block(at_i, at_j, size_i, size_j) += H_carried.block(from_i, from_j, size_i, size_j);
          from_j += size_j;
        }
        from_i += size_i;
      }
    }
    for (; term != next; ++term) accumulator.Add(*term->cost, term->unknowns, offset_of, H, g);
    H.triangularView<Eigen::StrictlyUpper>() = H.transpose();
    Eliminate(front, H, g, keep_fronts);

    const int kept = front.index.dimension - front.eliminated;
    H_carried = H.bottomRightCorner(kept, kept);
    g_carried = g.tail(kept);
    carried.clear();
    for (std::size_t i = 0; i < front.index.unknowns.size(); ++i)
      if (front.index.offset[i] >= front.eliminated) carried.push_back(front.index.unknowns[i]);
    if (keep_fronts) fronts_.push_back(std::move(front));
  }
  kept_.unknowns = carried;
  for (const int unknown : carried) {
    kept_.offset.push_back(kept_.dimension);
    kept_.dimension += problem.Describe(unknown).Tangent();
  }
  H_ = std::move(H_carried);
  g_ = std::move(g_carried);
}

void Elimination::Eliminate(Front& front, MatrixXd& H, VectorXd& g, bool keep) {
  const int e = front.eliminated, s = front.index.dimension - e;
  if (e == 0) return;
  const VectorXd diagonal = H.diagonal().head(e);
  Eigen::LLT<MatrixXd> llt(H.topLeftCorner(e, e));
  const bool positive =
      llt.info() == Eigen::Success &&
      (MatrixXd(llt.matrixL()).diagonal().array().square() > kSingular * diagonal.array()).all();
  if (!positive) {
    for (std::size_t i = 0; i < front.index.unknowns.size(); ++i)
      if (front.index.offset[i] < e) singular_.push_back(front.index.unknowns[i]);
    MatrixXd regular = H.topLeftCorner(e, e);
    regular.diagonal().array() += 1e-9 * diagonal.array().max(1e-9);
    llt.compute(regular);
  }
  MatrixXd A(e, s);
  if (s > 0) A = llt.solve(H.topRightCorner(e, s));
  H.bottomRightCorner(s, s).noalias() -= H.bottomLeftCorner(s, e) * A;
  g.tail(s).noalias() -= A.transpose() * g.head(e);
  if (!keep) return;
  front.H_EE_inverse = llt.solve(MatrixXd::Identity(e, e));
  front.A = A;
}

CarriedPrior Elimination::Carry(const ArmProblem& problem, State& state) const {
  // H = V diag(λ) Vᵀ: J = diag(sqrt λ) Vᵀ and r̄ = diag(1/sqrt λ) Vᵀ g on the informed directions.
  // Scaled to a unit diagonal first, since the unknowns' units differ by many orders of magnitude.
  const VectorXd scale = H_.diagonal().cwiseMax(1e-30).cwiseSqrt();
  const MatrixXd symmetric = 0.5 * (H_ + H_.transpose());
  const MatrixXd scaled =
      scale.cwiseInverse().asDiagonal() * symmetric * scale.cwiseInverse().asDiagonal();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(scaled);
  const VectorXd lambda = eigen.eigenvalues().cwiseMax(0.0);
  const double least = 1e-14 * lambda.maxCoeff();
  const VectorXd root = lambda.cwiseSqrt();
  const VectorXd inverse_root =
      (lambda.array() > least).select(root.cwiseInverse(), VectorXd::Zero(root.size()));
  const MatrixXd J = root.asDiagonal() * eigen.eigenvectors().transpose() * scale.asDiagonal();
  const VectorXd r = inverse_root.asDiagonal() * eigen.eigenvectors().transpose() *
                     scale.cwiseInverse().asDiagonal() * g_;
  std::vector<int> sizes;
  std::vector<double> point;
  for (const int unknown : kept_.unknowns) {
    sizes.push_back(problem.Describe(unknown).Size());
    const double* x = problem.Value(state, unknown);
    point.insert(point.end(), x, x + sizes.back());
  }
  const Eigen::Map<const VectorXd> point_vector(point.data(),
                                                static_cast<Eigen::Index>(point.size()));
  return {std::make_unique<MarginalPrior>(sizes, point_vector, J, r), kept_.unknowns};
}

void Elimination::VisitCovariances(const Visitor& visit) const {
  MatrixXd next;  // covariance of the front after this one
  const BlockIndex* next_index = nullptr;
  for (auto front = fronts_.rbegin(); front != fronts_.rend(); ++front) {
    const int n = front->index.dimension, e = front->eliminated, s = n - e;
    MatrixXd covariance(n, n);
    for (std::size_t i = 0; i < front->index.unknowns.size(); ++i) {
      const int at_i = front->index.offset[i];
      if (at_i < e) continue;
      const int end_i = i + 1 < front->index.offset.size() ? front->index.offset[i + 1] : n;
      const int from_i = next_index->OffsetOf(front->index.unknowns[i]);
      for (std::size_t j = 0; j < front->index.unknowns.size(); ++j) {
        const int at_j = front->index.offset[j];
        if (at_j < e) continue;
        const int end_j = j + 1 < front->index.offset.size() ? front->index.offset[j + 1] : n;
        const int from_j = next_index->OffsetOf(front->index.unknowns[j]);
        covariance.block(at_i, at_j, end_i - at_i, end_j - at_j) =
            next.block(from_i, from_j, end_i - at_i, end_j - at_j);
      }
    }
    if (e > 0) {
      const auto S = covariance.bottomRightCorner(s, s);
      const MatrixXd AS = front->A * S;
      covariance.topRightCorner(e, s) = -AS;
      covariance.bottomLeftCorner(s, e) = -AS.transpose();
      covariance.topLeftCorner(e, e) = front->H_EE_inverse + AS * front->A.transpose();
    }
    visit(front->knot, front->index, covariance);
    next = std::move(covariance);
    next_index = &front->index;
  }
}

}  // namespace brachium
