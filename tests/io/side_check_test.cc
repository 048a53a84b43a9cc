#include "io/side_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "problems/rotation.h"
#include "tests/support/spoiled_trials.h"

namespace brachium {
namespace {

using Eigen::AngleAxisd, Eigen::Vector3d, testing::HasSubstr;

// Two seconds of a right arm that is held still: how far the upper arm is raised forward and to the
// side, the elbow's flexion and the forearm's pronation [deg].
struct Held {
  double forward = 0.0, aside = 0.0, flexion = 90.0, pronation = 90.0;
};

Observations Holding(const Held& held, Side told) {
  const auto about = [](double degrees, const Vector3d& axis) {
    return AngleAxisd(degrees * kDegree, axis);
  };
  const Vector3d X = Vector3d::UnitX(), Y = Vector3d::UnitY(), Z = Vector3d::UnitZ();
  const Vector3d up_U = about(held.forward, Z).inverse() * (about(held.aside, X).inverse() * Y);
  const Vector3d up_F =
      about(held.pronation, Y).inverse() * (about(held.flexion, Z).inverse() * up_U);
  Observations observations;
  observations.arm.side = told;
  for (const auto& [segment, up] :
       {std::pair{Segment::kUpperArm, up_U}, std::pair{Segment::kForearm, up_F}}) {
    Recording recording;
    recording.segment = segment;
    for (int i = 0; i < 200; ++i) {
      recording.time.push_back(0.01 * i);
      recording.gyr_S.emplace_back(Vector3d::Zero());
      recording.acc_S.emplace_back(kGravity * up);
    }
    recording.mounting = Mounting{};
    observations.recordings.push_back(recording);
  }
  return observations;
}

std::string Said(const Observations& observations) {
  Findings findings;
  CheckSide(observations, &findings);
  return findings.warnings.empty() ? "" : findings.warnings.front();
}

std::string Said(const Held& held, Side told) { return Said(Holding(held, told)); }

constexpr Held kShown[] = {
    {},
    {.flexion = 45.0, .pronation = 35.0},
    {.flexion = 130.0, .pronation = 145.0},
    {.forward = 40.0, .flexion = 100.0},
    {.forward = -30.0, .flexion = 80.0, .pronation = 120.0},
    {.aside = 40.0, .flexion = 90.0, .pronation = 35.0},
    {.aside = -40.0, .flexion = 90.0, .pronation = 145.0},
    {.forward = 150.0, .flexion = 90.0},
};

TEST(SideCheck, NamesTheWrongSideWhereverTheUpperArmIsHeld) {
  for (const Held& held : kShown)
    EXPECT_THAT(Said(held, Side::kLeft), HasSubstr("[side]"))
        << held.forward << " " << held.aside << " " << held.flexion << " " << held.pronation;
}

TEST(SideCheck, IsSilentOnTheRightOne) {
  for (const Held& held : kShown)
    EXPECT_EQ(Said(held, Side::kRight), "")
        << held.forward << " " << held.aside << " " << held.flexion << " " << held.pronation;
}

TEST(SideCheck, IsSilentWhereNothingShowsIt) {
  for (const Held& held : {Held{.flexion = 10.0}, Held{.pronation = 0.0}, Held{.pronation = 180.0},
                           Held{.aside = 80.0}, Held{.forward = -60.0, .flexion = 90.0},
                           Held{.forward = 90.0, .flexion = 130.0}})
    for (const Side told : {Side::kRight, Side::kLeft})
      EXPECT_EQ(Said(held, told), "")
          << held.forward << " " << held.aside << " " << held.flexion << " " << held.pronation;
}

TEST(SideCheck, IsSilentWithoutMountings) {
  for (const std::size_t sensor : {0, 1}) {
    Observations observations = Holding({}, Side::kLeft);
    observations.recordings[sensor].mounting.reset();
    EXPECT_EQ(Said(observations), "") << sensor;
  }
}

TEST(SideCheck, IsSilentWhereEitherSegmentFeelsMoreThanGravityMostOfTheTime) {
  for (const std::size_t sensor : {0, 1}) {
    Observations observations = Holding({}, Side::kLeft);
    for (std::size_t i = 0; i < 100; ++i) observations.recordings[sensor].acc_S[i] *= 1.2;
    EXPECT_EQ(Said(observations), "") << sensor;
  }
}

// For nearly half of the time nothing shows; the upper arm's sensor is twice as fast.
TEST(SideCheck, PutsTogetherWhatWasMeasuredAtTheSameTime) {
  const Observations first = Holding({.pronation = 0.0}, Side::kLeft);
  Observations observations = Holding({.aside = 40.0}, Side::kLeft);
  for (const std::size_t sensor : {0, 1})
    for (std::size_t i = 0; i < 90; ++i)
      observations.recordings[sensor].acc_S[i] = first.recordings[sensor].acc_S[i];
  Recording& upper = observations.recordings[0];
  const Recording slow = upper;
  for (std::size_t i = 0; i < 200; ++i) {
    upper.time.insert(upper.time.begin() + static_cast<std::ptrdiff_t>(2 * i + 1),
                      slow.time[i] + 0.005);
    upper.acc_S.insert(upper.acc_S.begin() + static_cast<std::ptrdiff_t>(2 * i + 1), slow.acc_S[i]);
  }
  EXPECT_THAT(Said(observations), HasSubstr("pronation -1.00"));
}

}  // namespace
}  // namespace brachium
