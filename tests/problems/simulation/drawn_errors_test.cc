#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "problems/rotation.h"
#include "problems/simulation/simulate.h"
#include "tests/support/scenarios.h"

namespace brachium {
namespace {

using Eigen::Vector3d;

constexpr int kSeeds = 300;

SimulationOptions Drawn() {
  SimulationOptions options = HonestErrors(MtwNoise());
  options.draw_sizes = true;
  options.rate = 5.0;
  options.sampling_jitter = options.stamp_error = options.lost_share = 0.0;
  options.soft_tissue = {};
  return options;
}

ScenarioOptions DrawnElbow(int seed) {
  return {.name = "static_pose",
          .seed = static_cast<std::uint64_t>(seed),
          .duration = 6.0,
          .carrying_angle = 10 * kDegree,
          .carrying_angle_sd = 6 * kDegree,
          .carrying_slope = 0.0,
          .carrying_slope_sd = 4 * kDegree,
          .exact_rms = false};
}

// Mean square over trials of what `error` finds in a trial, over its components.
double MeanSquare(const std::function<Eigen::VectorXd(const SimulatedTrial&)>& error) {
  double squares = 0.0;
  Eigen::Index count = 0;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    SimulationOptions options = Drawn();
    options.seed = static_cast<std::uint64_t>(seed);
    const Eigen::VectorXd e = error(Simulate(MakeScenario(DrawnElbow(seed)), options));
    squares += e.squaredNorm();
    count += e.size();
  }
  return squares / static_cast<double>(count);
}

// The rms of so many draws lies within 4 sds of its own about the sigma.
void ExpectSigma(double sigma, int components,
                 const std::function<Eigen::VectorXd(const SimulatedTrial&)>& error) {
  const double tolerance = 4.0 / std::sqrt(2.0 * kSeeds * components);
  EXPECT_NEAR(std::sqrt(MeanSquare(error)) / sigma, 1.0, tolerance);
}

Eigen::VectorXd Value(const SimulatedTrial& simulated, const std::string& name) {
  const std::vector<double>& v = simulated.True(name);
  return Eigen::Map<const Eigen::VectorXd>(v.data(), static_cast<Eigen::Index>(v.size()));
}

const Recording& Forearm(const SimulatedTrial& simulated) {
  return simulated.trial.observations.recordings.at(1);
}

TEST(DrawnErrors, HaveTheSigmasThatTheTrialStates) {
  const SimulatedTrial one = Simulate(MakeScenario(DrawnElbow(1)), Drawn());
  const Observations& told = one.trial.observations;
  const Mounting& mounting = *Forearm(one).mounting;
  EXPECT_EQ(mounting.p_sigma, 0.015);
  EXPECT_EQ(mounting.q_sigma, 3 * kDegree);
  EXPECT_EQ(told.start_pose->sigma, 5 * kDegree);
  EXPECT_EQ(told.arm.elbow.carrying_angle, 10 * kDegree);
  ExpectSigma(mounting.p_sigma, 3, [](const SimulatedTrial& s) {
    return Eigen::VectorXd(Forearm(s).mounting->p_BS_B - Value(s, "forearm.p_BS_m").head<3>());
  });
  ExpectSigma(mounting.q_sigma / kDegree, 3,
              [](const SimulatedTrial& s) { return Value(s, "forearm.told_q_BS_error_deg"); });
  ExpectSigma(told.arm.segments.at(Segment::kForearm).sigma, 1, [](const SimulatedTrial& s) {
    const double length = s.trial.observations.arm.segments.at(Segment::kForearm).p_distal_B.norm();
    return Eigen::VectorXd(Value(s, "forearm.length_m").array() - length);
  });
  ExpectSigma(Forearm(one).noise.gyro_bias_sigma, 3,
              [](const SimulatedTrial& s) { return Value(s, "forearm.gyro_bias"); });
  ExpectSigma(Forearm(one).noise.accel_bias_sigma, 3,
              [](const SimulatedTrial& s) { return Value(s, "forearm.accelerometer_bias"); });
  ExpectSigma(0.005, 1, [](const SimulatedTrial& s) { return Value(s, "forearm.clock_offset_s"); });
}

TEST(DrawnErrors, IncludeTheElbowsCarryingAngleAndItsSlope) {
  const ElbowModel elbow =
      Simulate(MakeScenario(DrawnElbow(1)), Drawn()).trial.observations.arm.elbow;
  EXPECT_EQ(elbow.carrying_angle_sigma, 6 * kDegree);
  EXPECT_EQ(elbow.carrying_slope_sigma, 4 * kDegree);
  ExpectSigma(elbow.carrying_angle_sigma / kDegree, 1, [](const SimulatedTrial& s) {
    return Eigen::VectorXd(Value(s, "elbow.carrying_angle_deg").array() - 10.0);
  });
  ExpectSigma(elbow.carrying_slope_sigma / kDegree, 1,
              [](const SimulatedTrial& s) { return Value(s, "elbow.carrying_slope_deg"); });
}

TEST(DrawnErrors, LetShoulderAndAdductionWanderAboutZeroWithTheirSds) {
  double shoulder = 0.0, adduction = 0.0;
  constexpr int kTrials = 400;
  for (int seed = 1; seed <= kTrials; ++seed) {
    const Scenario scenario = MakeScenario({.name = "shrug",
                                            .seed = static_cast<std::uint64_t>(seed),
                                            .adduction_rms = 4 * kDegree,
                                            .shoulder_rms = 0.2,
                                            .exact_rms = false});
    const MovingJoints q = scenario.JointsAt(0.0);
    shoulder += std::pow(q[kShoulderForward].value, 2) / kTrials;
    adduction += std::pow(q[kElbowAdduction].value, 2) / kTrials;
  }
  EXPECT_NEAR(std::sqrt(shoulder), 0.02, 0.003);
  EXPECT_NEAR(std::sqrt(adduction), 4 * kDegree, 0.6 * kDegree);
}

TEST(DrawnErrors, StateHowTheShoulderWanders) {
  ScenarioOptions movement{.name = "daily_brisk", .exact_rms = false};
  const Scenario scenario = MakeScenario(movement);
  const ShoulderModel told = Simulate(scenario, Drawn()).trial.observations.arm.shoulder;
  EXPECT_NEAR(told.sigma, 0.03, 1e-12);
  EXPECT_GT(told.correlation_time, 2.0);
  EXPECT_LT(told.correlation_time, 10.0);
}

TEST(DrawnErrors, CountTheShrugItselfAmongTheShouldersWays) {
  const Scenario scenario = MakeScenario({.name = "shrug", .shoulder_rms = 0.0});
  EXPECT_NEAR(scenario.shoulder.sigma, 0.08 / std::sqrt(6.0), 1e-9);  // up half of the time
}

TEST(DrawnErrors, LeaveTheDefaultSigmaWhereAnErrorIsOff) {
  SimulationOptions options = NoErrors();
  options.draw_sizes = true;
  const SimulatedTrial exact = Simulate(MakeScenario(DrawnElbow(1)), options);
  EXPECT_EQ(Forearm(exact).mounting->p_sigma, Mounting{}.p_sigma);
  EXPECT_EQ(Forearm(exact).noise.gyro_bias_sigma, MtwNoise().gyro_bias_sigma);
  EXPECT_EQ(Value(exact, "forearm.told_p_BS_error_m"), Eigen::VectorXd::Zero(3));
}

}  // namespace
}  // namespace brachium
