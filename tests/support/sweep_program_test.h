// Sweeps, as a user goes.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/run_program.h"

namespace brachium {

class SweepProgramTest : public ProgramTest {
 protected:
  using Words = std::vector<std::string>;

  std::string Trial(const std::string& name, const Words& more = {}) const {
    Words words = {"simulate", "--scenario=reach", "--duration_s=16", "--output=" + Path(name)};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = Run(words);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return Path(name);
  }

  Outcome Plan(const std::string& trials, const std::string& methods, const std::string& vary,
               const Words& more = {}) const {
    Words words = {"sweep",
                   "plan",
                   "--trials=" + trials,
                   "--method=" + methods,
                   "--vary=" + vary,
                   "--output=" + Path("sweep")};
    words.insert(words.end(), more.begin(), more.end());
    return Run(words);
  }

  Outcome Sweep(const std::string& command, const Words& more = {}) const {
    Words words = {"sweep", command, "--manifest=" + Manifest()};
    words.insert(words.end(), more.begin(), more.end());
    return Run(words);
  }

  std::string Manifest() const { return Path("sweep/manifest.jsonl"); }

  std::vector<nlohmann::json> Tasks() const {
    std::vector<nlohmann::json> tasks;
    std::istringstream lines(ReadText(Manifest()));
    for (std::string line; std::getline(lines, line);) tasks.push_back(nlohmann::json::parse(line));
    return tasks;
  }

  // Files of the sweep but its timings: path -> bytes.
  std::map<std::string, std::string> Files() const {
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(Path("sweep"))) {
      const auto name = entry.path().lexically_relative(Path("sweep")).string();
      if (entry.is_regular_file() && !name.starts_with("timing") && !name.starts_with("slurm") &&
          name.find(".partial.") == std::string::npos)
        files[name] = ReadText(entry.path());
    }
    return files;
  }

  // How often each task was run.
  std::map<int, int> TimesRun() const {
    std::map<int, int> times;
    for (const auto& entry : std::filesystem::directory_iterator(Path("sweep/timing"))) {
      std::istringstream lines(ReadText(entry.path()));
      for (std::string line; std::getline(lines, line);)
        ++times[nlohmann::json::parse(line)["task"].get<int>()];
    }
    return times;
  }

  void ForgetResults() const {
    std::filesystem::remove_all(Path("sweep/results"));
    std::filesystem::remove_all(Path("sweep/timing"));
  }
};

}  // namespace brachium
