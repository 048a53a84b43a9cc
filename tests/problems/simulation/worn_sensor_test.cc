#include "problems/simulation/worn_sensor.h"

#include <gtest/gtest.h>

#include <cmath>

#include "problems/rotation.h"
#include "problems/simulation/mirror.h"
#include "tests/support/scenarios.h"

namespace brachium {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;

constexpr Side kSides[] = {Side::kRight, Side::kLeft};

WornSensor Wear(const Scenario& scenario, Segment segment, const SoftTissue& soft_tissue) {
  Draws draws(9, "worn_sensor_test");
  WornSensor sensor{.segment = segment,
                    .mounting = DrawMounting(segment, scenario.shape.DistalJoint(segment), draws),
                    .wobble = DrawWobble(soft_tissue, segment, scenario.options.duration, draws)};
  if (scenario.options.side == Side::kLeft) sensor.mounting = Mirrored(sensor.mounting);
  return sensor;
}

// Strapdown integration of an ideal sensor's signals from its true pose at t = 0: Runge-Kutta of
// fourth order, with nothing of the simulator but the signals.
class Strapdown {
 public:
  explicit Strapdown(const SensorInstant& start)
      : q_WS_(start.q_WS), v_W_(start.point_W.v), p_W_(start.point_W.p) {}

  void Advance(const SensorInstant& a, const SensorInstant& b, const SensorInstant& c, double h) {
    const Quaterniond q_a = q_WS_;
    const Vector3d k1 = a.gyr_S;
    const Vector3d k2 = Rate(0.5 * h * k1, b.gyr_S);
    const Vector3d k3 = Rate(0.5 * h * k2, b.gyr_S);
    const Vector3d k4 = Rate(h * k3, c.gyr_S);
    // The middle of the step by Hermite interpolation, of fourth order too.
    const Vector3d turn = h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    const Vector3d k_end = Rate(turn, c.gyr_S);
    const Vector3d half = 0.5 * turn + h / 8.0 * (k1 - k_end);
    const Vector3d f_a = Free(q_a, a), f_b = Free(q_a * Exp<double>(half), b);
    q_WS_ = (q_a * Exp<double>(turn)).normalized();
    const Vector3d f_c = Free(q_WS_, c);
    p_W_ += h * v_W_ + h * h / 6.0 * (f_a + 2.0 * f_b);
    v_W_ += h / 6.0 * (f_a + 4.0 * f_b + f_c);
  }

  double AttitudeError(const SensorInstant& truth) const {
    return Log<double>(truth.q_WS.conjugate() * q_WS_).norm();
  }
  double PositionError(const SensorInstant& truth) const { return (truth.point_W.p - p_W_).norm(); }

 private:
  // The rate of the rotation vector phi of the turn since the step's start, with Exp(phi).
  static Vector3d Rate(const Vector3d& phi, const Vector3d& omega) {
    return InverseRightJacobian(phi) * omega;
  }
  static Vector3d Free(const Quaterniond& q_WS, const SensorInstant& instant) {
    return q_WS * instant.acc_S - kGravity * Vector3d::UnitZ();
  }

