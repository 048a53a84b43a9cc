// The movements by which sensors, drift and alignment are calibrated.
#include "problems/simulation/families.h"

namespace brachium {
namespace {

constexpr double kRest = 0.6;  // between movements [s]

// One after the other, with rests between; a label covers half of the rests at both ends.
void Go(const JointValues& target, const std::string& label, Draws& draws, Score& score) {
  const double start = score.time();
  const Movement& movement = score.Go(target, draws.Uniform(0.9, 1.0), kRest);
  if (!label.empty())
    score.Label(label, start - 0.5 * kRest, start + movement.duration + 0.5 * kRest);
}

// Five repetitions, as in Luinge et al. 2007.
void Repeat(const JointValues& from, const JointValues& to, const std::string& out,
            const std::string& back, Draws& draws, Score& score) {
  Go(from, "", draws, score);
  for (int repetition = 0; repetition < 5; ++repetition) {
    Go(to, out, draws, score);
    Go(from, back, draws, score);
  }
}

}  // namespace

// Luinge et al. 2007, section 2: pronation and supination with the elbow at 90 deg, from palm down
// to palm nearly up and back; endo- and exorotation of an upper arm raised as by a table top;
// abduction of a hanging one, elbow at 90 deg.
Choreography CalibrationMovements(const Task&, Draws& draws) {
  JointValues bent = StartPoseJoints();
  bent[kShoulderAbduction] = 0.0;
  bent[kElbowFlexion] = 90 * kDegree;
  JointValues palm_down = bent, palm_up = bent, raised = bent, abducted = bent;
  palm_down[kForearmPronation] = 180 * kDegree;
  palm_up[kForearmPronation] = 20 * kDegree;
  raised[kShoulderFlexion] = 45 * kDegree;
  raised[kShoulderRotation] = -30 * kDegree;
  JointValues rotated = raised;
  rotated[kShoulderRotation] = 50 * kDegree;
  abducted[kShoulderAbduction] = 70 * kDegree;
  Score score;
  Repeat(palm_down, palm_up, "calibration:forearm_supination", "calibration:forearm_pronation",
         draws, score);
  Repeat(raised, rotated, "calibration:upper_arm_endorotation", "calibration:upper_arm_exorotation",
         draws, score);
  Repeat(bent, abducted, "calibration:upper_arm_abduction", "", draws, score);
  Go(StartPoseJoints(), "", draws, score);
  return score.choreography();
}

// Zhou et al. 2008, section 2.3: twenty repetitions, the shoulder kept still; here of his reaching
// test, the elbow flexed and the arm put forward.
Choreography ShoulderStill(const Task&, Draws& draws) {
  constexpr int kRepetitions = 20;
  Score score;
  for (int repetition = 0; repetition < kRepetitions; ++repetition) {
    JointValues flexed = StartPoseJoints(), reached = StartPoseJoints();
    flexed[kElbowFlexion] = draws.Uniform(95 * kDegree, 105 * kDegree);
    reached[kShoulderFlexion] = draws.Uniform(50 * kDegree, 80 * kDegree);
    reached[kShoulderAbduction] = draws.Uniform(0.0, 20 * kDegree);
    reached[kElbowFlexion] = draws.Uniform(20 * kDegree, 40 * kDegree);
    const double start = score.time();
    score.Go(flexed, draws.Uniform(0.7, 0.9), 0.0);
    score.Go(reached, draws.Uniform(0.7, 0.9), 0.1);
    const Movement& home = score.Go(StartPoseJoints(), draws.Uniform(0.8, 1.0), kRest);
    score.Label("calibration:shoulder_still", start - 0.5 * kRest,
                home.start + home.duration + 0.5 * kRest);
  }
  return score.choreography();
}

// Bai et al. 2015, section II.D: a minute without movement, the arm hanging.
Choreography StaticPose(const Task& task, Draws&) {
  Score score;
  score.Label("calibration:static_pose", 0.0, task.length);
  return score.choreography();
}

}  // namespace brachium
