// The eating and the morning routine.
//
// Source: Luinge et al. 2007, section 2.4: the activities, their order and their seconds. Ours: how
// each is done, as a cycle of hand places that is repeated until its time is up. Teeth are brushed
// with the upper arm out and the flexion axis nearly vertical, where the paper's filter drifts.
#include <algorithm>

#include "problems/simulation/families.h"

namespace brachium {
namespace {

using Eigen::Vector3d;

constexpr double kHomeward = 1.5;  // the last movement [s]

// A place of the wrist, forward, up and right of the shoulder [m], with the forearm's pronation and
// the wrist's flexion [deg]; reached within `duration`, then kept for `pause` [s].
struct Station {
  Vector3d wrist_T;
  Vector3d elbow_T;
  double pronation = 90.0;
  double wrist_flexion = 0.0;
  double duration = 0.8;
  double pause = 0.2;
};

struct Activity {
  const char* name;
  double seconds;
  std::vector<Station> cycle;
};

// Where the elbow is kept: hanging, out, and as high as the shoulder.
const Vector3d kDown(-0.3, -1.0, 0.3), kOut(0.2, -0.7, 0.9), kHigh(0.4, -0.2, 0.9);

const Vector3d kPlate(0.32, -0.22, -0.10), kMouth(0.20, 0.05, -0.13), kGlass(0.38, -0.20, 0.0);

Station Shifted(Station station, const Vector3d& shift_T) {
  station.wrist_T += shift_T;
  return station;
}

// `station`, and `shift` away from it, to and fro.
void AddStrokes(const Station& station, const Vector3d& shift_T, int strokes,
                std::vector<Station>& cycle) {
  for (int i = 0; i < strokes; ++i) {
    cycle.push_back(Shifted(station, shift_T));
    cycle.push_back(station);
  }
}

Activity Pouring() {
  return {"pouring",
          10,
          {{.wrist_T = {0.36, -0.18, 0.10}, .elbow_T = kDown, .duration = 1.0, .pause = 0.3},
           {.wrist_T = {0.36, -0.02, 0.0}, .elbow_T = kOut, .duration = 0.9},
           {.wrist_T = {0.36, -0.02, -0.04},
            .elbow_T = kOut,
            .pronation = 150,
            .duration = 0.9,
            .pause = 0.8},
           {.wrist_T = {0.36, -0.02, 0.0}, .elbow_T = kOut, .duration = 0.8, .pause = 0.0},
           {.wrist_T = {0.36, -0.18, 0.10}, .elbow_T = kDown, .duration = 0.9, .pause = 0.4}}};
}

Activity Soup() {
  return {"soup",
          20,
          {{.wrist_T = kPlate, .elbow_T = kDown, .pronation = 130, .duration = 0.9, .pause = 0.0},
           {.wrist_T = kPlate + Vector3d(0.05, 0.02, 0.0),
            .elbow_T = kDown,
            .pronation = 95,
            .duration = 0.5},
           {.wrist_T = kMouth, .elbow_T = kOut, .pronation = 70, .duration = 1.2, .pause = 0.6}}};
}

Activity Spaghetti() {
  const Station fork{.wrist_T = kPlate, .elbow_T = kDown, .pronation = 150, .pause = 0.0};
  Activity activity{"spaghetti", 20, {fork}};
  for (const double pronation : {100.0, 155.0, 100.0, 155.0, 100.0}) {
    Station twirl = fork;
    twirl.pronation = pronation;
    twirl.duration = 0.45;
    activity.cycle.push_back(twirl);
  }
  activity.cycle.push_back(
      {.wrist_T = kMouth, .elbow_T = kOut, .pronation = 80, .duration = 1.0, .pause = 0.7});
  return activity;
}

Activity Meat() {
  const Station knife{.wrist_T = kPlate,
                      .elbow_T = kOut,
                      .pronation = 150,
                      .wrist_flexion = 10,
                      .duration = 0.4,
                      .pause = 0.0};
  Activity activity{"meat", 30, {Shifted(knife, {0.0, 0.02, 0.0})}};
  activity.cycle[0].duration = 0.9;
  AddStrokes(knife, {-0.08, 0.02, 0.04}, 4, activity.cycle);
  activity.cycle.push_back(
      {.wrist_T = kMouth, .elbow_T = kOut, .pronation = 100, .duration = 1.1, .pause = 0.8});
  return activity;
}

Activity Drinking() {
  return {"drinking",
          10,
          {{.wrist_T = kGlass, .elbow_T = kDown, .duration = 0.9, .pause = 0.4},
           {.wrist_T = kMouth, .elbow_T = kDown, .pronation = 80, .duration = 1.1},
           {.wrist_T = kMouth + Vector3d(0.0, 0.04, 0.0),
            .elbow_T = kOut,
            .pronation = 105,
            .duration = 0.6,
            .pause = 0.8},
           {.wrist_T = kGlass, .elbow_T = kDown, .duration = 1.1, .pause = 0.5}}};
}

Activity Face() {
  const Station face{.wrist_T = {0.20, 0.10, -0.08},
                     .elbow_T = {0.2, -0.6, 0.6},
                     .pronation = 40,
                     .duration = 0.3,
                     .pause = 0.0};
  Activity activity{"face",
                    10,
                    {{.wrist_T = {0.36, -0.22, -0.12},
                      .elbow_T = kDown,
                      .pronation = 25,
                      .wrist_flexion = 15,
                      .duration = 0.8,
                      .pause = 0.3}}};
  activity.cycle.push_back(face);
  activity.cycle.back().duration = 0.7;
  AddStrokes(face, {0.0, -0.05, 0.03}, 3, activity.cycle);
  return activity;
}

Activity Deodorant() {
  const Station armpit{.wrist_T = {0.20, -0.12, -0.22},
                       .elbow_T = kOut,
                       .pronation = 60,
                       .wrist_flexion = 20,
                       .duration = 0.35,
                       .pause = 0.0};
  Activity activity{"deodorant", 10, {armpit}};
  activity.cycle[0].duration = 1.2;
  AddStrokes(armpit, {0.02, -0.08, 0.02}, 4, activity.cycle);
  activity.cycle.back().pause = 0.6;
  return activity;
}

Activity Buttoning() {
  Activity activity{"buttoning", 10, {}};
  for (int button = 0; button < 5; ++button) {
    const Vector3d place(0.24, -0.04 - 0.05 * button, -0.12);
    activity.cycle.push_back({.wrist_T = place,
                              .elbow_T = kDown,
                              .pronation = 110,
                              .wrist_flexion = 20,
                              .duration = 0.5});
    activity.cycle.push_back({.wrist_T = place + Vector3d(0.01, 0.0, 0.02),
                              .elbow_T = kDown,
                              .pronation = 75,
                              .wrist_flexion = 30,
                              .duration = 0.4});
  }
  return activity;
}

Activity Combing() {
  const Vector3d elbow(0.7, 0.4, 0.7);
  return {"combing",
          20,
          {{.wrist_T = {0.20, 0.22, -0.02},
            .elbow_T = elbow,
            .pronation = 70,
            .wrist_flexion = 10,
            .duration = 0.7},
           {.wrist_T = {0.06, 0.26, 0.02},
            .elbow_T = elbow,
            .pronation = 90,
            .wrist_flexion = 20,
            .duration = 0.7,
            .pause = 0.0},
           {.wrist_T = {0.12, 0.16, 0.06},
            .elbow_T = elbow,
            .pronation = 95,
            .wrist_flexion = 10,
            .duration = 0.6,
            .pause = 0.1}}};
}

Activity Brushing() {
  const Station teeth{.wrist_T = {0.24, 0.03, -0.08},
                      .elbow_T = kHigh,
                      .pronation = 100,
                      .duration = 0.25,
                      .pause = 0.0};
  Activity activity{"brushing_teeth", 30, {teeth}};
  activity.cycle[0].duration = 0.6;
  AddStrokes(teeth, {0.0, 0.005, 0.04}, 8, activity.cycle);
  AddStrokes(Shifted(teeth, {0.02, 0.0, 0.0}), {0.01, -0.02, 0.02}, 6, activity.cycle);
  return activity;
}

// Nobody does it twice in the same way: places 1 cm, angles 4 deg, times 10 % more or less.
void GoTo(const Station& station, Draws& draws, Score& score) {
  JointValues posture = StartPoseJoints();
  posture[kForearmPronation] =
      std::clamp(station.pronation + 4.0 * draws.Normal(), 5.0, 170.0) * kDegree;
  posture[kWristFlexion] = (station.wrist_flexion + 4.0 * draws.Normal()) * kDegree;
  const Vector3d spread(draws.Uniform(-0.01, 0.01), draws.Uniform(-0.01, 0.01),
                        draws.Uniform(-0.01, 0.01));
  score.Go(posture, HandPlace{.p_T = station.wrist_T + spread, .elbow_T = station.elbow_T},
           station.duration * draws.Uniform(0.9, 1.1), station.pause * draws.Uniform(0.9, 1.1));
}

// Again and again, for as long as the time allows; what is left of it the hand stays.
void Perform(const Activity& activity, Draws& draws, Score& score) {
  constexpr double kSlowest = 1.1;
  const double start = score.time(), end = start + activity.seconds;
  for (std::size_t i = 0;; i = (i + 1) % activity.cycle.size()) {
    const Station& station = activity.cycle[i];
    if (score.time() + kSlowest * (station.duration + station.pause) > end) break;
    GoTo(station, draws, score);
  }
  score.WaitUntil(end);
  score.Label(std::string("task:") + activity.name, start, end);
}

Choreography Routine(const std::vector<Activity>& activities, Draws& draws) {
  Score score;
  for (const Activity& activity : activities) Perform(activity, draws, score);
  score.Go(StartPoseJoints(), kHomeward, 0.0);
  return score.choreography();
}

}  // namespace

Choreography Eating(const Task&, Draws& draws) {
  return Routine({Pouring(), Soup(), Spaghetti(), Meat(), Drinking()}, draws);
}

Choreography Morning(const Task&, Draws& draws) {
  return Routine({Face(), Deodorant(), Buttoning(), Combing(), Brushing()}, draws);
}

}  // namespace brachium
