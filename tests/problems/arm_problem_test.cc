#include "problems/arm_problem.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "problems/joint_angles.h"
#include "tests/support/moving_sensor.h"
#include "tests/support/residual_values.h"
#include "tests/support/simulated_trial.h"
#include "tests/support/smooth_motion.h"

namespace brachium {
namespace {

using Eigen::AngleAxisd, Eigen::Quaterniond, Eigen::Vector3d;

// A still arm: each segment's attitude, and ideal recordings of the sensors that it wears. Its end
// rests on something twice, and is twice as high.
struct StillArm {
  Observations observations;
  std::vector<Quaterniond> q_WB;

  explicit StillArm(const std::vector<Segment>& segments, double duration = 12.0) {
    std::mt19937 random(1);
    const Quaterniond hanging(AngleAxisd(80 * kDegree, Vector3d::UnitX()));
    const ElbowAngles elbow{
        .flexion = 0.7, .carrying = observations.arm.elbow.carrying_angle, .pronation = 1.2};
    for (const Segment segment : segments) {
      const bool bent = segment == Segment::kForearm && !q_WB.empty();
      q_WB.push_back(bent ? q_WB.back() * ElbowRotation(elbow, Side::kRight)
                          : Near(hanging, 0.2, random));
      observations.arm.segments[segment].p_distal_B = Vector3d(0.01, -0.3, 0.02);
      const Mounting mounting{.q_BS = RandomRotation(random), .p_BS_B = Vector3d(0.03, -0.2, 0.01)};
      const MovingSensor sensor = [&](double) {
        return SensorOn({{.q_AB = q_WB.back()}, {}}, mounting);
      };
      observations.recordings.push_back(
          Recorded(sensor, EvenTimes(0.01, 0.02, static_cast<std::size_t>(duration * 50))));
      observations.recordings.back().segment = segment;
      observations.recordings.back().mounting = mounting;
    }
    if (segments.size() > 1)
      observations.contacts = {
          {.place = "cup", .segment = segments.back(), .times = {2.0, 7.0}},
          {.place = "desk", .segment = segments.back(), .times = {3.0, 9.0}, .height_only = true}};
  }
  ArmProblem Problem(double knot_spacing = 0.1) const { return {observations, {}, knot_spacing}; }

