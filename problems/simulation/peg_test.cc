// The nine-hole peg test: pegs are taken from a bowl one by one and put into holes 1 to 9.
//
// Sources: Bai et al. 2015, sections II.F and III.C: four sensors, holes in order, rows 1-2-3, 4-5-6,
// 7-8-9 across and columns in depth, healthy in about 20 s, the patient's shoulder shifted by
// 5-10 cm, a bowl that is not met at the same place. Mathiowetz et al. 1985: holes 3.2 cm apart, the
// bowl on the side of the hand that is tested. Ours: board and bowl on a desk 0.75 m high, 0.42 m in
// front of the shoulder. The fingertip comes to the bowl, but for where it misses it, nine times, and
// eighteen times down to the height of bowl and board.
#include <cmath>

#include "problems/simulation/families.h"
#include "problems/simulation/patient.h"

namespace brachium {
namespace {

using Eigen::Vector3d;

constexpr double kSpacing = 0.032;                 // of the holes [m]
constexpr double kLift = 0.04;                     // over the pegs on the way [m]
const Vector3d kMiddle(0.42, 0.77 - 1.05, -0.15);  // of the board: forward, up, right [m]
const Vector3d kBowl(0.40, 0.77 - 1.05, 0.0);
const Vector3d kElbow(-0.5, -1.0, 0.7);
constexpr double kMissed = 0.015;  // of the bowl at most, along and across [m]
constexpr double kTrunk = 0.5;     // by which a trunk's angle moves the shoulder [m/rad]

Vector3d Hole(int peg) {
  const int row = (peg - 1) / 3, column = (peg - 1) % 3;
  return kMiddle + kSpacing * Vector3d(1.0 - row, 0.0, column - 1.0);
}

// How the trunk and the shoulder help over a distance: forward, towards the board, and up.
JointValues Helped(double distance) {
  JointValues posture = StartPoseJoints();
  posture[kForearmPronation] = 140 * kDegree;
  posture[kWristFlexion] = -10 * kDegree;
  posture[kTrunkLean] = 0.6 * distance / kTrunk;
  posture[kTrunkBend] = -0.7 * distance / kTrunk;
  posture[kShoulderUp] = 0.39 * distance;
  return posture;
}

HandPlace Fingertip(const Vector3d& p_T) {
  return {.part = HandPlace::Part::kFingertip, .p_T = p_T, .elbow_T = kElbow};
}

class Test {
 public:
  Test(const Task& task, Draws& draws) : strokes_(Strokes(task.patient_week)), draws_(draws) {
    score_.choreography().contacts = {
        {.place = "bowl", .times = {}, .sigma = kMissed / std::sqrt(3.0)},
        {.place = "desk", .times = {}, .sigma = 0.002, .height_only = true}};
  }

  // Over to the place, down to it, and there for a while, of which it returns the middle.
  double Bring(const Vector3d& place_T, double help, double dwell) {
    const JointValues posture = Helped(help);
    const Vector3d above(0.0, kLift, 0.0);
    score_.Go(posture, Fingertip(place_T + above), 0.5 * Spread(), 0.0).strokes = strokes_;
    const Movement& down =
        score_.Go(posture, Fingertip(place_T), 0.25 * Spread(), dwell * Spread());
    const double middle = 0.5 * (down.start + down.duration + score_.time());
    score_.choreography().contacts[1].times.push_back(middle);
    return middle;
  }

  void PlacePeg(int peg) {
    const double start = score_.time();
    const bool helped = strokes_ > 1;
    const double help = helped ? draws_.Uniform(0.05, 0.10) : 0.0;
    const Vector3d missed(draws_.Uniform(-kMissed, kMissed), 0.0,
                          draws_.Uniform(-kMissed, kMissed));
    const double at_bowl = Bring(kBowl + missed, 0.5 * help, 0.3);
    score_.choreography().contacts[0].times.push_back(at_bowl);
    Bring(Hole(peg), help, 0.25);
    score_.Label("cycle:peg_" + std::to_string(peg), start, score_.time());
    score_.choreography().places.emplace_back("peg_" + std::to_string(peg) + ".position_m",
                                              Hole(peg));
  }

  Score& score() { return score_; }

 private:
  double Spread() { return draws_.Uniform(0.9, 1.1); }

  int strokes_;
  Draws& draws_;
  Score score_;
};

}  // namespace

Choreography PegTest(const Task& task, Draws& draws) {
  Test test(task, draws);
  test.score().Go(Helped(0.0), Fingertip(kBowl + Vector3d(0.0, 0.08, 0.0)), 1.2, 0.3);
  const double start = test.score().time();
  for (int peg = 1; peg <= 9; ++peg) test.PlacePeg(peg);
  test.score().Label("task:nine_hole_peg_test", start, test.score().time());
  test.score().Go(StartPoseJoints(), 1.2, 0.0);
  return test.score().choreography();
}

}  // namespace brachium
