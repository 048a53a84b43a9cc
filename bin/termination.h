// SIGTERM and SIGINT end the program at once, but never in the middle of writing a result.
#pragma once

#include <mutex>
#include <string>

namespace brachium {

// From now on SIGTERM exits with 143 and SIGINT with 130. Call before any thread starts.
void ExitOnTermination();

// While one lives, termination waits: hold it from the first byte of a result to its last.
class WithoutInterruption {
 public:
  WithoutInterruption();

 private:
  std::lock_guard<std::mutex> lock_;
};

// While one lives, termination removes this folder, a result in the making.
class DiscardedOnTermination {
 public:
  explicit DiscardedOnTermination(const std::string& folder);
  ~DiscardedOnTermination();
};

}  // namespace brachium
