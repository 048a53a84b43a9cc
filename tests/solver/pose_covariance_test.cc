#include "solver/pose_covariance.h"

#include <gtest/gtest.h>

#include "problems/joint_angles.h"
#include "problems/rotation.h"
#include "solver/batch_smoother.h"
#include "solver/covariance.h"
#include "solver/window.h"
#include "tests/support/assess_at.h"
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
    AssessAt(problem_, state_, poses_.get());
    all_ = std::make_unique<DenseInformation>(problem_);
    all_->AddTerms(problem_, state_, 0, problem_.size().knots);
    dense_ = SolvedInLongDouble(all_->H, MatrixXd::Identity(all_->H.rows(), all_->H.cols()));
  }

  static Observations Moved() {
    Observations observations = Brisk(16).observations;
    for (Recording& recording : observations.recordings) {
      recording = Cut(recording, 5.0, 8.0);
      recording.mounting->q_sigma = 2 * kDegree;
    }
    observations.start_pose.reset();
    observations.contacts = {
        {.place = "cup", .segment = Segment::kForearm, .times = {5.3, 5.6}, .sigma = 0.1}};
    return observations;
  }

  // Of the joint at the end of that many segments, p = p_root + Σ R_i d_i.
  Vector3d DenseJoint(int knot, int segments) {
    std::vector<std::pair<int, Matrix3d>> moves{{problem_.Root(knot, 0), Matrix3d::Identity()}};
    for (int sensor = 0; sensor < segments; ++sensor) {
      const Matrix3d R = problem_.SegmentAttitude(state_, knot, sensor).toRotationMatrix();
      const Vector3d d = Map<Vector3d>(state_.Constant(UnknownKind::kJointVector, sensor));
      for (const auto& [unknown, J] : TurnsOfSegment(problem_, state_, knot, sensor))
        moves.emplace_back(unknown, -Skew<double>(R * d) * J);
      moves.emplace_back(problem_.Constant(UnknownKind::kJointVector, sensor), R);
    }
    Vector3d variance = Vector3d::Zero();
    for (const auto& [left, J_left] : moves)
      for (const auto& [right, J_right] : moves)
        variance += (J_left * Dense(left, right) * J_right.transpose()).diagonal();
    return variance;
  }
  Matrix3d Dense(int a, int b) { return dense_.block<3, 3>(all_->OffsetOf(a), all_->OffsetOf(b)); }
};

TEST_F(Poses, HaveTheAttitudesOfTheDenseInverse) {
  for (const int knot : {0, 11, problem_.size().knots - 1}) {
    const MatrixXd P = poses_->Attitudes(knot, 0.0);
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b) {
        Matrix3d expected = Matrix3d::Zero();
        for (const auto& [left, J_left] : TurnsOfSegment(problem_, state_, knot, a))
          for (const auto& [right, J_right] : TurnsOfSegment(problem_, state_, knot, b))
            expected += J_left * Dense(left, right) * J_right.transpose();
        EXPECT_LT((P.block<3, 3>(3 * a, 3 * b) - expected).norm(), 1e-7 * expected.norm());
      }
  }
}

TEST_F(Poses, HaveTheElbowOfTheDenseInverse) {
  const Vector3d expected = DenseJoint(11, 1);
  EXPECT_LT((poses_->Joints(11, 0.0)[1] - expected).norm(), 1e-7 * expected.norm());
}

// The length of the forearm, of which nothing but the touches at knots 3 and 6 speaks.
TEST_F(Poses, HaveTheWristOfTheDenseInverseLongAfterItTouched) {
  const Vector3d expected = DenseJoint(21, 2);
  EXPECT_LT((poses_->Joints(21, 0.0)[2] - expected).norm(), 1e-7 * expected.norm());
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

TEST(StandardDeviations, HoldWhatWasToldOfAMountingThatNothingInTheTrialTests) {
  Observations observations = Brisk(16).observations;
  observations.arm.elbow.adduction_constraint = false;
  for (Recording& recording : observations.recordings) recording.mounting->q_sigma = 3 * kDegree;
  const Estimate told = BatchSmoother({}).Run(observations);
  SmootherOptions exactly;
  exactly.model.estimate_mountings = false;
  const Estimate exact = BatchSmoother(exactly).Run(observations);
  const auto variance = [](const Estimate& estimate) {
    return Vector3d(estimate.sd_B.at(Segment::kForearm)[800].cwiseAbs2());
  };
  const Vector3d more = variance(told) - variance(exact);
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(more[axis], std::pow(3 * kDegree, 2), 0.01 * std::pow(3 * kDegree, 2));

  const auto elbow = [](const Estimate& estimate) {
    return estimate.sd_W.at("elbow")[800].squaredNorm();
  };
  const double length = observations.arm.segments.at(Segment::kUpperArm).p_distal_B.norm();
  const double moved = 2 * std::pow(3 * kDegree * length, 2);
  EXPECT_NEAR(elbow(told) - elbow(exact), moved, 0.1 * moved);
}

// Which knots do not part, where the other sensor tells the instants.
TEST(StandardDeviations, GrowWhereTheFirstSegmentsSamplesAreMissing) {
  const Trial trial = Brisk(16);
  Observations observations = trial.observations;
  observations.recordings[0] = Without(observations.recordings[0], 7.5, 8.5);
  std::swap(observations.recordings[0], observations.recordings[1]);
  const Estimate estimate = BatchSmoother({}).Run(observations);
  const auto found = ForearmInUpperArm(estimate.q_WB),
             truth = ForearmInUpperArm(trial.reference->q_VB);
  for (const std::size_t i : {770u, 800u, 830u}) {
    const double error = Log<double>(found[i].conjugate() * truth[i]).norm();
    EXPECT_LT(error, 3 * estimate.sd_B.at(Segment::kUpperArm)[i].norm()) << i;
  }
}

TEST(StandardDeviations, AreScaledByTheResidualsOnDemand) {
  const Observations observations = Brisk(16).observations;
  const Estimate plain = BatchSmoother({}).Run(observations);
  const Estimate scaled =
      BatchSmoother({.scale_sd_by_residuals = true, .model = {}}).Run(observations);
  double factor = 0.0;
  for (const Figure& figure : plain.diagnostics.figures)
    if (figure.name == "residual_scale") factor = figure.value;
  EXPECT_GT(factor, 0.3);
  EXPECT_LT(factor, 1.2);
  EXPECT_NEAR(scaled.sd_angle.at("elbow_flexion")[800],
              factor * plain.sd_angle.at("elbow_flexion")[800], 1e-12);
  EXPECT_NEAR(scaled.sd_W.at("elbow")[800].x(), factor * plain.sd_W.at("elbow")[800].x(), 1e-12);
  EXPECT_NEAR(scaled.diagnostics.constants[0].sd.at(0),
              factor * plain.diagnostics.constants[0].sd.at(0), 1e-12);
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
