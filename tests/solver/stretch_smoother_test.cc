#include "solver/stretch_smoother.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "solver/trajectory.h"
#include "solver/window.h"
#include "tests/support/simulated_trial.h"

namespace brachium {
namespace {

// Three minutes, with knots far apart: quick, and two handovers. Every stretch is solved once.
SmootherOptions InStretches() {
  SmootherOptions options;
  options.weight_iterations = 0;
  options.whole_trial = false;
  options.covariance = false;
  options.knot_spacing_s = 0.2;
  return options;
}

double ForearmsClock(const Estimate& estimate) {
  for (const Constant& constant : estimate.diagnostics.constants)
    if (constant.name == "forearm.clock_offset_s") return constant.value[0];
  ADD_FAILURE() << "no clock";
  return NAN;
}

void Append(const Recording& from, double by, Recording& to) {
  for (const double time : from.time) to.time.push_back(time + by);
  to.gyr_S.insert(to.gyr_S.end(), from.gyr_S.begin(), from.gyr_S.end());
  to.acc_S.insert(to.acc_S.end(), from.acc_S.begin(), from.acc_S.end());
}

const Trial& ThreeMinutes() {
  static const Trial trial = Brisk(180);
  return trial;
}

Estimate Smoothed(const Observations& observations, const SmootherOptions& options) {
  return BatchSmoother(options).Run(observations);
}

// The same windows through one problem that holds the whole trial.
Estimate InOneStretch(const Observations& observations, const SmootherOptions& options) {
  ArmProblem problem(observations, options.model, options.knot_spacing_s);
  State state = problem.PriorState();
  problem.HoldMountings(state);
  SolveForward(problem, state, {}, {});
  Estimate estimate;
  estimate.side = observations.arm.side;
  estimate.time = observations.recordings.front().time;
  FillTrajectory(problem, state, estimate);
  return estimate;
}

double FigureOf(const Estimate& estimate, const std::string& name) {
  for (const Figure& figure : estimate.diagnostics.figures)
    if (figure.name == name) return figure.value;
  return -1.0;
}

TEST(SmoothingInStretches, GivesTheMotionThatWindowsOverTheWholeTrialGive) {
  const Estimate stretches = Smoothed(ThreeMinutes().observations, InStretches());
  const Estimate one = InOneStretch(ThreeMinutes().observations, InStretches());
  EXPECT_GT(FigureOf(stretches, "stretches"), 1.0);
  ASSERT_EQ(stretches.time, one.time);
  EXPECT_LT(RmsAngle(ForearmInUpperArm(stretches.q_WB), ForearmInUpperArm(one.q_WB)),
            0.1 * kDegree);
  for (const Segment segment : {Segment::kUpperArm, Segment::kForearm})
    EXPECT_LT(RmsAngle(stretches.q_WB.at(segment), one.q_WB.at(segment)), 0.1 * kDegree);
}

TEST(SmoothingInStretches, WeighsResidualsLikeTheWholeTrial) {
  SmootherOptions options = InStretches();
  const auto error = [&] {
    return RelativeError(Smoothed(ThreeMinutes().observations, options), *ThreeMinutes().reference);
  };
  const double unweighted = error();
  options.weight_iterations = 1;
  const double weighted = error();
  options.whole_trial = true;
  EXPECT_LT(weighted, 1.25 * error());
  EXPECT_LT(weighted, 0.5 * unweighted);
}

TEST(SmoothingInStretches, TellsResidualsAsTheWholeTrialDoes) {
  SmootherOptions options = InStretches();
  const Estimate stretches = Smoothed(ThreeMinutes().observations, options);
  options.whole_trial = true;
  const Estimate whole = Smoothed(ThreeMinutes().observations, options);
  EXPECT_NEAR(FigureOf(stretches, "residual_scale") / FigureOf(whole, "residual_scale"), 1.0, 0.1);
  std::map<std::string, ResidualStatistics> expected;
  for (const ResidualStatistics& kind : whole.diagnostics.residuals) expected[kind.kind] = kind;
  for (const ResidualStatistics& kind : stretches.diagnostics.residuals) {
    if (!kind.kind.starts_with("accelerometer") && !kind.kind.starts_with("segment_chain"))
      continue;
    EXPECT_NEAR(kind.rms / expected[kind.kind].rms, 1.0, 0.15) << kind.kind;
  }
}

TEST(SmoothingInStretches, DoesNotLeapWhereOneStretchHandsOverToTheNext) {
  const Estimate estimate = Smoothed(ThreeMinutes().observations, InStretches());
  const auto truth = ForearmInUpperArm(ThreeMinutes().reference->q_VB);
  const auto found = ForearmInUpperArm(estimate.q_WB);
  std::vector<double> steps;
  for (std::size_t i = 1; i < found.size(); ++i)
    steps.push_back(Log<double>((found[i - 1].conjugate() * found[i]).conjugate() *
                                (truth[i - 1].conjugate() * truth[i]))
                        .norm());
  EXPECT_LT(Worst(steps), 0.05 * kDegree);
}

TEST(SmoothingInStretches, HandsOutEverySampleOnceAndInOrder) {
  Observations observations = ThreeMinutes().observations;
  observations.recordings[1] = Cut(observations.recordings[1], 20.0, 150.0);
  const Estimate estimate = Smoothed(observations, InStretches());
  ASSERT_EQ(estimate.time, observations.recordings[0].time);
  const auto& q_WF = estimate.q_WB.at(Segment::kForearm);
  ASSERT_EQ(q_WF.size(), estimate.time.size());
  for (std::size_t i = 0; i < q_WF.size(); ++i)
    EXPECT_EQ(q_WF[i].coeffs().hasNaN(), estimate.time[i] < 19.996 || estimate.time[i] > 150.0)
        << estimate.time[i];
}

// A source that remembers the most that it ever held.
class Watched final : public SampleSource {
 public:
  Watched(const Recording& recording, std::size_t* most)
      : inner_(std::make_shared<const Recording>(recording)), most_(most) {}
  double First() const override { return inner_.First(); }
  double Last() const override { return inner_.Last(); }

