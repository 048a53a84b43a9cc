#include "solver/pose_covariance.h"

#include <gtest/gtest.h>

#include "problems/joint_angles.h"
#include "problems/rotation.h"
#include "solver/batch_smoother.h"
#include "solver/covariance.h"
#include "solver/window.h"
#include "tests/support/dense_information.h"
#include "tests/support/simulated_trial.h"

namespace brachium {
namespace {

using Eigen::Map, Eigen::Matrix3d, Eigen::MatrixXd, Eigen::Quaterniond, Eigen::Vector3d;

// A few seconds of movement, solved, and what the dense inverse says of them.
class Poses : public testing::Test {
 protected:
  ArmProblem problem_{Moved(), {}, 0.1};
  State state_ = problem_.PriorState();
  std::unique_ptr<PoseCovariance> poses_;
  MatrixXd dense_;
  std::unique_ptr<DenseInformation> all_;

  void SetUp() override {
    SolveForward(problem_, state_, {}, {});
    Solve(problem_, state_, {}, 0, problem_.timeline().Intervals(), {});
    poses_ = std::make_unique<PoseCovariance>(problem_, state_);
    AssessCertainty(problem_, state_, nullptr, poses_.get());
    all_ = std::make_unique<DenseInformation>(problem_);
    all_->AddTerms(problem_, state_, 0, problem_.size().knots);
    dense_ = SolvedInLongDouble(all_->H, MatrixXd::Identity(all_->H.rows(), all_->H.cols()));
  }

  static Observations Moved() {
    Observations observations = Brisk(16).observations;
    for (Recording& recording : observations.recordings) recording = Cut(recording, 5.0, 8.0);
    observations.start_pose.reset();
    return observations;
  }

  Matrix3d Turn(int knot, int sensor) {
    return Map<Quaterniond>(state_.Attitude(knot, sensor)).toRotationMatrix();
  }
  Matrix3d Dense(int a, int b) { return dense_.block<3, 3>(all_->OffsetOf(a), all_->OffsetOf(b)); }
};

TEST_F(Poses, HaveTheAttitudesOfTheDenseInverse) {
  for (const int knot : {0, 11, problem_.size().knots - 1}) {
    const MatrixXd P = poses_->Attitudes(knot, 0.0);
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b) {
        const Matrix3d expected = Turn(knot, a) *
                                  Dense(problem_.Attitude(knot, a), problem_.Attitude(knot, b)) *
                                  Turn(knot, b).transpose();
        EXPECT_LT((P.block<3, 3>(3 * a, 3 * b) - expected).norm(), 1e-7 * expected.norm());
      }
  }
}

// p = p_root + R_U d: by finite steps of all unknowns that it depends on.
TEST_F(Poses, HaveTheElbowOfTheDenseInverse) {
  const int knot = 11, root = problem_.Root(knot, 0), q = problem_.Attitude(knot, 0),
            lever = problem_.Constant(UnknownKind::kJointVector, 0);
  const Matrix3d R = Turn(knot, 0);
  const Vector3d d = Map<Vector3d>(state_.Constant(UnknownKind::kJointVector, 0));
  Eigen::Matrix<double, 3, 9> J;
  J << Matrix3d::Identity(), -R * Skew<double>(d), R;
  Eigen::Matrix<double, 9, 9> P;
  const int unknowns[] = {root, q, lever};
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) P.block<3, 3>(3 * a, 3 * b) = Dense(unknowns[a], unknowns[b]);
  const Vector3d expected = (J * P * J.transpose()).diagonal();
  EXPECT_LT((poses_->Joints(knot, 0.0)[1] - expected).norm(), 1e-7 * expected.norm());
}

TEST_F(Poses, AreNoMoreCertainBetweenKnotsThanTheGyroscopeAllows) {
  const int knot = 11;
  const double density = problem_.observations().recordings[0].noise.gyro_density;
  const MatrixXd here = poses_->Attitudes(knot, 0.0), next = poses_->Attitudes(knot, 1.0),
                 between = poses_->Attitudes(knot, 0.5);
  EXPECT_LT((next - poses_->Attitudes(knot + 1, 0.0)).norm(), 1e-12 * next.norm());
  const double least = 0.25 * 0.1 * density * density / 2;  // of the bridge alone
  for (int i = 0; i < 6; ++i) {
    EXPECT_GT(between(i, i), least);
    EXPECT_LT(between(i, i), std::max(here(i, i), next(i, i)) + 1.01 * least);
  }
}

TEST(StandardDeviations, HardlyDependOnTheKnotSpacing) {
  const Observations observations = Brisk(16).observations;
  const auto smoothed = [&](double spacing) {
    return BatchSmoother({.knot_spacing_s = spacing, .weight_iterations = 0, .model = {}})
        .Run(observations);
  };
  const Estimate coarse = smoothed(0.1), fine = smoothed(0.05);
  for (const char* angle : {"elbow_flexion", "forearm_pronation", "relative_heading"})
    for (std::size_t i = 200; i < 1400; i += 37)
      EXPECT_NEAR(coarse.sd_angle.at(angle)[i] / fine.sd_angle.at(angle)[i], 1.0, 0.05)
          << angle << " " << i;
}

TEST(StandardDeviations, AreOfTheSizeOfTheErrors) {
  const Trial trial = Brisk(30);
  const Estimate estimate = BatchSmoother({}).Run(trial.observations);
  const auto q_UF = ForearmInUpperArm(estimate.q_WB),
             truth = ForearmInUpperArm(trial.reference->q_VB);
  double squares = 0.0;
  for (std::size_t i = 0; i < q_UF.size(); ++i) {
    const double error = ElbowAnglesFrom(q_UF[i], Side::kRight).flexion -
                         ElbowAnglesFrom(truth[i], Side::kRight).flexion;
    squares += std::pow(error / estimate.sd_angle.at("elbow_flexion")[i], 2);
  }
  const double rms = std::sqrt(squares / static_cast<double>(q_UF.size()));
  EXPECT_GT(rms, 0.05);  // these sensors have no scale errors, for which the model allows
  EXPECT_LT(rms, 3.0);
}

TEST(StandardDeviations, AreLeftOutOnDemand) {
  const Estimate estimate =
      BatchSmoother({.covariance = false, .model = {}}).Run(Brisk(16).observations);
  EXPECT_TRUE(estimate.sd_B.empty());
  EXPECT_TRUE(estimate.sd_W.empty());
  EXPECT_TRUE(estimate.sd_angle.empty());
  for (const Constant& constant : estimate.diagnostics.constants)
    EXPECT_TRUE(constant.sd.empty()) << constant.name;
}

}  // namespace
}  // namespace brachium
