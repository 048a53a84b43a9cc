// How many mistakes are named at the door, and how many sound trials are suspected: every scenario
// on rigid sensors, on soft tissue and with drawn errors, both sides, some seeds, short trials too, all
// with the maker's orientations; then a minute of the movements of everyday life spoiled in every way,
// on rigid sensors and on two kinds of soft tissue. Prints a line for each mistake, with how often
// something else was named; five seeds take ten minutes.
//
//   spoiled_trials [SEEDS] [FIRST]
#include "tests/support/spoiled_trials.h"

#include <cstdio>
#include <cstdlib>
#include <map>
#include <utility>

namespace brachium {
namespace {

constexpr Side kSides[] = {Side::kRight, Side::kLeft};
const std::string kEveryday[] = {"daily_brisk", "daily_slow", "reach"};

struct Seeds {
  std::uint64_t first = 1, end = 6;
};

using Worn = std::pair<std::string, SimulationOptions>;

std::vector<Worn> WaysToWear() {
  std::vector<Worn> worn = {{"rigid", {}}, {"rigid, drawn", Drawn({})}};
  for (const int degrees : {1, 2, 3, 4})
    worn.emplace_back("skin of " + std::to_string(degrees) + " deg",
                      WornLoosely(degrees * kDegree));
  SimulationOptions upper_arm = WornLoosely(3 * kDegree);
  upper_arm.soft_tissue.upper_arm_along_rms = 8 * kDegree;
  worn.emplace_back("skin of 3 and 8 deg", upper_arm);
  worn.emplace_back("skin of 3 deg, drawn", Drawn(WornLoosely(3 * kDegree)));
  return worn;
}

// As long as they usually are; and, since chance explains more of less, those of everyday life that
// are over sooner.
std::vector<ScenarioOptions> SoundScenarios() {
  std::vector<ScenarioOptions> scenarios;
  for (const std::string& name : ScenarioNames()) {
    scenarios.push_back({.name = name});
    scenarios.back().duration = UsualDuration(scenarios.back());
  }
  for (const std::string& name : kEveryday)
    for (const double seconds : {20.0, 30.0, 40.0}) {
      scenarios.push_back({.name = name});
      scenarios.back().duration = seconds;
    }
  return scenarios;
}

void TrySound(const Seeds& seeds, const Worn& worn) {
  int suspected = 0, tried = 0;
  for (ScenarioOptions scenario : SoundScenarios())
    for (const Side side : kSides)
      for (std::uint64_t seed = seeds.first; seed < seeds.end; ++seed) {
        scenario.side = side;
        scenario.seed = seed;
        Trial trial = SoundTrial(scenario, worn.second);
        Orient(trial, [](const Eigen::Quaterniond& q) { return q; });
        const std::string said = Said(trial);
        ++tried;
        suspected += said.empty() ? 0 : 1;
        if (!said.empty())
          std::printf("  %s, %.0f s, seed %llu: %s", scenario.name.c_str(), scenario.duration,
                      static_cast<unsigned long long>(seed), said.c_str());
      }
  std::printf("sound, %s: %d of %d suspected\n", worn.first.c_str(), suspected, tried);
}

void TrySpoiled(const Seeds& seeds, const Worn& worn) {
  std::printf("spoiled, %s\n", worn.first.c_str());
  std::vector<Trial> sound;
  for (const std::string& name : kEveryday)
    for (const Side side : kSides)
      for (std::uint64_t seed = seeds.first; seed < seeds.end; ++seed)
        sound.push_back(SoundTrial({.name = name, .seed = seed, .side = side}, worn.second));
  const int each = static_cast<int>(2 * (seeds.end - seeds.first));
  for (const Mistake& mistake : Mistakes()) {
    std::map<std::string, int> named;
    int otherwise = 0;
    for (Trial trial : sound) {
      mistake.make(trial);
      const std::string said = Said(trial);
      named[trial.name] += Names(said, mistake) ? 1 : 0;
      otherwise += said.empty() || Names(said, mistake) ? 0 : 1;
    }
    std::printf("  %-26s", mistake.what.c_str());
    for (const auto& [name, count] : named) std::printf("  %s %d of %d", name.c_str(), count, each);
    std::printf("%s\n",
                otherwise == 0 ? "" : ("  called otherwise " + std::to_string(otherwise)).c_str());
  }
}

std::uint64_t Number(int count, char** words, int which, std::uint64_t otherwise) {
  return count > which ? std::strtoull(words[which], nullptr, 10) : otherwise;
}

}  // namespace
}  // namespace brachium

int main(int count, char** words) {
  using namespace brachium;
  const std::uint64_t seeds = Number(count, words, 1, 5), first = Number(count, words, 2, 1);
  const Seeds tried{first, first + seeds};
  const std::vector<Worn> ways = WaysToWear();
  for (const std::size_t way : {0u, 4u, 6u}) TrySpoiled(tried, ways[way]);
  for (const Worn& worn : ways) TrySound(tried, worn);
}
