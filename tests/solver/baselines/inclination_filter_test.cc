#include "solver/baselines/inclination_filter.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "solver/baselines/instants.h"
#include "tests/support/hinged_arm.h"
#include "tests/support/simulated_trial.h"

namespace brachium {
namespace {

using Eigen::Matrix3d, Eigen::Quaterniond, Eigen::Vector3d;

constexpr AccelerationModel kModel{2.0, 3.0};

class Filtering : public testing::Test {
 protected:
  Tracks tracks_ = StartTracks(HingedArm({}).observations);
  Track& fore_ = tracks_.segments[1];

  // Of the attitude's error in W [rad²].
  static Matrix3d CovarianceInWorld(const FilterState<1>& state) {
    const Matrix3d R = state.q_WB[0].toRotationMatrix();
    return R * state.P.topLeftCorner<3, 3>() * R.transpose();
  }

  static FilterState<1>::Vector Carried(const ErrorTransition<1>& F,
                                        const FilterState<1>::Vector& error) {
    const Eigen::Matrix<double, 1, 6> row = error.transpose();
    return F.TransposedAfter(row).transpose();
  }

  InclinationFilter<1> Filtered(double until) {
    InclinationFilter<1> filter({&fore_}, kModel, tracks_.start);
    const std::vector<double>& times = fore_.recording.time;
    for (std::size_t i = 0; i < times.size() && times[i] < until; ++i) {
      filter.Predict(times[i]);
      filter.Measure(0, i);
    }
    return filter;
  }
};

TEST_F(Filtering, TurnsAWrongInclinationTowardsTheVertical) {
  const Quaterniond q_true = fore_.q_WB;
  const Quaterniond q_tilt = Exp<double>(Vector3d(0.1, -0.1, 0.0));
  fore_.q_WB = q_tilt * q_true;
  fore_.inclination_sigma = 0.1;
  const InclinationFilter<1> filter = Filtered(20);
  const HingedArmOptions arm;
  const Quaterniond q = filter.state().q_WB[0];
  const Quaterniond truth = HingedForearm(arm, filter.state().time).turning.q_AB;
  const Vector3d up = q.conjugate() * Vector3d::UnitZ(),
                 up_true = truth.conjugate() * Vector3d::UnitZ();
  EXPECT_LT(std::acos(up.dot(up_true)), 5 * kDegree);  // 8 deg at first, and slow: see the header
}

TEST_F(Filtering, LearnsNothingOfTheHeading) {
  fore_.heading_sigma = 0.3;
  fore_.gyro_bias_sigma = 0.0;
  const Matrix3d before = CovarianceInWorld(Filtered(0.0).state());
  const Matrix3d after = CovarianceInWorld(Filtered(20.0).state());
  EXPECT_GE(after(2, 2), before(2, 2) - 1e-9);
  EXPECT_LT(after(0, 0), before(0, 0));
  EXPECT_LT(after(1, 1), before(1, 1));
}

TEST_F(Filtering, KeepsItsCovarianceSymmetricAndPositive) {
  const FilterState<1> state = Filtered(30.0).state();
  EXPECT_LT((state.P - state.P.transpose()).cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_GT(state.P.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff(), 0.0);
}

TEST_F(Filtering, PredictsErrorsAsTheyReallyGrow) {
  const InclinationFilter<1>::Members members{&fore_};
  const FilterState<1> from = Filtered(1.0).state();
  FilterState<1> end = from;
  const auto F = InclinationFilter<1>::Predict(members, 1.4, end);
  for (int i = 0; i < 6; ++i) {
    const FilterState<1>::Vector error = 1e-6 * FilterState<1>::Vector::Unit(i);
    FilterState<1> wrong = from;
    wrong.Add(error);
    InclinationFilter<1>::Predict(members, 1.4, wrong);
    EXPECT_LT((wrong.Minus(end) - Carried(F, error)).norm(), 1e-10) << i;
  }
}

TEST_F(Filtering, GrowsLessCertainAcrossAGap) {
  const auto heading_variance_at_2s = [](Observations observations) {
    const Tracks tracks = StartTracks(observations);
    InclinationFilter<1> filter({&tracks.segments[1]}, kModel, tracks.start);
    filter.Predict(2.0);
    return CovarianceInWorld(filter.state())(2, 2);
  };
  Observations observations = HingedArm({}).observations;
  const double whole = heading_variance_at_2s(observations);
  Lose(observations.recordings[1], 100, 50);
  EXPECT_GT(heading_variance_at_2s(observations), whole + 0.01);
}

TEST(Instants, TakeEverySampleOnceInOrderOfTime) {
  Observations observations = HingedArm({.q_WU = kFlexionAxisVertical, .duration = 2}).observations;
  for (double& t : observations.recordings[1].time) t += 0.003;
  Lose(observations.recordings[1], 20, 7);
  const Tracks tracks = StartTracks(observations);
  const auto instants = MergeInstants<2>(tracks, {&tracks.segments[1], &tracks.segments[0]});
  double last = -1.0;
  std::array<int, 3> count{};
  for (const auto& instant : instants) {
    EXPECT_GT(instant.time, last);
    last = instant.time;
    EXPECT_EQ(instant.samples[1], instant.output);  // the upper arm is the first recording
    const std::array<int, 3> taken{instant.samples[0], instant.samples[1], instant.output};
    for (std::size_t i = 0; i < 3; ++i) count[i] += taken[i] != kNoSample;
    if (instant.samples[0] != kNoSample) {
      EXPECT_EQ(instant.time,
                observations.recordings[1].time[static_cast<std::size_t>(instant.samples[0])]);
    }
  }
  EXPECT_EQ(count[0], 193);
  EXPECT_EQ(count[1], 200);
}

TEST(Instants, ShareSamplesOfOneTime) {
  const Tracks tracks =
      StartTracks(HingedArm({.q_WU = kFlexionAxisVertical, .duration = 2}).observations);
  const auto instants = MergeInstants<2>(tracks, {&tracks.segments[1], &tracks.segments[0]});
  EXPECT_EQ(instants.size(), 200u);
}

}  // namespace
}  // namespace brachium
