// What an estimate gains by poses and contacts that are told.
#include <gtest/gtest.h>

#include "solver/batch_smoother.h"
#include "tests/support/simulated_trial.h"

namespace brachium {
namespace {

using Eigen::Vector3d;

// A wrist led around a rectangle by a shoulder that wanders; it meets each corner once a lap.
Trial Rectangle() {
  SimulationOptions errors;
  errors.tell_contacts = true;
  return Simulate(MakeScenario({.name = "rectangle", .seed = 2, .duration = 60.0}), errors).trial;
}

Trial Untold(Trial trial) {
  trial.observations.contacts.clear();
  return trial;
}

Estimate Smoothed(const Trial& trial, bool whole_trial = true) {
  return BatchSmoother({.whole_trial = whole_trial, .model = {}}).Run(trial.observations);
}

// How far the points are from one another over the trial, as seen by rms spread about their mean.
double Spread(const std::vector<Vector3d>& points) {
  Vector3d mean = Vector3d::Zero();
  for (const Vector3d& point : points) mean += point / static_cast<double>(points.size());
  double squares = 0.0;
  for (const Vector3d& point : points) squares += (point - mean).squaredNorm();
  return std::sqrt(squares / static_cast<double>(points.size()));
}

// Rms over all corners of how far from its mean place the wrist is found where it touches one.
double SpreadAtCorners(const Trial& trial, const Estimate& estimate) {
  std::vector<double> spreads;
  for (const Contact& contact : trial.observations.contacts) {
    std::vector<Vector3d> touches;
    for (const double time : contact.times)
      touches.push_back(estimate.p_W.at("wrist")[static_cast<std::size_t>(time * 100.0)]);
    spreads.push_back(Spread(touches));
  }
  return Rms(spreads);
}

double MeanSd(const Estimate& estimate, const std::string& joint) {
  double sum = 0.0;
  for (const Vector3d& sd : estimate.sd_W.at(joint)) sum += sd.norm();
  return sum / static_cast<double>(estimate.time.size());
}

TEST(Contacts, BringTheWristBackToWhereItWas) {
  const Trial told = Rectangle();
  const Estimate with = Smoothed(told), without = Smoothed(Untold(told));
  EXPECT_TRUE(with.diagnostics.converged);
  EXPECT_FALSE(with.diagnostics.singular);
  EXPECT_LT(SpreadAtCorners(told, with), 0.5 * SpreadAtCorners(told, without));
}

TEST(Contacts, MakeTheShoulderMoreCertain) {
  const Trial told = Rectangle();
  EXPECT_LT(MeanSd(Smoothed(told), "shoulder"), 0.7 * MeanSd(Smoothed(Untold(told)), "shoulder"));
}

TEST(Contacts, LeaveTheElbowAsItIs) {
  const Trial told = Rectangle();
  EXPECT_LT(RelativeError(Smoothed(told), *told.reference), 0.3 * kDegree);
}

TEST(Contacts, AreUnderstoodByWindowsAlone) {
  const Trial told = Rectangle();
  const Estimate with = Smoothed(told, false), without = Smoothed(Untold(told), false);
  EXPECT_FALSE(with.diagnostics.singular);
  EXPECT_LT(SpreadAtCorners(told, with), 0.7 * SpreadAtCorners(told, without));
}

// A still arm is found alike by its pose at the start and by the same one at the end.
TEST(EndPose, TellsTheHeadingOfAnArmAsTheStartPoseDoes) {
  Trial trial = Brisk(16);
  Observations& observations = trial.observations;
  for (Recording& recording : observations.recordings) recording = Cut(recording, 0.0, 2.8);
  const Estimate by_start = Smoothed(trial);
  observations.end_pose = observations.start_pose;
  observations.end_pose->time = 2.7;
  observations.start_pose.reset();
  const Estimate by_end = Smoothed(trial);
  observations.end_pose.reset();
  const Estimate by_none = Smoothed(trial);
  const auto sd = [](const Estimate& estimate) {
    return estimate.diagnostics.headings.front().sd.front();
  };
  EXPECT_LT(RmsAngle(ForearmInUpperArm(by_start.q_WB), ForearmInUpperArm(by_end.q_WB)),
            2 * kDegree);
  EXPECT_LT(sd(by_end), 15 * kDegree);
  EXPECT_GT(sd(by_none), 20 * kDegree);
}

}  // namespace
}  // namespace brachium
