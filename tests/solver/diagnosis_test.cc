#include "solver/diagnosis.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "solver/window.h"
#include "tests/support/assess_at.h"
#include "tests/support/simulated_trial.h"

namespace brachium {
namespace {

using testing::Contains, testing::HasSubstr, testing::IsEmpty, testing::Not;

struct Solved {
  ArmProblem problem;
  State state;
  Certainty certainty;

  explicit Solved(const Observations& observations)
      : problem(observations, {}, 0.1), state(problem.PriorState()) {
    SolveForward(problem, state, {}, {});
    Solve(problem, state, {}, 0, problem.timeline().Intervals(), {});
    certainty = AssessAt(problem, state);
  }
};

// The rest before the first movement: nothing turns.
Observations Still() {
  Observations observations = Brisk(16).observations;
  for (Recording& recording : observations.recordings) recording = Cut(recording, 0.0, 2.8);
  return observations;
}

TEST(ResidualStatistics, AddUpToTheCost) {
  Solved solved(Brisk(16).observations);
  const auto statistics = DescribeResiduals(solved.problem, solved.state);
  double cost = 0.0;
  std::size_t count = 0;
  for (const ResidualStatistics& kind : statistics) {
    cost += 0.5 * static_cast<double>(kind.count) * kind.rms * kind.rms;
    count += kind.count;
  }
  const auto summary =
      Solve(solved.problem, solved.state, {}, 0, solved.problem.timeline().Intervals(), {});
  EXPECT_NEAR(cost / summary.initial_cost, 1.0, 1e-9);
  std::size_t expected = 0;
  for (const Term& term : solved.problem.terms())
    expected += static_cast<std::size_t>(term.cost->num_residuals());
  EXPECT_EQ(count, expected);
  EXPECT_THAT(statistics, Contains(testing::Field(&ResidualStatistics::kind, "gyroscope/forearm")));
}

TEST(Constants, AreNamedInTheirUnitAndCarryTheirStandardDeviation) {
  Solved solved(Brisk(16).observations);
  const auto constants = DescribeConstants(solved.problem, solved.state, solved.certainty);
  std::map<std::string, Constant> by_name;
  for (const Constant& constant : constants) by_name[constant.name] = constant;
  EXPECT_EQ(by_name.size(), constants.size());
  const double* k = solved.state.Constant(UnknownKind::kCarryingAngle, -1);
  const Constant& carrying = by_name.at("elbow.carrying_angle_deg");
  EXPECT_NEAR(carrying.value.at(0), k[0] / kDegree, 1e-9);
  EXPECT_GT(carrying.sd.at(0), 0.0);
  EXPECT_LT(carrying.sd.at(0), 8.0);
  EXPECT_EQ(by_name.at("forearm.p_BS_m").value.size(), 3u);
  EXPECT_EQ(by_name.at("forearm.p_BS_m").sd.size(), 3u);
  EXPECT_TRUE(by_name.contains("upper_arm.accelerometer_bias_m_s2"));
}

TEST(Constants, TellWhereTheTouchedPlacesAre) {
  Trial trial = Brisk(16);
  trial.observations.contacts = {
      {.place = "start", .segment = Segment::kForearm, .times = {1.0, 2.0, 15.5}},
      {.place = "low", .segment = Segment::kForearm, .times = {0.5, 15.0}, .height_only = true}};
  Solved solved(trial.observations);
  std::map<std::string, Constant> by_name;
  for (const Constant& constant : DescribeConstants(solved.problem, solved.state, solved.certainty))
    by_name[constant.name] = constant;
  const Constant &place = by_name.at("contact.start_m"),
                 &height = by_name.at("contact.low_height_m");
  ASSERT_EQ(place.value.size(), 3u);
  ASSERT_EQ(height.value.size(), 1u);
  EXPECT_NEAR(place.value[2], height.value[0], 0.02);
  EXPECT_LT(place.sd.at(2), 0.02);
  EXPECT_LT(height.sd.at(0), 0.02);
  for (const std::string& sentence : HeldByPrior(solved.problem, solved.certainty))
    EXPECT_THAT(sentence, Not(HasSubstr("contact.")));
}

TEST(HeldByPrior, NamesWhatAStillArmCannotTell) {
  const Solved solved(Still());
  const auto sentences = HeldByPrior(solved.problem, solved.certainty);
  EXPECT_THAT(sentences, Contains(HasSubstr("forearm.p_BS_m (x, y, z)")));
  EXPECT_THAT(sentences, Contains(HasSubstr("upper_arm.accelerometer_scale")));
  EXPECT_THAT(sentences, Not(Contains(HasSubstr("gyro_bias (x, y, z)"))));
}

TEST(HeldByPrior, NamesTheHeadingOfASensorAlone) {
  Observations alone = Brisk(16).observations;
  alone.recordings.erase(alone.recordings.begin());
  const Solved solved(alone);
  EXPECT_THAT(HeldByPrior(solved.problem, solved.certainty),
              Contains(HasSubstr("heading of the forearm")));
}

TEST(HeldByPrior, SaysLessOfAnArmThatMoves) {
  const Solved still(Still()), moving(Brisk(16).observations);
  const auto sentences = HeldByPrior(moving.problem, moving.certainty);
  EXPECT_LT(sentences.size(), HeldByPrior(still.problem, still.certainty).size());
  EXPECT_THAT(sentences, Not(Contains(HasSubstr("forearm.p_BS_m"))));
}

TEST(Rests, AreListedWithTheirSegment) {
  const Solved solved(Still());
  const auto rests = DescribeRests(solved.problem);
  for (const Segment segment : {Segment::kUpperArm, Segment::kForearm})
    EXPECT_THAT(rests, Contains(testing::Field(&Rest::segment, segment)));
  for (const Rest& rest : rests) {
    EXPECT_LT(rest.start, rest.end);
    EXPECT_GT(rest.certainty, 0.0);
    EXPECT_LE(rest.certainty, 1.0);
  }
}

TEST(FarFromTold, NamesALeverArmThatWasToldWrong) {
  Observations observations = Brisk(16).observations;
  observations.recordings[1].mounting->p_BS_B.y() += 0.08;
  const Solved solved(observations);
  EXPECT_THAT(FarFromTold(solved.problem, solved.state),
              Contains(HasSubstr("forearm.p_BS_m (y) is found at")));
}

TEST(FarFromTold, SaysNothingOfAnHonestTrial) {
  const Solved solved(Brisk(16).observations);
  EXPECT_THAT(FarFromTold(solved.problem, solved.state), IsEmpty());
}

}  // namespace
}  // namespace brachium
