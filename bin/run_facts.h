// What is known about a run beside its result: versions, the machine, how long things took.
#pragma once

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace brachium {

std::string ProgramVersion();

// The program and the libraries whose version may move a result: name, version.
std::vector<std::pair<std::string, std::string>> Versions();

std::string HostName();

class Stopwatch {
 public:
  double Seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace brachium