  // The unknowns' true values, the root joint where it starts.
  State Truth(const ArmProblem& problem) const {
    State state = problem.PriorState();
    for (int knot = 0; knot < problem.size().knots; ++knot) {
      for (std::size_t i = 0; i < q_WB.size(); ++i)
        Eigen::Map<Quaterniond>{state.Attitude(knot, static_cast<int>(i))} = q_WB[i];
      if (problem.size().roots == 2)
        Eigen::Map<Vector3d>{state.Root(knot, 1)} =
            q_WB[0] * observations.arm.segments.at(Segment::kThorax).p_distal_B;
      for (int sensor = 0; sensor < problem.size().sensors; ++sensor)
        Eigen::Map<Vector3d>{state.Place(knot, sensor)} = problem.PlaceOnChain(state, knot, sensor);
    }
    for (int contact = 0; contact < problem.size().contacts; ++contact) {
      const Vector3d p_W = problem.TouchingPoint(state, contact, 0);
      double* const place = problem.Value(state, problem.PlaceOf(contact));
      if (observations.contacts[static_cast<std::size_t>(contact)].height_only)
        *place = p_W.z();
      else
        Eigen::Map<Vector3d>{place} = p_W;
    }
    return state;
  }
};

const std::vector<Segment> kElbow{Segment::kUpperArm, Segment::kForearm};
const std::vector<Segment> kWhole(kSegments.begin(), kSegments.end());
const std::vector<std::vector<Segment>> kArms{
    kElbow,
    {Segment::kForearm},
    {Segment::kThorax},
    {Segment::kUpperArm, Segment::kForearm, Segment::kHand},
    {Segment::kThorax, Segment::kUpperArm, Segment::kForearm},
    kWhole};

Eigen::VectorXd ResidualOf(const Term& term, const ArmProblem& problem, State& state) {
  std::vector<const double*> x;
  for (const int unknown : term.unknowns) x.push_back(problem.Value(state, unknown));
  Eigen::VectorXd r(term.cost->num_residuals());
  EXPECT_TRUE(term.cost->Evaluate(x.data(), r.data(), nullptr));
  return r;
}

int Count(const ArmProblem& problem, ResidualKind kind) {
  return static_cast<int>(std::count_if(problem.terms().begin(), problem.terms().end(),
                                        [&](const Term& term) { return term.kind == kind; }));
}

TEST(ArmProblem, OrdersItsTermsByTheFirstKnotTheyTouch) {
  for (const auto& segments : kArms) {
    const ArmProblem problem = StillArm(segments).Problem();
    int before = 0;
    for (const Term& term : problem.terms()) {
      EXPECT_LE(before, term.first_knot);
      EXPECT_LE(term.first_knot, term.last_knot);
      before = term.first_knot;
      for (const int unknown : term.unknowns) {
        const Unknown u = problem.Describe(unknown);
        if (u.kind >= UnknownKind::kGyroBias) continue;  // a bias or a constant
        EXPECT_GE(u.place, term.first_knot) << Name(term.kind);
        EXPECT_LE(u.place, term.last_knot) << Name(term.kind);
      }
    }
  }
}

TEST(ArmProblem, GivesEveryCostUnknownsOfTheSizesItAsksFor) {
  for (const auto& segments : kArms) {
    const ArmProblem problem = StillArm(segments).Problem();
    for (const Term& term : problem.terms()) {
      ASSERT_EQ(term.unknowns.size(), term.cost->parameter_block_sizes().size());
      for (std::size_t i = 0; i < term.unknowns.size(); ++i) {
        ASSERT_GE(term.unknowns[i], 0) << Name(term.kind);
        EXPECT_EQ(problem.Describe(term.unknowns[i]).Size(), term.cost->parameter_block_sizes()[i])
            << Name(term.kind);
      }
    }
  }
}

TEST(ArmProblem, SaysOfEveryUnknownWhatItIsAndWhereItsValueLies) {
  for (const auto& segments : kArms) {
    const ArmProblem problem = StillArm(segments).Problem();
    State state = problem.PriorState();
    std::set<double*> values;
    for (int unknown = 0; unknown < problem.unknowns(); ++unknown) {
      const Unknown u = problem.Describe(unknown);
      int index = -1;
      switch (u.kind) {
        case UnknownKind::kAttitude:
          index = problem.Attitude(u.place, u.sensor);
          break;
        case UnknownKind::kRoot:
          index = problem.Root(u.place, u.sensor);
          break;
        case UnknownKind::kVelocity:
          index = problem.Velocity(u.place, u.sensor);
          break;
        case UnknownKind::kPlace:
          index = problem.Place(u.place, u.sensor);
          break;
        case UnknownKind::kSkin:
          index = problem.Skin(u.place, u.sensor);
          break;
        case UnknownKind::kAdduction:
          index = problem.Adduction(u.place);
          break;
        case UnknownKind::kGyroBias:
          index = problem.GyroBias(u.place, u.sensor);
          break;
        default:
          index = problem.Constant(u.kind, u.sensor);
      }
      EXPECT_EQ(index, unknown);
      values.insert(problem.Value(state, unknown));
    }
    EXPECT_EQ(values.size(), static_cast<std::size_t>(problem.unknowns()));
  }
}

TEST(ArmProblem, UsesEveryUnknownButTheDeviationOfAnElbowThatItDoesNotKnow) {
  for (const auto& segments : kArms) {
    const ArmProblem problem = StillArm(segments).Problem();
    const bool has_elbow = problem.Constant(UnknownKind::kCarryingAngle, -1) >= 0;
    std::set<int> used;
    for (const Term& term : problem.terms())
      used.insert(term.unknowns.begin(), term.unknowns.end());
    for (int unknown = 0; unknown < problem.unknowns(); ++unknown)
      EXPECT_EQ(used.contains(unknown),
                has_elbow || problem.Describe(unknown).kind != UnknownKind::kAdduction)
          << unknown;
  }
}

TEST(ArmProblem, ChainsTheArmFromItsRootToEachSensorAndTheThoraxByItself) {
  const ArmProblem problem = StillArm(kWhole).Problem();
  using Chain = std::vector<int>;
  EXPECT_EQ(problem.Chain(0), Chain({0}));
  EXPECT_EQ(problem.Chain(1), Chain({1}));
  EXPECT_EQ(problem.Chain(2), Chain({1, 2}));
  EXPECT_EQ(problem.Chain(3), Chain({1, 2, 3}));
  EXPECT_EQ(problem.Chain(4), Chain({1, 2, 3, 4}));
  EXPECT_EQ(problem.RootOf(0), 0);
  EXPECT_EQ(problem.RootOf(1), 1);
  EXPECT_EQ(problem.RootOf(4), 1);

  const ArmProblem arm = StillArm(kElbow).Problem();
  EXPECT_EQ(arm.Chain(1), Chain({0, 1}));
  EXPECT_EQ(arm.RootOf(1), 0);
  EXPECT_EQ(arm.size().roots, 1);
  EXPECT_EQ(arm.SensorOn(Segment::kForearm), 1);
  EXPECT_EQ(arm.SensorOn(Segment::kHand), -1);
}

TEST(ArmProblem, HasNoResidualWhereAStillArmIsWhatItIs) {
  for (const auto& segments : kArms) {
    StillArm arm(segments);
    if (segments.size() > 1 && segments[0] == Segment::kUpperArm)
      arm.observations.start_pose = arm.observations.end_pose =
          HeldPose{.time = 0.5,
                   .elbow_flexion = 0.7,
                   .forearm_pronation = 1.2,
                   .shoulder_elevation = ShoulderElevation(arm.q_WB[0])};
    ArmProblem problem = arm.Problem();
    State truth = arm.Truth(problem);
    problem.FixHeadings(truth);
    for (const Term& term : problem.terms())
      EXPECT_LT(ResidualOf(term, problem, truth).norm(), 1e-6)
          << Name(term.kind) << " at knot " << term.first_knot;
  }
}

TEST(ArmProblem, HasOneOfEachMeasurementPerSensorAndInterval) {
  const ArmProblem problem = StillArm(kWhole).Problem();
  const int intervals = problem.timeline().Intervals();
  EXPECT_EQ(Count(problem, ResidualKind::kGyroscope), 5 * intervals);
  EXPECT_EQ(Count(problem, ResidualKind::kAccelerometer), 5 * intervals);
  EXPECT_EQ(Count(problem, ResidualKind::kSegmentChain), 5 * (intervals + 1));
  EXPECT_EQ(Count(problem, ResidualKind::kElbowAdduction), intervals + 1);
  EXPECT_EQ(Count(problem, ResidualKind::kRangeOfMotion), intervals + 1);
  EXPECT_EQ(Count(problem, ResidualKind::kShoulderProcess), intervals + 1);
  EXPECT_EQ(Count(problem, ResidualKind::kGyroBiasWalk), 5 * (problem.size().nodes - 1));
  EXPECT_EQ(Count(problem, ResidualKind::kZeroVelocity), 5 * (intervals - 1));  // a rest throughout
}

TEST(ArmProblem, HoldsAPoseAtTheKnotOfItsInstantAtEitherEnd) {
  StillArm arm(kElbow);
  arm.observations.start_pose = HeldPose{
      .time = 0.5, .elbow_flexion = 0.7, .forearm_pronation = {}, .shoulder_elevation = {}};
  arm.observations.end_pose = HeldPose{
      .time = 11.3, .elbow_flexion = 0.7, .forearm_pronation = 1.2, .shoulder_elevation = {}};
  const ArmProblem problem = arm.Problem();
  EXPECT_EQ(Count(problem, ResidualKind::kStartPose), 1);
  EXPECT_EQ(Count(problem, ResidualKind::kEndPose), 2);
  for (const Term& term : problem.terms()) {
    if (term.kind != ResidualKind::kEndPose) continue;
    EXPECT_NEAR(problem.timeline().knots[static_cast<std::size_t>(term.first_knot)], 11.3, 0.1);
  }
}

TEST(ArmProblem, TouchesAtTheNearestKnotOnceHoweverOftenItIsNamed) {
  StillArm arm(kElbow);
  arm.observations.contacts[0].times = {7.04, 2.0, 7.02};
  const ArmProblem problem = arm.Problem();
  ASSERT_EQ(problem.Touches(0).size(), 2u);
  const auto& knots = problem.timeline().knots;
  for (const int i : {0, 1})
    EXPECT_NEAR(knots[static_cast<std::size_t>(problem.Touches(0)[static_cast<std::size_t>(i)])],
                i == 0 ? 2.0 : 7.03, 0.051);
  EXPECT_EQ(Count(problem, ResidualKind::kContact), 4);
}

// The wrist of a forearm that no sensor follows is as far as a tape says; what touches tests that.
TEST(ArmProblem, AsksForTheLengthOfTheLastSegmentWhereItTouches) {
  StillArm arm(kElbow);
  EXPECT_GE(arm.Problem().Constant(UnknownKind::kJointVector, 1), 0);
  arm.observations.contacts.clear();
  EXPECT_EQ(arm.Problem().Constant(UnknownKind::kJointVector, 1), -1);
}

TEST(ArmProblem, KnowsNoElbowAndNoShoulderWhereOneSensorIsAlone) {
  const ArmProblem problem = StillArm({Segment::kForearm}).Problem();
  EXPECT_EQ(Count(problem, ResidualKind::kElbowAdduction), 0);
  EXPECT_EQ(Count(problem, ResidualKind::kShoulderProcess), 0);
  EXPECT_EQ(problem.Constant(UnknownKind::kCarryingAngle, -1), -1);
  EXPECT_EQ(problem.Constant(UnknownKind::kShoulderMean, -1), -1);
}

TEST(ArmProblem, LeavesTheElbowFreeWhereItIsABallJoint) {
  StillArm arm(kElbow);
  arm.observations.arm.elbow.adduction_constraint = false;
  EXPECT_EQ(Count(arm.Problem(), ResidualKind::kElbowAdduction), 0);
}

TEST(ArmProblem, StartsTheGyroBiasesFromTheRests) {
  StillArm arm(kElbow);
  const Vector3d bias(0.004, -0.003, 0.002);
  for (Vector3d& gyr : arm.observations.recordings[1].gyr_S) gyr += bias;
  const ArmProblem problem = arm.Problem();
  const State state = problem.PriorState();
  for (int node = 0; node < problem.size().nodes; ++node)
    EXPECT_LT((Eigen::Map<const Vector3d>(state.GyroBias(node, 1)) - bias).norm(), 1e-12);
  EXPECT_LT((problem.Interval(3, 1).gyro_bias - bias).norm(), 1e-12);
}

TEST(ArmProblem, WeighsTheAccelerometersAnewByTheirUnmodelledAcceleration) {
  const StillArm arm(kElbow);
  ArmProblem problem = arm.Problem();
  State off = arm.Truth(problem);
  for (int knot = 0; knot < problem.size().knots; ++knot)
    off.Velocity(knot, 0)[0] = off.Velocity(knot, 1)[0] = 0.1 * knot;
  const auto cost = [&](int sensor) {
    double sum = 0.0;
    for (const Term& term : problem.terms())
      if (term.kind == ResidualKind::kAccelerometer && term.sensor == sensor)
        sum += ResidualOf(term, problem, off).squaredNorm();
    return sum;
  };
  const double first = cost(0), second = cost(1);
  const Unmodelled told = problem.unmodelled()[0];
  problem.SetUnmodelled({told, {10 * told.acceleration, told.quiver}});
  EXPECT_NEAR(cost(0), first, 1e-9 * first);
  EXPECT_NEAR(cost(1), 0.01 * second, 1e-4 * second);  // but for the white noise
  EXPECT_EQ(problem.unmodelled()[1].acceleration, 10 * told.acceleration);
}

TEST(ArmProblem, WeighsTheChainsAnewByTheirQuiver) {
  const StillArm arm(kElbow);
  ArmProblem problem = arm.Problem();
  State off = arm.Truth(problem);
  for (int knot = 0; knot < problem.size().knots; ++knot) off.Place(knot, 1)[2] += 0.001;
  const auto cost = [&] {
    double sum = 0.0;
    for (const Term& term : problem.terms())
      if (term.kind == ResidualKind::kSegmentChain)
        sum += ResidualOf(term, problem, off).squaredNorm();
    return sum;
  };
  const double before = cost();
  const Unmodelled told = problem.unmodelled()[1];
  problem.SetUnmodelled({told, {told.acceleration, 3 * told.quiver}});
  EXPECT_NEAR(cost(), before / 9, 1e-9 * before);
}

TEST(ArmProblem, TiesEachHeadingOnceHoweverOftenItIsFixed) {
  const StillArm arm(kElbow);
  ArmProblem problem = arm.Problem();
  State truth = arm.Truth(problem), turned = truth;
  for (int sensor = 0; sensor < 2; ++sensor)
    Eigen::Map<Quaterniond>{turned.Attitude(0, sensor)} =
        AngleAxisd(1.0, Vector3d::UnitZ()) * arm.q_WB[static_cast<std::size_t>(sensor)];
  problem.FixHeadings(truth);
  problem.FixHeadings(turned);
  EXPECT_EQ(Count(problem, ResidualKind::kHeadingGauge), 1);
  EXPECT_EQ(Count(problem, ResidualKind::kStartHeading), 1);
  EXPECT_NEAR(ResidualOf(problem.terms()[0], problem, truth)[0], -1000.0, 1e-6);
  EXPECT_NEAR(ResidualOf(problem.terms()[1], problem, truth)[0], 0.0, 1e-9);
}

TEST(ResidualKind, HasANameForEveryKind) {
  std::set<std::string_view> names;
  const int kinds = static_cast<int>(ResidualKind::kMarginalPrior) + 1;
  for (int kind = 0; kind < kinds; ++kind) names.insert(Name(static_cast<ResidualKind>(kind)));
  EXPECT_EQ(names.size(), static_cast<std::size_t>(kinds));
  EXPECT_FALSE(names.contains(""));
}

// The arm rests at first and moves by the time the forearm's recording begins.
TEST(ArmProblem, LeavesOutRestsThatEndedBeforeItsFirstKnot) {
  Observations observations = Brisk(16).observations;
  observations.recordings[1] = Cut(observations.recordings[1], 6.0, 16.0);
  const ArmProblem problem(observations, {}, 0.1);
  for (const Term& term : problem.terms())
    EXPECT_FALSE(term.kind == ResidualKind::kZeroVelocity && term.first_knot == 0);
}

TEST(ArmProblem, BoundsWhatARestThatIsNoneCanSay) {
  const ArmProblem problem(Brisk(16).observations, {}, 0.1);
  for (const Term& term : problem.terms()) {
    const bool of_a_rest =
        term.kind == ResidualKind::kZeroVelocity || term.kind == ResidualKind::kGyroBiasRest;
    ASSERT_EQ(term.loss != nullptr, of_a_rest) << Name(term.kind);
    if (!of_a_rest) continue;
    double within[3], far[3];
    term.loss->Evaluate(4.0, within);
    term.loss->Evaluate(1e4, far);
    EXPECT_EQ(within[0], 4.0);
    EXPECT_LT(far[0], 1e3);
  }
}

}  // namespace
}  // namespace brachium
