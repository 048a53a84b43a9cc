#include "solver/calibrate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "problems/joint_angles.h"
#include "problems/simulation/mirror.h"
#include "solver/calibration_movement.h"
#include "tests/support/simulated_trial.h"

namespace brachium {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;
using testing::Contains, testing::ElementsAre, testing::HasSubstr, testing::IsEmpty;
using testing::SizeIs;

SimulatedTrial Uncalibrated(Side side, const SoftTissue& soft_tissue = {}, std::uint64_t seed = 1) {
  SimulationOptions errors;
  errors.seed = seed;
  errors.tell_mountings = false;
  errors.soft_tissue = soft_tissue;
  return Simulate(MakeScenario({.name = "calibration", .seed = seed, .side = side}), errors);
}

// Angle from the true to the calibrated rotation [rad].
double ErrorOf(const SegmentCalibration& segment, const SimulatedTrial& simulated) {
  const auto& q = simulated.True(std::string(Name(segment.segment)) + ".q_BS_wxyz");
  return segment.mounting.q_BS.angularDistance(Quaterniond(q[0], q[1], q[2], q[3]));
}

Calibration Calibrated(const Observations& observations) { return Calibrate(observations, {}); }

void Relabel(const std::string& from, const std::string& to, Observations& observations) {
  for (Interval& interval : observations.intervals)
    if (interval.label == "calibration:" + from) interval.label = "calibration:" + to;
}

void Forget(const std::string& label, Observations& observations) {
  std::erase_if(observations.intervals, [&](const Interval& interval) {
    return interval.label.find(label) != std::string::npos;
  });
}

TEST(Calibrate, FindsBothMountingsOfEitherArmWithinADegree) {
  for (const Side side : {Side::kRight, Side::kLeft})
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
      const SimulatedTrial simulated = Uncalibrated(side, {}, seed);
      const Calibration calibration = Calibrated(simulated.trial.observations);
      EXPECT_THAT(calibration.faults, IsEmpty());
      EXPECT_THAT(calibration.notes, IsEmpty());
      ASSERT_THAT(calibration.segments, SizeIs(2));
      for (const SegmentCalibration& segment : calibration.segments)
        EXPECT_LT(ErrorOf(segment, simulated), 1 * kDegree)
            << Name(side) << " " << Name(segment.segment) << " " << seed;
    }
}

TEST(Calibrate, StaysWithinSomeOfItsSigmasUnderSoftTissue) {
  for (const Side side : {Side::kRight, Side::kLeft}) {
    const SimulatedTrial simulated = Uncalibrated(side, TypicalSoftTissue());
    for (const SegmentCalibration& segment : Calibrated(simulated.trial.observations).segments) {
      EXPECT_LT(ErrorOf(segment, simulated), 3 * segment.mounting.q_sigma) << Name(segment.segment);
      EXPECT_GT(segment.mounting.q_sigma, 2 * kDegree);
    }
  }
}