 private:
  bool ReadOn(Recording& held) override {
    *most_ = std::max(*most_, held.size());
    const Recording next = inner_.Between(from_, from_ + 10.0);
    if (next.time.empty() || next.time.back() <= from_) return false;
    for (std::size_t i = 0; i < next.size(); ++i) {
      if (next.time[i] <= from_) continue;
      held.time.push_back(next.time[i]);
      held.gyr_S.push_back(next.gyr_S[i]);
      held.acc_S.push_back(next.acc_S[i]);
    }
    from_ = next.time.back();
    return true;
  }

  HeldSamples inner_;
  std::size_t* most_;
  double from_ = -1.0;
};

std::size_t MostHeld(double duration, std::size_t* largest_piece) {
  Observations part = ThreeMinutes().observations;
  for (Recording& recording : part.recordings) recording = Cut(recording, 0.0, duration);
  std::size_t most = 0;
  StreamedObservations trial = Streamed(part);
  for (std::size_t i = 0; i < part.recordings.size(); ++i)
    trial.samples[i] = std::make_unique<Watched>(part.recordings[i], &most);
  SmoothInStretches(
      trial, InStretches(),
      [&](const Estimate& piece) { *largest_piece = std::max(*largest_piece, piece.time.size()); },
      {});
  return most;
}

TEST(SmoothingInStretches, HoldsNoMoreOfALongerTrial) {
  std::size_t piece = 0, longer_piece = 0;
  const std::size_t held = MostHeld(140.0, &piece);
  EXPECT_LE(MostHeld(180.0, &longer_piece), held + 1000);
  EXPECT_LE(longer_piece, 10000u);
  EXPECT_LT(held, 13000u);
}

// The forearm's clock runs fast by 18 ms over three minutes: no constant offset holds throughout.
TEST(SmoothingInStretches, FollowsAClockThatDrifts) {
  Observations observations = ThreeMinutes().observations;
  constexpr double kFast = 1e-4, kMiddleOfLastStretch = 135.0;
  for (double& time : observations.recordings[1].time) time *= 1.0 + kFast;
  const Estimate estimate = Smoothed(observations, InStretches());
  EXPECT_NEAR(ForearmsClock(estimate), -kFast * kMiddleOfLastStretch, 2e-3);
  EXPECT_LT(RelativeError(estimate, *ThreeMinutes().reference), 1.0 * kDegree);
}

TEST(SmoothingInStretches, SumsAboutAnotherClockOnlyWhereMovementTellsIt) {
  const auto summed_again = [](const std::string& scenario, double offset) {
    SimulationOptions errors;
    errors.clock_offset = offset;
    const Trial trial =
        Simulate(MakeScenario({.name = scenario, .seed = 3, .duration = 45}), errors).trial;
    const Estimate estimate = Smoothed(trial.observations, InStretches());
    EXPECT_GT(std::abs(ForearmsClock(estimate)), 6e-3);
    return FigureOf(estimate, "sums") - FigureOf(estimate, "stretches");
  };
  EXPECT_GT(summed_again("daily_brisk", 0.03), 0.0);
  EXPECT_EQ(summed_again("daily_slow", 0.15), 0.0);
}

// Three minutes of movement, ten of the rest with which they began. What says nothing about a clock
// must not leave it where it was.
TEST(SmoothingInStretches, CarriesAClockOnAtItsRateWhereTheArmRests) {
  Observations observations = ThreeMinutes().observations;
  constexpr double kFast = 5e-5;
  for (Recording& recording : observations.recordings) {
    const Recording rest = Cut(recording, 0.0, 2.5);
    while (recording.time.back() < 780.0)
      Append(rest, recording.time.back() + 0.01 - rest.time.front(), recording);
  }
  for (double& time : observations.recordings[1].time) time *= 1.0 + kFast;
  SmootherOptions options = InStretches();
  options.window_s = 5.0;  // three stretches move, so that there is a rate
  EXPECT_NEAR(ForearmsClock(Smoothed(observations, options)) / (-kFast * 750.0), 1.0, 0.4);
}

TEST(SmoothingInStretches, TellsStandardDeviationsThatHold) {
  SmootherOptions options = InStretches();
  options.covariance = true;
  const Estimate estimate = Smoothed(ThreeMinutes().observations, options);
  const auto found = ForearmInUpperArm(estimate.q_WB);
  const auto truth = ForearmInUpperArm(ThreeMinutes().reference->q_VB);
  const auto& sd = estimate.sd_angle.at("relative_heading");
  ASSERT_EQ(sd.size(), estimate.time.size());
  EXPECT_LT(Rms(Angles(found, truth)), 3 * Rms(sd));
  EXPECT_LT(Worst(sd), 15 * kDegree);
}

TEST(SmoothingInStretches, BridgesAGapLongerThanAStretch) {
  Observations observations = ThreeMinutes().observations;
  for (Recording& recording : observations.recordings) {
    const Recording after = Cut(recording, 100.0, 180.0);
    recording = Cut(recording, 0.0, 99.0);
    Append(after, 200.0, recording);
  }
  const Estimate estimate = Smoothed(observations, InStretches());
  EXPECT_EQ(estimate.time, observations.recordings[0].time);
  for (const auto& [segment, q_WB] : estimate.q_WB)
    for (const auto& q : q_WB) EXPECT_TRUE(q.coeffs().allFinite());
}

// The pieces that are left of it on either side would else be two samples at a usual distance.
TEST(SmoothingInStretches, GoOnAfterASensorWasAwayForLongerThanAStretch) {
  const Trial trial = Brisk(300);
  Observations observations = trial.observations;
  observations.recordings[1] = Without(observations.recordings[1], 60.0, 240.0);
  const Estimate estimate = Smoothed(observations, InStretches());
  const auto found = ForearmInUpperArm(estimate.q_WB),
             truth = ForearmInUpperArm(trial.reference->q_VB);
  const auto late = static_cast<std::ptrdiff_t>(245.0 / 300.0 * static_cast<double>(found.size()));
  EXPECT_LT(RmsAngle({found.begin() + late, found.end()}, {truth.begin() + late, truth.end()}),
            0.5 * kDegree);
}

TEST(SmoothingInStretches, CountsARestAcrossAHandoverOnce) {
  Observations still = ThreeMinutes().observations;
  for (Recording& recording : still.recordings)
    for (std::size_t i = 0; i < recording.size(); ++i) {
      recording.gyr_S[i] = 1e-4 * Eigen::Vector3d::Random();
      recording.acc_S[i] = Eigen::Vector3d(0, kGravity, 0) + 1e-3 * Eigen::Vector3d::Random();
    }
  const Estimate estimate = Smoothed(still, InStretches());
  ASSERT_EQ(estimate.diagnostics.rests.size(), 2u);
  for (const Rest& rest : estimate.diagnostics.rests) EXPECT_GT(rest.end - rest.start, 175.0);
}

TEST(SmoothingInStretches, CannotScaleByResidualsThatAreYetToCome) {
  SmootherOptions options = InStretches();
  options.scale_sd_by_residuals = true;
  std::string why;
  EXPECT_FALSE(options.IsValid(&why));
  EXPECT_THAT(why, testing::HasSubstr("whole_trial"));
}

}  // namespace
}  // namespace brachium