  Quaterniond q_WS_;
  Vector3d v_W_, p_W_;
};

// Returns the worst attitude and position error over a minute.
std::pair<double, double> DeadReckon(const Scenario& scenario, const WornSensor& sensor) {
  constexpr double kStep = 1e-3;
  SensorInstant a = At(sensor, scenario, 0.0);
  Strapdown strapdown(a);
  double attitude = 0.0, position = 0.0;
  for (int i = 0; i < 60000; ++i) {
    const SensorInstant b = At(sensor, scenario, (i + 0.5) * kStep);
    const SensorInstant c = At(sensor, scenario, (i + 1.0) * kStep);
    strapdown.Advance(a, b, c, kStep);
    attitude = std::max(attitude, strapdown.AttitudeError(c));
    position = std::max(position, strapdown.PositionError(c));
    a = c;
  }
  return {attitude, position};
}

TEST(WornSensor, LeadsBackToItsPoseByIntegrationOverAMinute) {
  for (const Side side : kSides)
    for (const Segment segment : {Segment::kUpperArm, Segment::kForearm}) {
      const Scenario scenario = MakeScenario({.name = "daily_brisk", .side = side});
      const auto [attitude, position] = DeadReckon(scenario, Wear(scenario, segment, {}));
      EXPECT_LT(attitude, 1e-6) << Name(side) << ' ' << Name(segment);
      EXPECT_LT(position, 1e-6) << Name(side) << ' ' << Name(segment);
    }
}

// The girdle and the hand too, through paths in space, tremor, strokes and a trunk that leans.
TEST(WornSensor, LeadsBackToItsPoseByIntegrationInEveryFamilyOfMovements) {
  const std::pair<const char*, int> families[] = {{"eating", 0},
                                                  {"circle", 0},
                                                  {"goniometer_swing", 0},
                                                  {"nine_hole_peg_test", 1},
                                                  {"range_of_motion", 4}};
  for (const auto& [name, week] : families) {
    ScenarioOptions options = MakeUsual(name, Side::kLeft, 4, week).options;
    options.duration = std::max(options.duration, 65.0);
    const Scenario scenario = MakeScenario(options);
    for (const Segment segment : {Segment::kGirdle, Segment::kHand}) {
      const auto [attitude, position] = DeadReckon(scenario, Wear(scenario, segment, {}));
      EXPECT_LT(attitude, 1e-6) << name << ' ' << Name(segment);
      EXPECT_LT(position, 1e-6) << name << ' ' << Name(segment);
    }
  }
}

TEST(WornSensor, FeelsItsWobbleSoThatIntegrationLeadsBackToItsWobblingPose) {
  const Scenario scenario = MakeScenario({.name = "reach", .side = Side::kLeft});
  const auto [attitude, position] =
      DeadReckon(scenario, Wear(scenario, Segment::kForearm, TypicalSoftTissue()));
  EXPECT_LT(attitude, 1e-6);
  EXPECT_LT(position, 1e-6);
}

TEST(WornSensor, SitsOnItsSegmentWhereItsMountingSays) {
  for (const Side side : kSides) {
    const Scenario scenario = MakeScenario({.name = "daily_brisk", .side = side});
    for (const Segment segment : {Segment::kUpperArm, Segment::kForearm}) {
      const WornSensor sensor = Wear(scenario, segment, {});
      const BodyMotion body = scenario.At(17.3)[segment];
      const SensorInstant instant = At(sensor, scenario, 17.3);
      EXPECT_LT((body.turning.q_AB * sensor.mounting.q_BS).angularDistance(instant.q_WS), 1e-12);
      EXPECT_TRUE(instant.point_W.p.isApprox(
          body.joint_W.p + body.turning.q_AB * sensor.mounting.p_BS_B, 1e-12));
    }
  }
}

TEST(WornSensor, IsWornLaterallyNearTheElbowAndDorsallyNearTheWrist) {
  const Scenario scenario = MakeScenario({});
  const Mounting upper_arm = Wear(scenario, Segment::kUpperArm, {}).mounting;
  const Mounting forearm = Wear(scenario, Segment::kForearm, {}).mounting;
  EXPECT_GT(upper_arm.p_BS_B.z(), 0.02);
  EXPECT_LT(upper_arm.p_BS_B.y(), -0.2);
  EXPECT_LT(forearm.p_BS_B.x(), -0.02);
  EXPECT_LT(forearm.p_BS_B.y(), -0.2);
  EXPECT_GT((upper_arm.q_BS * Vector3d::UnitZ()).z(), 0.9);  // out of the skin
  EXPECT_LT((forearm.q_BS * Vector3d::UnitZ()).x(), -0.9);
}

TEST(WornSensor, MeasuresGravityUpwardAtRest) {
  const Scenario scenario = MakeScenario({});
  const SensorInstant instant =
      At(Wear(scenario, Segment::kForearm, TypicalSoftTissue()), scenario, 1.0);
  EXPECT_TRUE((instant.q_WS * instant.acc_S).isApprox(kGravity * Vector3d::UnitZ(), 1e-12));
  EXPECT_EQ(instant.gyr_S.norm(), 0.0);
}

TEST(Wobble, HasTheRmsAskedForBetweenTheRestsAndNoneInThem) {
  Draws draws(2, "wobble");
  const Wobble wobble = DrawWobble(TypicalSoftTissue(), Segment::kForearm, 600.0, draws);
  Vector3d turn = Vector3d::Zero(), shift = Vector3d::Zero();
  int count = 0;
  for (double t = 5.0; t < 595.0; t += 0.05, ++count) {
    turn += Log<double>(TurnOf(wobble, t).q_AB).cwiseAbs2();
    for (int i = 0; i < 3; ++i)
      shift[i] += std::pow(wobble.shift[static_cast<std::size_t>(i)].At(t).value, 2);
  }
  turn = (turn / count).cwiseSqrt() / kDegree;
  shift = (shift / count).cwiseSqrt();
  EXPECT_NEAR(turn.x(), 1.2, 0.1);
  EXPECT_NEAR(turn.y(), 3.0, 0.15);
  EXPECT_NEAR(turn.z(), 1.2, 0.1);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(shift[i], 0.003, 0.0002);
  EXPECT_EQ(Log<double>(TurnOf(wobble, 2.9).q_AB).norm(), 0.0);
  EXPECT_EQ(Log<double>(TurnOf(wobble, 599.0).q_AB).norm(), 0.0);
}

}  // namespace
}  // namespace brachium
