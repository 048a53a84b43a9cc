// Trials spoiled in each of the ways in which users spoil them, and sound ones.
#include "io/trial_checks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "io/input_error.h"
#include "io/recording_checks.h"
#include "problems/simulation/simulate.h"

namespace brachium {
namespace {

Recording& Upper(Trial& trial) { return trial.observations.recordings[0]; }
Recording& Fore(Trial& trial) { return trial.observations.recordings[1]; }

void Scale(std::vector<Eigen::Vector3d>& samples, double factor) {
  for (Eigen::Vector3d& v : samples) v *= factor;
}

void Retime(Trial& trial, double factor) {
  for (Recording& recording : trial.observations.recordings)
    for (double& t : recording.time) t *= factor;
}

// Orientations as a maker would give them, changed by `change`.
void Orient(Trial& trial, Eigen::Quaterniond (*change)(const Eigen::Quaterniond&)) {
  for (Recording& recording : trial.observations.recordings) {
    const auto& q_VB = trial.reference->q_VB.at(recording.segment);
    for (const Eigen::Quaterniond& q : q_VB)
      recording.q_WS.push_back(change(q * recording.mounting->q_BS));
  }
}

// As a sensor of 250 deg/s would record it; a slow movement is sped up until it turns faster.
void Clip(Recording& recording) {
  constexpr double kRange = 250 * kDegree;
  double most = 0.0;
  for (const Eigen::Vector3d& v : recording.gyr_S) most = std::max(most, v.cwiseAbs().maxCoeff());
  const double faster = std::max(1.0, 1.5 * kRange / most);
  for (double& t : recording.time) t /= faster;
  for (Eigen::Vector3d& v : recording.gyr_S) v = (faster * v).cwiseMin(kRange).cwiseMax(-kRange);
}

struct Mistake {
  std::string name;
  std::function<void(Trial&)> make;
};

const std::vector<Mistake>& Mistakes() {
  using Eigen::Quaterniond;
  static const std::vector<Mistake> mistakes = {
      {"rate", [](Trial& t) { Retime(t, 100.0 / 60.0); }},
      {"rate", [](Trial& t) { Retime(t, 0.8); }},
      {"gyr_in_deg_s", [](Trial& t) { Scale(Fore(t).gyr_S, 1.0 / kDegree); }},
      {"acc_in_g", [](Trial& t) { Scale(Upper(t).acc_S, 1.0 / 9.80665); }},
      {"acc_gyr_swapped", [](Trial& t) { std::swap(Fore(t).acc_S, Fore(t).gyr_S); }},
      {"orientation_w_last",
       [](Trial& t) {
         Orient(t, [](const Quaterniond& q) { return Quaterniond(q.x(), q.y(), q.z(), q.w()); });
       }},
      {"orientation_inverted",
       [](Trial& t) { Orient(t, [](const Quaterniond& q) { return q.conjugate(); }); }},
      {"orientation_ned",
       [](Trial& t) {
         Orient(t, [](const Quaterniond& q) {
           return Quaterniond(0.0, std::sqrt(0.5), std::sqrt(0.5), 0.0) * q;
         });
       }},
      {"sensors_swapped",
       [](Trial& t) {
         std::swap(Upper(t).gyr_S, Fore(t).gyr_S);
         std::swap(Upper(t).acc_S, Fore(t).acc_S);
       }},
      {"side",
       [](Trial& t) {
         Side& side = t.observations.arm.side;
         side = side == Side::kRight ? Side::kLeft : Side::kRight;
       }},
      {"gravity_sign", [](Trial& t) { Scale(Fore(t).acc_S, -1.0); }},
      {"gravity_sign", [](Trial& t) { Scale(Upper(t).acc_S, -1.0); }},
      {"clock",
       [](Trial& t) {
         for (double& time : Fore(t).time) time += 0.4;
       }},
      {"moving_rest",
       [](Trial& t) {
         t.observations.intervals.push_back({"rest", 20.0, 26.0});
       }},
      {"clipping", [](Trial& t) { Clip(Fore(t)); }},
      {"frozen",
       [](Trial& t) {
         for (std::size_t i = 1000; i < 1060; ++i) {
           Fore(t).gyr_S[i] = Fore(t).gyr_S[1000];
           Fore(t).acc_S[i] = Fore(t).acc_S[1000];
         }
       }},
  };
  return mistakes;
}

// All that is said of a trial at the door.
std::string Said(const Trial& trial) {
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

std::vector<Trial> SoundTrials() {
  std::vector<Trial> trials;
  for (const std::string scenario : {"daily_brisk", "daily_slow", "reach"})
    for (const Side side : {Side::kRight, Side::kLeft})
      for (const std::uint64_t seed : {1u, 2u}) {
        ScenarioOptions options{.name = scenario, .seed = seed, .side = side, .duration = 60.0};
        SimulationOptions errors;
        errors.seed = seed;
        Trial trial = Simulate(MakeScenario(options), errors).trial;
        trial.name = scenario;
        trials.push_back(std::move(trial));
      }
  return trials;
}

TEST(TrialChecks, AreSilentOnSoundTrials) {
  for (Trial& trial : SoundTrials()) {
    trial.observations.intervals.push_back({"rest", 0.5, 2.5});
    Orient(trial, [](const Eigen::Quaterniond& q) { return q; });
    EXPECT_EQ(Said(trial), "") << trial.name;
  }
}

TEST(TrialChecks, NameNearlyEveryMistakeAndNothingElseInItsPlace) {
  const std::vector<Trial> sound = SoundTrials();
  int named = 0, spoiled = 0;
  for (const Mistake& mistake : Mistakes()) {
    int here = 0;
    std::string missed;
    for (Trial trial : sound) {
      mistake.make(trial);
      const std::string said = Said(trial);
      const bool right = said.find("[" + mistake.name + "]") != said.npos;
      here += right ? 1 : 0;
      if (!right) missed += "  " + trial.name + ": " + said + "\n";
    }
    named += here;
    spoiled += static_cast<int>(sound.size());
    RecordProperty(mistake.name, here);
    if (!missed.empty()) std::printf("%s missed in\n%s", mistake.name.c_str(), missed.c_str());
  }
  EXPECT_GE(named, 0.95 * spoiled) << named << " of " << spoiled;
}

}  // namespace
}  // namespace brachium
