#include "solver/observability.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "solver/batch_smoother.h"
#include "tests/support/assess_at.h"
#include "tests/support/overstretched.h"
#include "tests/support/simulated_trial.h"

namespace brachium {
namespace {

using testing::AllOf, testing::ElementsAre, testing::HasSubstr, testing::IsEmpty, testing::Key,
    testing::Contains, testing::Not;

Estimate Smooth(const Observations& observations, SmootherOptions options = {}) {
  return BatchSmoother(options).Run(observations);
}

// The information of all relations in all spans [1/rad²].
double Information(const HeadingSupport& support) {
  double sum = 0.0;
  for (const auto& [kind, sd] : support.sd_by)
    for (const double value : sd)
      if (std::isfinite(value)) sum += 1 / (value * value);
  return sum;
}

TEST(Headings, AreDescribedForEachSegmentAgainstTheOneBeforeInSpansOfTheTrial) {
  const Estimate estimate = Smooth(Brisk(16).observations);
  ASSERT_EQ(estimate.diagnostics.headings.size(), 1u);
  const HeadingSupport& elbow = estimate.diagnostics.headings.front();
  EXPECT_EQ(elbow.segment, Segment::kForearm);
  EXPECT_EQ(elbow.against, Segment::kUpperArm);
  ASSERT_EQ(elbow.time.size(), 3u);
  EXPECT_NEAR(elbow.time[0], 16.0 / 6, 0.1);
  EXPECT_NEAR(elbow.time[2], 16.0 * 5 / 6, 0.1);
  EXPECT_EQ(elbow.sd.size(), 3u);
  for (const auto& [kind, sd] : elbow.sd_by) EXPECT_EQ(sd.size(), 3u) << kind;
}

// A turn of everything beyond the elbow leaves gyroscopes and chains as they were.
TEST(Headings, AreHeldByTheMovingElbowAndByItsAdductionButNotByGyroscopesOrChains) {
  const Estimate estimate = Smooth(Brisk(16).observations);
  const auto& sd_by = estimate.diagnostics.headings.front().sd_by;
  EXPECT_THAT(sd_by, Contains(Key("accelerometer")));
  EXPECT_THAT(sd_by, Contains(Key("elbow_adduction")));
  EXPECT_THAT(sd_by, Contains(Key("start_pose")));
  EXPECT_THAT(sd_by, Not(Contains(Key("gyroscope"))));
  EXPECT_THAT(sd_by, Not(Contains(Key("segment_chain"))));
  const std::vector<double>& moving = sd_by.at("accelerometer");
  EXPECT_LT(moving[1], 2 * kDegree);
}

TEST(Headings, AreNotSaidToBeHeldByAStop) {
  ArmProblem problem(Brisk(16).observations, {}, 0.1);
  State state = Overstretched(problem);
  problem.FixHeadings(state);
  PoseCovariance poses(problem, state);
  AssessAt(problem, state, &poses);
  const HeadingSupport elbow = DescribeHeadings(problem, state, poses).front();
  EXPECT_THAT(elbow.sd_by, Contains(Key("start_pose")));
  EXPECT_THAT(elbow.sd_by, Not(Contains(Key("range_of_motion"))));
}

TEST(Headings, AreAsCertainAsWhatHeldThem) {
  for (const double duration : {16.0, 30.0}) {
    const Estimate estimate = Smooth(Brisk(duration).observations);
    const HeadingSupport& elbow = estimate.diagnostics.headings.front();
    const double best = 1 / std::sqrt(Information(elbow));
    for (const double sd : elbow.sd) {
      EXPECT_GT(sd, 0.9 * best);
      EXPECT_LT(sd, 10 * best);
    }
  }
}

// A still arm tells by its pose alone.
TEST(Headings, OfAStillHangingArmAreHeldByTheStartPoseAlone) {
  Observations observations = Brisk(16).observations;
  for (Recording& recording : observations.recordings) recording = Cut(recording, 0.0, 2.8);
  const Estimate told = Smooth(observations);
  const HeadingSupport& held = told.diagnostics.headings.front();
  EXPECT_NEAR(held.sd_by.at("start_pose").front() / kDegree, 10.0, 3.0);

  observations.start_pose.reset();
  const Estimate untold = Smooth(observations);
  const HeadingSupport& loose = untold.diagnostics.headings.front();
  EXPECT_GT(loose.sd.front(), 20 * kDegree);
  EXPECT_THAT(untold.diagnostics.notes,
              Contains(AllOf(HasSubstr("heading of the forearm against the upper_arm"),
                             HasSubstr("little held throughout"))));
}

// A forearm that turns about the elbow takes a place that it touches once with it.
TEST(Headings, AreNotHeldByAPlaceThatIsTouchedOnceButByOneThatIsTouchedAgain) {
  Trial trial = Brisk(16);
  const auto& reference = *trial.reference;
  Contact wrist{.place = "here", .segment = Segment::kForearm, .times = {6.0}};
  const auto support = [&] {
    trial.observations.contacts = {wrist};
    return Smooth(trial.observations).diagnostics.headings.front();
  };
  EXPECT_THAT(support().sd_by, Not(Contains(Key("contact"))));
  const auto place = [&](std::size_t i) { return reference.p_V.at("wrist")[i]; };
  std::size_t again = 700;  // any other instant, told as loosely as it is off
  for (std::size_t i = 700; i < 1200; ++i)
    if ((place(i) - place(600)).norm() < (place(again) - place(600)).norm()) again = i;
  wrist.times.push_back(reference.time[again]);
  wrist.sigma = std::max(0.01, (place(again) - place(600)).norm());
  EXPECT_THAT(support().sd_by, Contains(Key("contact")));
}

TEST(Headings, HaveNoStandardDeviationsWhereNoneAreAskedFor) {
  SmootherOptions options;
  options.covariance = false;
  EXPECT_THAT(Smooth(Brisk(16).observations, options).diagnostics.headings, IsEmpty());
}

TEST(Headings, NotHeldAreNamedByStretches) {
  HeadingSupport support{
      .time = {2.5, 7.5, 12.5, 17.5, 22.5}, .sd = {0.02, 0.3, 0.5, 0.02, 0.2}, .sd_by = {}};
  EXPECT_THAT(HeadingsNotHeld({support}),
              ElementsAre(AllOf(HasSubstr("from 5 to 15 s"), HasSubstr("up to 29 deg")),
                          AllOf(HasSubstr("from 20 to 25 s"), HasSubstr("up to 11 deg"))));
  support.sd.clear();
  EXPECT_THAT(HeadingsNotHeld({support}), IsEmpty());
}

}  // namespace
}  // namespace brachium
