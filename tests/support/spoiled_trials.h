// Trials spoiled in each of the ways in which users spoil them, and what is said of them.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "io/input_error.h"
#include "io/recording_checks.h"
#include "io/trial_checks.h"
#include "problems/rotation.h"
#include "problems/sampling.h"
#include "problems/simulation/simulate.h"

namespace brachium {

inline Recording& Upper(Trial& trial) { return trial.observations.recordings[0]; }
inline Recording& Fore(Trial& trial) { return trial.observations.recordings[1]; }

inline void Scale(std::vector<Eigen::Vector3d>& samples, double factor) {
  for (Eigen::Vector3d& v : samples) v *= factor;
}

inline void Retime(Trial& trial, double factor) {
  for (Recording& recording : trial.observations.recordings)
    for (double& t : recording.time) t *= factor;
}

inline void Delay(Recording& recording, double lag) {
  for (double& t : recording.time) t += lag;
}

// Orientations as a maker would give them, changed by `change`.
inline void Orient(Trial& trial, Eigen::Quaterniond (*change)(const Eigen::Quaterniond&)) {
  for (Recording& recording : trial.observations.recordings) {
    const auto q_VB = Interpolate(SampleTimes(trial.reference->time),
                                  trial.reference->q_VB.at(recording.segment), recording.time);
    for (const Eigen::Quaterniond& q : q_VB)
      recording.q_WS.push_back(change(q * recording.mounting->q_BS));
  }
}

// As a sensor of 250 deg/s would record it; a slow movement is sped up until it turns faster.
inline void Clip(Recording& recording) {
  constexpr double kRange = 250 * kDegree;
  double most = 0.0;
  for (const Eigen::Vector3d& v : recording.gyr_S) most = std::max(most, v.cwiseAbs().maxCoeff());
  const double faster = std::max(1.0, 1.5 * kRange / most);
  for (double& t : recording.time) t /= faster;
  for (Eigen::Vector3d& v : recording.gyr_S) v = (faster * v).cwiseMin(kRange).cwiseMax(-kRange);
}

// From the middle of the recording on the sensor sits tilted by `angle` about the segment's x axis,
// the outward one, and `slide` farther down the limb. It takes 0.4 s to get there.
inline void Slip(Recording& recording, double angle, double slide) {
  constexpr double kTakes = 0.4;  // [s]
  const Mounting& mounting = *recording.mounting;
  const Eigen::Vector3d axis_S = mounting.q_BS.conjugate() * Eigen::Vector3d::UnitX();
  const Eigen::Vector3d down_S = mounting.q_BS.conjugate() * Eigen::Vector3d(0.0, -slide, 0.0);
  const double begin = 0.5 * (recording.time.front() + recording.time.back());
  const std::vector<Eigen::Vector3d> gyr_S = recording.gyr_S;
  for (std::size_t i = 1; i + 1 < recording.size(); ++i) {
    const double u = std::clamp((recording.time[i] - begin) / kTakes, 0.0, 1.0);
    const double share = u * u * (3.0 - 2.0 * u), rate = 6.0 * u * (1.0 - u) / kTakes;
    const Eigen::Vector3d alpha_S =
        (gyr_S[i + 1] - gyr_S[i - 1]) / (recording.time[i + 1] - recording.time[i - 1]);
    const Eigen::Vector3d moved_S =
        recording.acc_S[i] +
        share * (alpha_S.cross(down_S) + gyr_S[i].cross(gyr_S[i].cross(down_S)));
    const Eigen::Quaterniond q = Exp<double>(Eigen::Vector3d(-share * angle * axis_S));
    recording.acc_S[i] = q * moved_S;
    recording.gyr_S[i] = q * gyr_S[i] + rate * angle * axis_S;
  }
}

inline void Freeze(Recording& recording, std::size_t from, std::size_t to) {
  for (std::size_t i = from; i < to; ++i) {
    recording.gyr_S[i] = recording.gyr_S[from];
    recording.acc_S[i] = recording.acc_S[from];
  }
}

// Calls six seconds a rest, the first from 12 s on in which the forearm turns by 60 deg at least.
inline void CallMovementRest(Trial& trial) {
  const Recording& recording = Fore(trial);
  for (double start = 12.0; start + 6.0 < recording.time.back(); start += 1.0) {
    double turned = 0.0;
    for (std::size_t i = 1; i < recording.size(); ++i)
      if (recording.time[i] >= start && recording.time[i] < start + 6.0)
        turned += (recording.time[i] - recording.time[i - 1]) * recording.gyr_S[i].norm();
    if (turned < 60 * kDegree) continue;
    trial.observations.intervals.push_back({"rest", start, start + 6.0});
    return;
  }
}

// A mistake and the names under which it may be reported.
struct Mistake {
  std::string what;
  std::string name;
  std::function<void(Trial&)> make;
};

inline const std::vector<Mistake>& Mistakes() {
  using Eigen::Quaterniond;
  static const std::vector<Mistake> mistakes = {
      {"60 Hz taken for 100", "rate", [](Trial& t) { Retime(t, 0.6); }},
      {"100 Hz taken for 80", "rate", [](Trial& t) { Retime(t, 1.25); }},
      {"deg/s", "gyr_in_deg_s", [](Trial& t) { Scale(Fore(t).gyr_S, 1.0 / kDegree); }},
      {"g", "acc_in_g", [](Trial& t) { Scale(Upper(t).acc_S, 1.0 / 9.80665); }},
      {"acc 5 % too large", "gravity", [](Trial& t) { Scale(Upper(t).acc_S, 1.05); }},
      {"acc for gyr", "acc_gyr_swapped", [](Trial& t) { std::swap(Fore(t).acc_S, Fore(t).gyr_S); }},
      {"w last", "orientation_w_last",
       [](Trial& t) {
         Orient(t, [](const Quaterniond& q) { return Quaterniond(q.x(), q.y(), q.z(), q.w()); });
       }},
      {"inverted", "orientation_inverted",
       [](Trial& t) { Orient(t, [](const Quaterniond& q) { return q.conjugate(); }); }},
      {"north-east-down", "orientation_ned",
       [](Trial& t) {
         Orient(t, [](const Quaterniond& q) {
           return Quaterniond(0.0, std::sqrt(0.5), std::sqrt(0.5), 0.0) * q;
         });
       }},
      {"sensors exchanged", "sensors_swapped",
       [](Trial& t) {
         std::swap(Upper(t).time, Fore(t).time);
         std::swap(Upper(t).gyr_S, Fore(t).gyr_S);
         std::swap(Upper(t).acc_S, Fore(t).acc_S);
       }},
      {"left for right", "side",
       [](Trial& t) {
         Side& side = t.observations.arm.side;
         side = side == Side::kRight ? Side::kLeft : Side::kRight;
       }},
      {"gravity down, forearm", "gravity_sign", [](Trial& t) { Scale(Fore(t).acc_S, -1.0); }},
      {"gravity down, upper arm", "gravity_sign", [](Trial& t) { Scale(Upper(t).acc_S, -1.0); }},
      {"gravity down, both", "gravity_sign",
       [](Trial& t) {
         Scale(Upper(t).acc_S, -1.0);
         Scale(Fore(t).acc_S, -1.0);
       }},
      {"clock 0.4 s late", "clock", [](Trial& t) { Delay(Fore(t), 0.4); }},
      {"clock 1.5 s early", "clock", [](Trial& t) { Delay(Fore(t), -1.5); }},
      {"movement called rest", "moving_rest", CallMovementRest},
      {"a range of 250 deg/s", "clipping", [](Trial& t) { Clip(Fore(t)); }},
      {"dropped out", "frozen", [](Trial& t) { Freeze(Fore(t), 1000, 1060); }},
      {"slipped", "slip", [](Trial& t) { Slip(Fore(t), 25 * kDegree, 0.02); }},
  };
  return mistakes;
}

// All that is said of a trial at the door.
inline std::string Said(const Trial& trial) {
  Findings findings;
  try {
    for (const Recording& recording : trial.observations.recordings)
      CheckSensorUnits(recording, "x.csv", std::string(Name(recording.segment)), &findings);
  } catch (const InputError& error) {
    return error.what();
  }
  CheckTrial(trial.observations, &findings);
  std::string said;
  for (const std::string& warning : findings.warnings) said += warning + "\n";
  return said;
}

inline bool Names(const std::string& said, const Mistake& mistake) {
  return said.find("[" + mistake.name + "]") != said.npos;
}

// Sensors on skin that turns by `along` about the long axes, the mountings told 2 deg off, 1 % of the
// samples lost.
inline SimulationOptions WornLoosely(double along) {
  SimulationOptions errors;
  errors.soft_tissue = {
      .along_rms = along, .across_rms = 0.4 * along, .translation_rms = 0.001 * along / kDegree};
  errors.mounting_error = 2 * kDegree;
  errors.lost_share = 0.01;
  return errors;
}

// All errors drawn, with their sizes as sd, of sensors within their class too.
inline SimulationOptions Drawn(SimulationOptions errors) {
  errors.draw_sizes = true;
  errors.scale_error = 0.003;
  errors.misalignment = 0.5 * kDegree;
  errors.start_pose_error = 5 * kDegree;
  return errors;
}

// A sound trial, its name the scenario's.
inline Trial SoundTrial(const ScenarioOptions& scenario, SimulationOptions errors = {}) {
  errors.seed = scenario.seed;
  Trial trial = Simulate(MakeScenario(scenario), errors).trial;
  trial.name = scenario.name;
  return trial;
}

}  // namespace brachium
