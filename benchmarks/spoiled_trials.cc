// How many mistakes are named at the door, and how many sound trials are suspected: every scenario
// as it is, with soft tissue and with drawn errors, both sides, some seeds; then the movements of
// everyday life spoiled in every way. Prints a line for each mistake; about ten minutes.
//
//   spoiled_trials [SEEDS]
#include "tests/support/spoiled_trials.h"

#include <cstdio>
#include <cstdlib>
#include <map>

namespace brachium {
namespace {

constexpr Side kSides[] = {Side::kRight, Side::kLeft};

SimulationOptions WornLoosely() {
  SimulationOptions errors;
  errors.soft_tissue = TypicalSoftTissue();
  errors.mounting_error = 2 * kDegree;
  errors.lost_share = 0.01;
  return errors;
}

SimulationOptions Drawn() {
  SimulationOptions errors;
  errors.draw_sizes = true;
  errors.scale_error = 0.003;
  errors.misalignment = 0.5 * kDegree;
  errors.start_pose_error = 5 * kDegree;
  return errors;
}

void TrySound(std::uint64_t seeds) {
  int suspected = 0, tried = 0;
  for (const std::string& name : ScenarioNames())
    for (const Side side : kSides)
      for (std::uint64_t seed = 1; seed <= seeds; ++seed)
        for (const SimulationOptions& errors : {SimulationOptions{}, WornLoosely(), Drawn()}) {
          ScenarioOptions scenario{.name = name, .seed = seed, .side = side};
          scenario.duration = UsualDuration(scenario);
          const std::string said = Said(SoundTrial(scenario, errors));
          ++tried;
          suspected += said.empty() ? 0 : 1;
          if (!said.empty()) std::printf("  %s: %s", name.c_str(), said.c_str());
        }
  std::printf("sound: %d of %d suspected\n", suspected, tried);
}

void TrySpoiled(std::uint64_t seeds, const SimulationOptions& errors) {
  std::vector<Trial> sound;
  for (const std::string name : {"daily_brisk", "daily_slow", "reach"})
    for (const Side side : kSides)
      for (std::uint64_t seed = 1; seed <= seeds; ++seed)
        sound.push_back(SoundTrial({.name = name, .seed = seed, .side = side}, errors));
  for (const Mistake& mistake : Mistakes()) {
    std::map<std::string, int> named;
    for (Trial trial : sound) {
      mistake.make(trial);
      named[trial.name] += Names(Said(trial), mistake) ? 1 : 0;
    }
    std::printf("  %-24s", mistake.what.c_str());
    for (const auto& [name, count] : named)
      std::printf("  %s %d of %d", name.c_str(), count, static_cast<int>(2 * seeds));
    std::printf("\n");
  }
}

}  // namespace
}  // namespace brachium

int main(int count, char** words) {
  const std::uint64_t seeds = count > 1 ? std::strtoull(words[1], nullptr, 10) : 5;
  brachium::TrySound(seeds);
  std::printf("spoiled, standard sensors\n");
  brachium::TrySpoiled(seeds, {});
  std::printf("spoiled, on soft tissue\n");
  brachium::TrySpoiled(seeds, brachium::WornLoosely());
}
