// The covariance along the chain against two that know nothing of chains.
#include <ceres/ceres.h>
#include <gtest/gtest.h>

#include "problems/rotation.h"
#include "problems/rotation_manifold.h"
#include "solver/covariance.h"
#include "solver/window.h"
#include "tests/support/assess_at.h"
#include "tests/support/dense_information.h"
#include "tests/support/simulated_trial.h"

namespace brachium {
namespace {

using Eigen::Matrix3d, Eigen::MatrixXd, Eigen::VectorXd;

Observations Moving(double end) {
  Observations observations = Brisk(20).observations;
  for (Recording& recording : observations.recordings) {
    recording = Cut(recording, 5.0, end);
    recording.mounting->q_sigma = 2 * kDegree;
  }
  return observations;
}

// A solved stretch of movement with its covariance.
struct Assessed {
  ArmProblem problem;
  State state;
  PoseCovariance poses;
  Certainty certainty;

  explicit Assessed(const Observations& observations)
      : problem(observations, {}, 0.1), state(problem.PriorState()), poses(Solved(), state) {
    certainty = AssessAt(problem, state, &poses);
  }

  // Of two segments' errors at a knot in world axes, from what `expected` says of the unknowns.
  template <typename Expected>
  Matrix3d OfSegments(int knot, int a, int b, const Expected& expected) const {
    Matrix3d P = Matrix3d::Zero();
    for (const auto& [left, J_left] : TurnsOfSegment(problem, state, knot, a))
      for (const auto& [right, J_right] : TurnsOfSegment(problem, state, knot, b))
        P += J_left * expected(left, right) * J_right.transpose();
    return P;
  }

 private:
  const ArmProblem& Solved() {
    SolveForward(problem, state, {}, {});
    Solve(problem, state, {}, 0, problem.timeline().Intervals(), {});
    return problem;
  }
};

// The largest relative difference of the attitudes at some knots, of any constant and of any gyro
// bias from what `expected` says of two unknowns' covariance.
template <typename Expected>
double WorstDifference(Assessed& assessed, const std::vector<int>& knots,
                       const Expected& expected) {
  double worst = 0.0;
  for (const int knot : knots) {
    const MatrixXd P = assessed.poses.Attitudes(knot, 0.0);
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b) {
        const Matrix3d block = assessed.OfSegments(knot, a, b, expected);
        worst = std::max(worst, (P.block<3, 3>(3 * a, 3 * b) - block).norm() / block.norm());
      }
  }
  for (const auto& [unknown, sd] : assessed.certainty.constant_sd) {
    const VectorXd other = expected(unknown, unknown).diagonal().cwiseSqrt();
    worst = std::max(worst, (sd - other).norm() / other.norm());
  }
  return worst;
}

// Rounding of the information itself, 1e-16 of its diagonal, grows in any inverse by as much as an
// unknown is less certain alone than with all others known: nearly two million times in variance with these
// sensors, a thousand times with sensors a hundred times as noisy.
TEST(ExactCovariance, IsTheDenseInverse) {
  Observations observations = Moving(7.0);
  for (Recording& recording : observations.recordings) {
    recording.noise.gyro_density *= 100;
    recording.noise.gyro_bias_walk *= 100;
    recording.noise.accel_density *= 100;
  }
  Assessed assessed(observations);
  const ArmProblem& problem = assessed.problem;
  DenseInformation all(problem);
  all.AddTerms(problem, assessed.state, 0, problem.size().knots);
  const MatrixXd dense = SolvedInLongDouble(all.H, MatrixXd::Identity(all.H.rows(), all.H.cols()));
  const auto expected = [&](int a, int b) -> MatrixXd {
    return dense.block(all.OffsetOf(a), all.OffsetOf(b), problem.Describe(a).Tangent(),
                       problem.Describe(b).Tangent());
  };
  EXPECT_LT(WorstDifference(assessed, {0, 7, problem.size().knots - 1}, expected), 1e-9);
}

// A whole problem as Ceres sees it, and what it says of a few unknowns.
class ByCeres {
 public:
  ByCeres(Assessed& assessed, const std::vector<int>& knots)
      : assessed_(assessed), least_squares_(OwnedElsewhere()), covariance_(BySparseQr()) {
    const ArmProblem& problem = assessed.problem;
    for (const Term& term : problem.terms()) {
      std::vector<double*> values;
      for (const int unknown : term.unknowns) values.push_back(ValueOf(unknown));
      least_squares_.AddResidualBlock(term.cost.get(), term.loss.get(), values);
      for (std::size_t i = 0; i < values.size(); ++i) {
        const Unknown unknown = problem.Describe(term.unknowns[i]);
        if (unknown.kind == UnknownKind::kAttitude)
          least_squares_.SetManifold(values[i], &rotation_);
        if (unknown.held) least_squares_.SetParameterBlockConstant(values[i]);
      }
    }
    std::vector<std::pair<const double*, const double*>> pairs;
    for (const int knot : knots) {
      const int asked[] = {problem.Attitude(knot, 0), problem.Attitude(knot, 1),
                           problem.Constant(UnknownKind::kMounting, 0),
                           problem.Constant(UnknownKind::kMounting, 1)};
      for (int a = 0; a < 4; ++a)
        for (int b = a; b < 4; ++b)
          if (knot == knots.front() || a < 2)
            pairs.emplace_back(ValueOf(asked[a]), ValueOf(asked[b]));
    }
    for (const auto& [unknown, sd] : assessed.certainty.constant_sd)
      if (problem.Describe(unknown).kind != UnknownKind::kMounting)
        pairs.emplace_back(ValueOf(unknown), ValueOf(unknown));
    is_known_ = covariance_.Compute(pairs, &least_squares_);
  }

  bool is_known() const { return is_known_; }

  MatrixXd Block(int a, int b) {
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> block(
        assessed_.problem.Describe(a).Tangent(), assessed_.problem.Describe(b).Tangent());
    if (!covariance_.GetCovarianceBlockInTangentSpace(ValueOf(a), ValueOf(b), block.data()))
      ADD_FAILURE() << "not computed: " << a << ", " << b;
    return block;
  }

 private:
  double* ValueOf(int unknown) { return assessed_.problem.Value(assessed_.state, unknown); }
  static ceres::Problem::Options OwnedElsewhere() {
    ceres::Problem::Options options;
    options.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    options.manifold_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    return options;
  }
  static ceres::Covariance::Options BySparseQr() {
    ceres::Covariance::Options options;
    options.algorithm_type = ceres::SPARSE_QR;
    return options;
  }

  Assessed& assessed_;
  RotationManifold rotation_;
  ceres::Problem least_squares_;
  ceres::Covariance covariance_;
  bool is_known_ = false;
};

TEST(ExactCovariance, IsThatOfCeresOverTwelveSeconds) {
  Assessed assessed(Moving(17.0));
  const std::vector<int> knots = {0, 31, 60, 97, assessed.problem.size().knots - 1};
  ByCeres ceres(assessed, knots);
  ASSERT_TRUE(ceres.is_known());
  EXPECT_LT(WorstDifference(assessed, knots, [&](int a, int b) { return ceres.Block(a, b); }),
            1e-6);
}

}  // namespace
}  // namespace brachium
