// Active range of motion in seven degrees of freedom, three repetitions of each.
//
// Sources: Bai et al. 2015, sections II.A and III.B: the seven, three repetitions in each of ten
// weekly sessions, abduction of healthy volunteers 140-170 deg, the patient's in patient.h. The
// other ends are within those of Boone & Azen 1979; a patient has the same share of each as of
// abduction.
#include <algorithm>
#include <cmath>

#include "problems/simulation/families.h"
#include "problems/simulation/patient.h"

namespace brachium {
namespace {

struct Freedom {
  const char* name;
  Joint joint;
  double low, neutral, high;  // [deg]
  double elbow, pronation;    // of the posture in which it is tested [deg]
};

constexpr std::array kFreedoms = {
    Freedom{"shoulder_flexion", kShoulderFlexion, -40, 0, 155, 10, 90},
    Freedom{"shoulder_abduction", kShoulderAbduction, 0, 5, 160, 10, 90},
    Freedom{"shoulder_rotation", kShoulderRotation, -50, 0, 60, 90, 90},
    Freedom{"elbow_flexion", kElbowFlexion, 4, 10, 138, 10, 30},
    Freedom{"forearm_pronation", kForearmPronation, 15, 90, 165, 90, 90},
    Freedom{"wrist_flexion", kWristFlexion, -60, 0, 65, 90, 170},
    Freedom{"wrist_deviation", kWristDeviation, -17, 0, 30, 90, 170}};

JointValues Neutral(const Freedom& freedom) {
  JointValues pose{};
  pose[kShoulderAbduction] = 8 * kDegree;
  pose[kElbowFlexion] = freedom.elbow * kDegree;
  pose[kForearmPronation] = freedom.pronation * kDegree;
  pose[freedom.joint] = freedom.neutral * kDegree;
  return pose;
}

// A healthy person's time over an angle: 0.6 s, and a second more for each 120 deg.
double TimeFor(double angle_deg) { return 0.6 + std::abs(angle_deg) / 120.0; }

class Session {
 public:
  Session(const Task& task, Draws& draws) : task_(task), draws_(draws) {
    const double abduction = task.patient_week == 0 ? draws.Uniform(140 * kDegree, 170 * kDegree)
                                                    : PatientAbduction(task.patient_week);
    share_ = abduction / (160 * kDegree);
  }

  void Test(const Freedom& freedom) {
    score_.Go(Neutral(freedom), 1.0, 0.5);
    const double start = score_.time();
    const double share = freedom.joint == kShoulderAbduction ? share_ : std::min(share_, 1.0);
    for (int repetition = 0; repetition < 3; ++repetition) {
      const double cycle = score_.time();
      const double reached = share * draws_.Uniform(0.97, 1.03);
      const double high = freedom.neutral + reached * (freedom.high - freedom.neutral);
      const double low = freedom.neutral + reached * (freedom.low - freedom.neutral);
      Go(freedom, freedom.neutral, high);
      Go(freedom, high, low);
      Go(freedom, low, freedom.neutral);
      score_.Label(std::string("cycle:") + freedom.name, cycle, score_.time());
    }
    score_.Label(std::string("task:") + freedom.name, start, score_.time());
  }

  Score& score() { return score_; }

 private:
  // A patient helps a raised arm with trunk and shoulder, by up to 8 cm.
  void Go(const Freedom& freedom, double from_deg, double to_deg) {
    JointValues target = Neutral(freedom);
    target[freedom.joint] = to_deg * kDegree;
    const bool raises = freedom.joint == kShoulderFlexion || freedom.joint == kShoulderAbduction;
    if (raises && task_.patient_week > 0 && to_deg > 45.0) {
      target[kShoulderUp] = 0.03;
      target[kTrunkBend] = -8 * kDegree;
    }
    score_.Go(target, TimeFor(to_deg - from_deg), 0.3).strokes = Strokes(task_.patient_week);
  }

  const Task& task_;
  Draws& draws_;
  double share_ = 1.0;
  Score score_;
};

}  // namespace

Choreography RangeOfMotion(const Task& task, Draws& draws) {
  Session session(task, draws);
  for (const Freedom& freedom : kFreedoms) session.Test(freedom);
  session.score().Go(StartPoseJoints(), 1.0, 0.0);
  return session.score().choreography();
}

}  // namespace brachium