TEST(Calibrate, FindsTheMirroredArmAsItsMirrorImage) {
  const Trial trial = Uncalibrated(Side::kRight).trial;
  const Calibration right = Calibrated(trial.observations);
  const Calibration left = Calibrated(Mirrored(trial).observations);
  ASSERT_EQ(left.segments.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_LT(
        Mirrored(left.segments[i].mounting.q_BS).angularDistance(right.segments[i].mounting.q_BS),
        1e-9);
}

TEST(Calibrate, TellsHowManyRepetitionsAgreedAndHowWell) {
  const Calibration calibration = Calibrated(Uncalibrated(Side::kRight).trial.observations);
  for (const SegmentCalibration& segment : calibration.segments) {
    const auto figure = [&](const std::string& name) {
      return std::find_if(segment.figures.begin(), segment.figures.end(),
                          [&](const Figure& f) { return f.name == name; })
          ->value;
    };
    EXPECT_EQ(figure("y_repetitions"), 10);
    EXPECT_LT(figure("y_spread_deg"), 1.0);
    EXPECT_LT(std::abs(figure("x_off_square_deg")), 2.0);
  }
}

TEST(Calibrate, TurnsTheFrameOfAnUpperArmRoundWherePrintedFiveIsFollowed) {
  const SimulatedTrial simulated = Uncalibrated(Side::kRight);
  const Observations& observations = simulated.trial.observations;
  const Recording& recording = observations.recordings[0];
  ASSERT_EQ(recording.segment, Segment::kUpperArm);
  std::vector<std::string> faults;
  const auto abduction =
      MeasureMovements(recording, observations.intervals, "calibration:upper_arm_abduction",
                       {30 * kDegree, 25 * kDegree}, &faults)
          .front();
  const auto& q = simulated.True("upper_arm.q_BS_wxyz");
  const Vector3d dorsal_S = -(Quaterniond(q[0], q[1], q[2], q[3]).conjugate() * Vector3d::UnitX());
  const Vector3d printed_S = abduction.up_before_S.cross(abduction.up_after_S).normalized();
  EXPECT_LT(AngleBetween(-printed_S, dorsal_S), 2 * kDegree);
}

TEST(Calibrate, UsesWhatThereIsOfTwoDirectionsOfAMovement) {
  SimulatedTrial simulated = Uncalibrated(Side::kLeft);
  Forget("supination", simulated.trial.observations);
  Forget("exorotation", simulated.trial.observations);
  const Calibration calibration = Calibrated(simulated.trial.observations);
  ASSERT_THAT(calibration.segments, SizeIs(2));
  for (const SegmentCalibration& segment : calibration.segments)
    EXPECT_LT(ErrorOf(segment, simulated), 1 * kDegree);
}

TEST(Calibrate, RefusesWithTheNameOfWhatIsMissing) {
  Observations observations = Uncalibrated(Side::kRight).trial.observations;
  Observations no_abduction = observations;
  Forget("abduction", no_abduction);
  EXPECT_THAT(Calibrated(no_abduction).faults, ElementsAre(HasSubstr("upper_arm_abduction")));
  observations.intervals.clear();
  EXPECT_THAT(Calibrated(observations).faults,
              ElementsAre(HasSubstr("calibration:upper_arm_endorotation"),
                          HasSubstr("calibration:forearm_pronation")));
}

TEST(Calibrate, RefusesMovementsThatAreTooSmall) {
  Observations observations = Uncalibrated(Side::kRight).trial.observations;
  for (Recording& recording : observations.recordings)
    for (Vector3d& gyr : recording.gyr_S) gyr *= 0.1;
  const Calibration calibration = Calibrated(observations);
  EXPECT_THAT(calibration.faults, SizeIs(testing::Ge(2u)));
  EXPECT_THAT(calibration.notes, Contains(HasSubstr("turns the sensor by 16 deg")));
}

TEST(Calibrate, RefusesMovementsAboutTheWrongAxis) {
  Observations observations = Uncalibrated(Side::kRight).trial.observations;
  Relabel("upper_arm_abduction", "task", observations);
  Relabel("forearm_pronation", "upper_arm_abduction", observations);
  EXPECT_THAT(Calibrated(observations).faults, Contains(HasSubstr("upper_arm")));
}

TEST(Calibrate, RefusesLabelsThatAreExchangedAndTheWrongSide) {
  const Observations observations = Uncalibrated(Side::kRight).trial.observations;
  Observations wrong_side = observations;
  wrong_side.arm.side = Side::kLeft;
  EXPECT_THAT(Calibrated(wrong_side).faults, Contains(HasSubstr("the side is wrong")));

  Observations exchanged = observations;
  Relabel("upper_arm_endorotation", "other", exchanged);
  Relabel("upper_arm_exorotation", "upper_arm_endorotation", exchanged);
  Relabel("other", "upper_arm_exorotation", exchanged);
  EXPECT_THAT(Calibrated(exchanged).faults, Contains(HasSubstr("exchanged")));
}

// A trial of which only the forearm is to be calibrated, its two labels exchanged.
Observations ForearmWithExchangedLabels(Side side) {
  Observations observations = Uncalibrated(side).trial.observations;
  observations.recordings.erase(observations.recordings.begin());
  Relabel("forearm_pronation", "other", observations);
  Relabel("forearm_supination", "forearm_pronation", observations);
  Relabel("other", "forearm_supination", observations);
  return observations;
}

TEST(Calibrate, RefusesAForearmWithExchangedLabelsWhereTheHangingArmShowsIt) {
  for (const Side side : {Side::kRight, Side::kLeft}) {
    Observations posed = ForearmWithExchangedLabels(side);
    Forget("upper_arm", posed);
    EXPECT_THAT(Calibrated(posed).faults, ElementsAre(HasSubstr("exchanged")));
    ASSERT_TRUE(posed.start_pose);
    Forget("static_pose", posed);
    EXPECT_THAT(Calibrated(posed).faults, ElementsAre(HasSubstr("exchanged")));
  }
}

TEST(Calibrate, RefusesAForearmWithExchangedLabelsWhereTheAbductionShowsIt) {
  for (const Side side : {Side::kRight, Side::kLeft}) {
    Observations observations = ForearmWithExchangedLabels(side);
    Forget("static_pose", observations);
    observations.start_pose.reset();
    EXPECT_THAT(Calibrated(observations).faults, ElementsAre(HasSubstr("exchanged")));
  }
}

TEST(Calibrate, SaysThatNothingShowsExchangedLabelsOfAForearmAlone) {
  Observations observations = ForearmWithExchangedLabels(Side::kRight);
  Forget("static_pose", observations);
  Forget("upper_arm", observations);
  observations.start_pose.reset();
  const Calibration calibration = Calibrated(observations);
  EXPECT_THAT(calibration.faults, IsEmpty());
  EXPECT_THAT(calibration.notes, ElementsAre(HasSubstr("nothing shows")));
}

TEST(Calibrate, RefusesRepetitionsThatTurnBothWays) {
  Observations observations = Uncalibrated(Side::kRight).trial.observations;
  Relabel("forearm_supination", "forearm_pronation", observations);
  EXPECT_THAT(Calibrated(observations).faults, ElementsAre(HasSubstr("turn the other way")));
}

TEST(Calibrate, RefusesIntervalsWithoutARestAtTheirEnds) {
  Observations observations = Uncalibrated(Side::kRight).trial.observations;
  for (Interval& interval : observations.intervals) {
    interval.start += 0.65;
    interval.end -= 0.65;
  }
  const Calibration calibration = Calibrate(observations, {.least_turn_deg = 10.0});
  EXPECT_THAT(calibration.notes, Contains(HasSubstr("at rest")));
}

TEST(Calibrate, KeepsAToldMountingWhereNothingIsLabelledAndAPositionWhereItIs) {
  SimulatedTrial simulated = Uncalibrated(Side::kRight);
  Observations& observations = simulated.trial.observations;
  Forget("forearm", observations);
  observations.recordings[1].mounting = Mounting{.p_BS_B = {0.0, -0.2, 0.0}};
  observations.recordings[0].mounting = Mounting{.p_BS_B = {0.0, -0.1, 0.0}};
  const Calibration calibration = Calibrated(observations);
  EXPECT_THAT(calibration.faults, IsEmpty());
  ASSERT_THAT(calibration.segments, SizeIs(1));
  EXPECT_EQ(calibration.segments[0].mounting.p_BS_B, Vector3d(0.0, -0.1, 0.0));
  EXPECT_LT(ErrorOf(calibration.segments[0], simulated), 1 * kDegree);
  EXPECT_THAT(calibration.notes, ElementsAre(HasSubstr("kept")));
}

TEST(Calibrate, TakesAStaticPoseOfRecordingsThatCarryTheMakersOrientation) {
  SimulatedTrial simulated = Uncalibrated(Side::kRight);
  Observations& observations = simulated.trial.observations;
  for (const char* segment : {"forearm", "upper_arm"}) Forget(segment, observations);
  for (Recording& recording : observations.recordings) {
    const auto& q = simulated.True(std::string(Name(recording.segment)) + ".q_BS_wxyz");
    for (const Quaterniond& q_VB : simulated.trial.reference->q_VB.at(recording.segment))
      recording.q_WS.push_back(q_VB * Quaterniond(q[0], q[1], q[2], q[3]));
  }
  const double facing = MakeScenario({.name = "calibration", .seed = 1}).trunk_heading;
  const Calibration calibration = Calibrate(observations, {.facing_deg = facing / kDegree});
  ASSERT_THAT(calibration.segments, SizeIs(2));
  // The simulated arm hangs 8 deg abducted, its elbow bent by 10 deg and in valgus.
  EXPECT_NEAR(ErrorOf(calibration.segments[0], simulated) / kDegree, 8.0, 0.1);
  EXPECT_LT(ErrorOf(calibration.segments[1], simulated) / kDegree, 23.0);
}

}  // namespace
}  // namespace brachium
