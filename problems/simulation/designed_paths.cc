// Figures drawn on a desk.
//
// Source: Zhou et al. 2008, section 3.1: a circle of radius 0.1 m and a rectangle of 0.2 m x 0.14 m
// on a desk 0.75 m high, by persons who sit, for two minutes. Ours: a shoulder 1.05 m above the
// floor (Winter, stature 1.75 m), a wrist 3 cm above the desk, the figure's centre 0.33 m in front
// of the shoulder and 8 cm inward, about 4 s for a lap.

#include "problems/simulation/families.h"

namespace brachium {
namespace {

using Eigen::Vector3d;

const Vector3d kCentre(0.33, 0.78 - 1.05, -0.08);  // forward, up, right [m]
const Vector3d kElbow(-0.4, -1.0, 0.5);            // back, down and out
constexpr double kApproach = 1.5;                  // and return [s]
constexpr double kSettle = 0.5;                    // before and after [s]
constexpr double kMissed = 0.005;                  // of a corner, as told: people miss some [m]

JointValues Drawing() {
  JointValues posture = StartPoseJoints();
  posture[kForearmPronation] = 140 * kDegree;
  posture[kWristFlexion] = -15 * kDegree;
  return posture;
}

}  // namespace

Choreography Circle(const Task& task, Draws& draws) {
  constexpr double kRadius = 0.1;
  const Vector3d foremost = kCentre + Vector3d(kRadius, 0.0, 0.0);
  const HandPlace place{.p_T = foremost, .elbow_T = kElbow};
  const double lap = draws.Uniform(3.6, 4.4);
  Score score;
  score.Go(Drawing(), place, kApproach, kSettle);
  Choreography& choreography = score.choreography();
  choreography.circle_radius = kRadius;
  choreography.circle_start = score.time();
  choreography.lap = lap;
  // The first half lap gathers speed, the last half slows down: half a lap more of time.
  const double free = task.length - score.time() - 0.5 * lap - kSettle - kApproach;
  choreography.laps = static_cast<int>(free / lap);
  for (int i = 0; i < choreography.laps; ++i) {
    score.Go(Drawing(), place, lap, 0.0);
    const double start = choreography.circle_start + (0.5 + i) * lap;
    if (i + 1 < choreography.laps) score.Label("cycle:circle", start, start + lap);
  }
  score.WaitUntil(score.time() + 0.5 * lap + kSettle);
  score.Go(StartPoseJoints(), kApproach, 0.0);
  choreography.places = {{"circle.centre_m", kCentre}};
  return choreography;
}

Choreography Rectangle(const Task& task, Draws& draws) {
  constexpr double kWide = 0.2, kDeep = 0.14;
  constexpr double kSide = 0.9, kCorner = 0.1;  // time for a side, and at a corner [s]
  const std::array<Vector3d, 4> corners = {
      kCentre + 0.5 * Vector3d(kDeep, 0.0, kWide), kCentre + 0.5 * Vector3d(kDeep, 0.0, -kWide),
      kCentre + 0.5 * Vector3d(-kDeep, 0.0, -kWide), kCentre + 0.5 * Vector3d(-kDeep, 0.0, kWide)};
  const auto at = [](const Vector3d& corner) {
    return HandPlace{.p_T = corner, .elbow_T = kElbow};
  };
  Score score;
  std::vector<Contact>& contacts = score.choreography().contacts;
  for (std::size_t i = 0; i < corners.size(); ++i)
    contacts.push_back({.place = "corner_" + std::to_string(i + 1),
                        .segment = Segment::kForearm,
                        .times = {},
                        .sigma = kMissed});
  score.Go(Drawing(), at(corners[0]), kApproach, kSettle);
  while (score.time() + 4 * (1.1 * kSide + kCorner) + kSettle + kApproach <= task.length) {
    const double start = score.time();
    for (const std::size_t corner : {1u, 2u, 3u, 0u}) {
      score.Go(Drawing(), at(corners[corner]), kSide * draws.Uniform(0.9, 1.1), kCorner);
      contacts[corner].times.push_back(score.time() - 0.5 * kCorner);
    }
    score.Label("cycle:rectangle", start, score.time());
  }
  score.WaitUntil(score.time() + kSettle);
  score.Go(StartPoseJoints(), kApproach, 0.0);
  Choreography& choreography = score.choreography();
  for (std::size_t i = 0; i < corners.size(); ++i)
    choreography.places.emplace_back("rectangle.corner_" + std::to_string(i + 1) + "_m",
                                     corners[i]);
  return choreography;
}

}  // namespace brachium
