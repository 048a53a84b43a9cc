#include "problems/preintegration.h"

#include <gtest/gtest.h>

#include "problems/timeline.h"
#include "tests/support/moving_sensor.h"
#include "tests/support/residual_values.h"
#include "tests/support/smooth_motion.h"

namespace brachium {
namespace {

using Eigen::Matrix3d, Eigen::Quaterniond, Eigen::Vector3d;

const Vector3d kNoBias = Vector3d::Zero();

// Evenly sampled from 0 on: cells [0, h], [h, 2h], ...
Recording Even(const MovingSensor& sensor, double rate, double duration) {
  return Recorded(sensor, EvenTimes(0.5 / rate, 1 / rate,
                                    static_cast<std::size_t>(std::lround(duration * rate))));
}

Preintegrated Compose(const Preintegrated& a, const Preintegrated& b) {
  Preintegrated both;
  both.duration = a.duration + b.duration;
  both.dq = a.dq * b.dq;
  both.dv = a.dv + a.dq * b.dv;
  both.dp = a.dp + a.dv * b.duration + a.dq * b.dp;
  return both;
}

double Distance(const Preintegrated& a, const Preintegrated& b) {
  return Log<double>(a.dq.conjugate() * b.dq).norm() + (a.dv - b.dv).norm() + (a.dp - b.dp).norm();
}

TEST(Preintegrator, GivesATurningSensorItsAttitudeAndNoFalseAcceleration) {
  const double rate = 300 * kDegree;
  const Vector3d axis = Vector3d(0.3, -0.5, 0.8).normalized();
  const MovingSensor sensor = [&](double t) {
    return SensorOn({About(axis, {.value = rate * t, .rate = rate}), {}}, {});
  };
  const Preintegrator samples(Even(sensor, 100.0, 1.0));
  for (std::size_t i = 0; i + 1 < samples.edges().size(); ++i) {
    const double begin = samples.edges()[i], end = samples.edges()[i + 1];
    EXPECT_LT(ErrorsOf(samples.Sum(begin, end, kNoBias), sensor, begin).velocity / (end - begin),
              0.02);
    EXPECT_LT(ErrorsOf(samples.Sum(samples.Begin(), end, kNoBias), sensor, 0.0).attitude, 1e-6);
  }
  const auto all = ErrorsOf(samples.Sum(0.0, 1.0, kNoBias), sensor, 0.0);
  EXPECT_LT(all.velocity, 0.02);
}

// Coning: the axis of a small turn goes round.
SensorInstant Coning(double t) {
  const double angle = 0.15, frequency = 20.0;  // [rad], [rad/s]
  const Vector3d phi(angle * std::cos(frequency * t), angle * std::sin(frequency * t), 0.0);
  const Vector3d phi_rate = frequency * Vector3d(-phi.y(), phi.x(), 0.0);
  const Quaterniond q_WS = Exp<double>(phi);
  return {.q_WS = q_WS,
          .gyr_S = RightJacobian(phi) * phi_rate,
          .acc_S = q_WS.conjugate() * -kGravity_W};
}

// Sculling: a turn to and fro and a sway across it keep the same time.
SensorInstant Sculling(double t) {
  return SensorOn({About(Vector3d::UnitX(), Sine(0.3, 20.0, 0.0, t)),
                   PointOf({}, Sine(0.02, 20.0, 0.2, t), {})},
                  {});
}

void ExpectThirdOrder(const MovingSensor& sensor) {
  const double start = 0.2, end = 0.6;
  std::vector<SumErrors> errors;
  for (const double rate : {100.0, 200.0, 400.0})
    errors.push_back(
        ErrorsOf(Preintegrator(Even(sensor, rate, 0.8)).Sum(start, end, kNoBias), sensor, start));
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_LT(errors[i + 1].attitude, errors[i].attitude / 7.0 + 1e-12);
    EXPECT_LT(errors[i + 1].velocity, errors[i].velocity / 7.0 + 1e-12);
    EXPECT_LT(errors[i + 1].place, errors[i].place / 7.0 + 1e-12);
  }
}

TEST(Preintegrator, IsOfThirdOrderWhereTheSensorCones) { ExpectThirdOrder(Coning); }
TEST(Preintegrator, IsOfThirdOrderWhereTheSensorSculls) { ExpectThirdOrder(Sculling); }
TEST(Preintegrator, IsOfThirdOrderWhereTheSensorMovesAnyhow) {
  ExpectThirdOrder(SwayingSensor(0.7));
}

// The change that the derivatives foretell, against that of a new sum; what is left is a share of
// it.
void ExpectForetold(const Preintegrated& before, const Preintegrated& after, const Matrix3d& dR,
                    const Matrix3d& dv, const Matrix3d& dp, const Vector3d& change) {
  Preintegrated foretold = before;
  foretold.dq = before.dq * Exp<double>(dR * change);
  foretold.dv = before.dv + dv * change;
  foretold.dp = before.dp + dp * change;
  EXPECT_LT(Log<double>(foretold.dq.conjugate() * after.dq).norm(), 1e-3 * change.norm());
  EXPECT_LT((foretold.dv - after.dv).norm(), 1e-3 * (before.dv - after.dv).norm());
  EXPECT_LT((foretold.dp - after.dp).norm(), 1e-3 * (before.dp - after.dp).norm());
  EXPECT_GT(Distance(before, after), 0.01 * change.norm());  // there was something to foretell
}

TEST(Preintegrated, ForetellsAChangeOfTheGyroBias) {
  const Preintegrator samples(Even(SwayingSensor(0.7), 100.0, 0.8));
  const Vector3d bias(0.01, -0.02, 0.03), change(3e-4, -2e-4, 5e-4);
  const auto before = samples.Sum(0.2, 0.6, bias);
  ExpectForetold(before, samples.Sum(0.2, 0.6, bias + change), before.dR_dbg, before.dv_dbg,
                 before.dp_dbg, change);
}

TEST(Preintegrated, ForetellsAScaleErrorOfTheGyroscope) {
  Recording recording = Even(SwayingSensor(0.7), 100.0, 0.8);
  const auto before = Preintegrator(recording).Sum(0.2, 0.6, kNoBias);
  const Vector3d scale(3e-4, -2e-4, 4e-4);
  for (Vector3d& gyr : recording.gyr_S) gyr -= scale.cwiseProduct(gyr);
  ExpectForetold(before, Preintegrator(recording).Sum(0.2, 0.6, kNoBias), before.dR_dsg,
                 before.dv_dsg, before.dp_dsg, scale);
}

TEST(Preintegrated, ForetellsABiasOfTheAccelerometer) {
  Recording recording = Even(SwayingSensor(0.7), 100.0, 0.8);
  const auto before = Preintegrator(recording).Sum(0.2, 0.6, kNoBias);
  const Vector3d bias(0.03, -0.02, 0.05);
  for (Vector3d& acc : recording.acc_S) acc -= bias;
  ExpectForetold(before, Preintegrator(recording).Sum(0.2, 0.6, kNoBias), Matrix3d::Zero(),
                 before.dv_dba, before.dp_dba, bias);
}

TEST(Preintegrated, ForetellsAScaleErrorOfTheAccelerometer) {
  Recording recording = Even(SwayingSensor(0.7), 100.0, 0.8);
  const auto before = Preintegrator(recording).Sum(0.2, 0.6, kNoBias);
  const Vector3d scale(0.01, -0.02, 0.015);
  for (Vector3d& acc : recording.acc_S) acc -= scale.cwiseProduct(acc);
  ExpectForetold(before, Preintegrator(recording).Sum(0.2, 0.6, kNoBias), Matrix3d::Zero(),
                 before.dv_dsa, before.dp_dsa, scale);
}

TEST(Preintegrated, ForetellsWhatAClockThatIsBehindChanges) {
  const Preintegrator samples(Even(SwayingSensor(0.7), 400.0, 0.8));
  const auto before = samples.Sum(0.2, 0.6, kNoBias);
  const auto along_x = [](const Vector3d& derivative) {
    Matrix3d matrix = Matrix3d::Zero();
    matrix.col(0) = derivative;
    return matrix;
  };
  const double behind = 1e-4;
  ExpectForetold(before, samples.Sum(0.2, 0.6, kNoBias, behind), along_x(before.dR_dc),
                 along_x(before.dv_dc), along_x(before.dp_dc), Vector3d(behind, 0.0, 0.0));
}

TEST(Preintegrated, KnowsWhatAClockThatIsBehindChangesUpToBothEndsOfTheRecording) {
  const Preintegrator samples(Even(SwayingSensor(0.7), 100.0, 0.8));
  const auto whole = samples.Sum(samples.Begin(), samples.End(), kNoBias);
  EXPECT_TRUE(whole.dR_dc.allFinite());
  EXPECT_TRUE(whole.dv_dc.allFinite());
  EXPECT_TRUE(whole.dp_dc.allFinite());
}

TEST(Preintegrated, TakesWhatAClockChangesFromTheSignalsAtItsEndsAlsoNearThoseOfTheRecording) {
  const MovingSensor sensor = SwayingSensor(0.7);
  const Preintegrator samples(Even(sensor, 100.0, 0.8));
  const auto expect = [&](double start, double end) {
    const Preintegrated sum = samples.Sum(start, end, kNoBias);
    const SensorInstant first = sensor(start), last = sensor(end);
    EXPECT_LT((sum.dR_dc - (sum.dq.conjugate() * first.gyr_S - last.gyr_S)).norm(), 1e-3) << start;
    const Vector3d dv_dc = first.gyr_S.cross(sum.dv) - sum.dq * last.acc_S + first.acc_S;
    EXPECT_LT((sum.dv_dc - dv_dc).norm(), 1e-2) << start;
  };
  for (const double off : {0.005, 0.01, 0.015, 0.025, 0.035, 0.055, 0.1}) {
    expect(off, 0.4);
    expect(0.4, 0.8 - off);
  }
}

TEST(Preintegrator, TakesTheSamplesThatAClockWhichIsBehindStampedEarlier) {
  const Preintegrator samples(Even(SwayingSensor(0.7), 100.0, 0.8));
  const auto behind = samples.Sum(0.25, 0.5, kNoBias, 0.05),
             shifted = samples.Sum(0.2, 0.45, kNoBias);
  EXPECT_EQ(Distance(behind, shifted), 0.0);
  EXPECT_EQ(behind.clock_offset, 0.05);
  EXPECT_EQ(samples.Turn(0.25, 0.5, kNoBias, 0.05).dq.coeffs(),
            samples.Turn(0.2, 0.45, kNoBias).dq.coeffs());
}

TEST(Preintegrator, HoldsTheOuterSamplesWithAVarianceWhereAClockAsksForMore) {
  const Preintegrator samples(Even(SwayingSensor(0.7), 100.0, 0.8));
  const double begin = samples.Begin(), end = samples.End();
  const auto early = samples.Sum(begin, begin + 0.1, kNoBias, 0.05);
  const auto late = samples.Sum(end - 0.1, end, kNoBias, -0.05);
  for (const Preintegrated& sum : {early, late}) {
    EXPECT_NEAR(sum.dv.norm(), 9.81 * 0.1, 0.2);
    EXPECT_GT(sum.gyro_gap_variance, 0.0);
    EXPECT_GT(sum.accel_gap_variance, 0.0);
  }
  EXPECT_EQ(samples.Sum(begin, begin + 0.1, kNoBias).gyro_gap_variance, 0.0);
}

TEST(Preintegrator, ComposesOverAKnotThatCutsACell) {
  const MovingSensor sensor = SwayingSensor(0.7);
  const Preintegrator samples(Even(sensor, 100.0, 0.8));
  for (const double b : {0.303, 0.305, 0.3099999, 0.31}) {
    const auto parts = Compose(samples.Sum(0.2, b, kNoBias), samples.Sum(b, 0.5, kNoBias));
    EXPECT_LT(Distance(parts, samples.Sum(0.2, 0.5, kNoBias)), 1e-7) << b;
    const auto errors = ErrorsOf(samples.Sum(b, 0.5, kNoBias), sensor, b);
    EXPECT_LT(errors.attitude + errors.velocity + errors.place, 3e-5) << b;
  }
}

Recording Jittering(const MovingSensor& sensor, double start, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> jitter(-0.002, 0.002);
  std::vector<double> times = EvenTimes(start, 0.01, 100);
  for (double& time : times) time += jitter(random);
  return Recorded(sensor, times);
}

TEST(Preintegrator, FollowsTwoSensorsWhoseClocksJitterOverTheKnotsOfTheFirst) {
  const MovingSensor first = SwayingSensor(0.7), second = SwayingSensor(2.0);
  const std::vector<Preintegrator> samples{Preintegrator(Jittering(first, 0.005, 1)),
                                           Preintegrator(Jittering(second, 0.0123, 2))};
  EXPECT_EQ(samples[0].edges().size(), 101u);
  const auto knots = MakeTimeline(samples, 0.05, 1.0).knots;
  ASSERT_GT(knots.size(), 15u);
  for (std::size_t i = 1; i < knots.size(); ++i)
    for (const std::size_t sensor : {0u, 1u}) {
      const auto sum = samples[sensor].Sum(knots[i - 1], knots[i], kNoBias);
      const auto errors = ErrorsOf(sum, sensor == 0 ? first : second, knots[i - 1]);
      EXPECT_LT(errors.attitude, 2e-5);
      EXPECT_LT(errors.velocity, 2e-4);
      EXPECT_LT(errors.place, 1e-5);
      EXPECT_EQ(sum.gyro_gap_variance, 0.0);
    }
}

TEST(Preintegrator, MakesALostPacketACellThatItIsUnsureOf) {
  const MovingSensor sensor = SwayingSensor(0.7);
  for (const std::size_t lost : {1u, 2u, 5u}) {
    Recording recording = Even(sensor, 100.0, 1.0);
    Lose(recording, 50, lost);
    const Preintegrator samples(recording);
    const double begin = 0.5, end = begin + 0.01 * static_cast<double>(lost);
    EXPECT_EQ(samples.edges().size(), 102 - lost);
    EXPECT_NEAR(samples.edges()[50], begin, 1e-12);
    EXPECT_NEAR(samples.edges()[51], end, 1e-12);

    const auto gap = samples.Sum(begin, end, kNoBias), around = samples.Sum(0.4, 0.7, kNoBias);
    EXPECT_GT(gap.gyro_gap_variance, 0.0);
    EXPECT_GT(gap.accel_gap_variance, 0.0);
    EXPECT_NEAR(around.gyro_gap_variance, gap.gyro_gap_variance, 1e-9 * gap.gyro_gap_variance);
    const auto errors = ErrorsOf(around, sensor, 0.4);
    EXPECT_LT(errors.attitude, 3 * std::sqrt(around.gyro_gap_variance));
    EXPECT_LT(errors.velocity, 3 * std::sqrt(around.accel_gap_variance));
  }
}

// Rolls to and fro at up to 9 rad/s under a gyroscope of 7 rad/s.
TEST(Preintegrator, IsUnsureOfSpansInWhichTheSensorWasOutOfItsRange) {
  const MovingSensor sensor = [](double t) {
    const double angle = 0.9 * std::sin(10.0 * t), rate = 9.0 * std::cos(10.0 * t);
    return SensorOn({About(Vector3d::UnitX(), {.value = angle, .rate = rate}), {}}, {});
  };
  Recording recording = Even(sensor, 100.0, 1.0);
  for (Vector3d& gyr : recording.gyr_S) gyr = gyr.cwiseMin(7.0).cwiseMax(-7.0);
  const Preintegrator samples(recording);
  const auto over = samples.Sum(0.2, 0.42, kNoBias), below = samples.Sum(0.43, 0.5, kNoBias);
  EXPECT_EQ(below.gyro_gap_variance, 0.0);
  const double error = ErrorsOf(over, sensor, 0.2).attitude, sd = std::sqrt(over.gyro_gap_variance);
  EXPECT_GT(error, 0.1);
  EXPECT_LT(error, 2 * sd);
  EXPECT_GT(error, 0.3 * sd);
}

TEST(Preintegrator, SharesTheDoubtOfAGapAmongTheIntervalsThatCutIt) {
  Recording recording = Even(SwayingSensor(0.7), 100.0, 1.0);
  Lose(recording, 50, 4);
  const Preintegrator samples(recording);
  const auto a = samples.Sum(0.4, 0.513, kNoBias), b = samples.Sum(0.513, 0.7, kNoBias);
  const auto both = samples.Sum(0.4, 0.7, kNoBias);
  EXPECT_NEAR(a.gyro_gap_variance + b.gyro_gap_variance, both.gyro_gap_variance,
              1e-9 * both.gyro_gap_variance);
  EXPECT_NEAR(a.accel_gap_variance + b.accel_gap_variance, both.accel_gap_variance,
              1e-9 * both.accel_gap_variance);
}

TEST(Preintegrator, TurnsAsItSums) {
  Recording recording = Even(SwayingSensor(0.7), 100.0, 1.0);
  Lose(recording, 50, 4);
  const Preintegrator samples(recording);
  const Vector3d bias(0.02, -0.01, 0.03);
  const auto sum = samples.Sum(0.4, 0.713, bias);
  const Turned turned = samples.Turn(0.4, 0.713, bias);
  EXPECT_EQ(turned.duration, sum.duration);
  EXPECT_LT(turned.dq.angularDistance(sum.dq), 1e-12);
  EXPECT_LT((turned.dR_dbg - sum.dR_dbg).norm(), 1e-12);
  EXPECT_EQ(turned.gyro_gap_variance, sum.gyro_gap_variance);
  EXPECT_GT(turned.gyro_gap_variance, 0.0);
}

TEST(Preintegrator, IsSureOfARecordingWithoutGaps) {
  std::vector<double> times = EvenTimes(0.005, 0.01, 100);
  times[40] += 0.004;  // late, not lost
  const auto sum = Preintegrator(Recorded(SwayingSensor(0.7), times)).Sum(0.1, 0.9, kNoBias);
  EXPECT_EQ(sum.gyro_gap_variance, 0.0);
  EXPECT_EQ(sum.accel_gap_variance, 0.0);
}

TEST(Preintegrator, ReachesHalfAPeriodBeyondTheFirstAndTheLastSample) {
  const Preintegrator samples(Recorded(SwayingSensor(0.0), EvenTimes(2.0, 0.02, 2)));
  EXPECT_DOUBLE_EQ(samples.Begin(), 1.99);
  EXPECT_DOUBLE_EQ(samples.End(), 2.03);
  EXPECT_NEAR(samples.Period(), 0.02, 1e-12);
  EXPECT_NEAR(samples.Sum(1.99, 2.03, kNoBias).duration, 0.04, 1e-12);
}

TEST(Preintegrated, HoldsTheIntegralsThatTheWeightsAreMadeOf) {
  const double rate = 2.0;
  const MovingSensor sensor = [&](double t) {
    return SensorOn({About(Vector3d::UnitY(), {.value = rate * t, .rate = rate}), {}}, {});
  };
  const auto sum = Preintegrator(Even(sensor, 100.0, 1.0)).Sum(0.2, 0.7, kNoBias);
  EXPECT_NEAR(sum.rate_squared, 4.0 * 0.5, 1e-9);
  EXPECT_NEAR(sum.force_spread, 16.0 * 0.5, 1e-9);
}

}  // namespace
}  // namespace brachium
