// Trials that several tasks need: each read once, and given up after its last task.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "io/sweep_manifest.h"
#include "io/trial_folder.h"

namespace brachium {

class SharedTrials {
 public:
  // Once for each task to come, before any is run.
  void Expect(const SweepTask& task) { ++places_[task.path].tasks; }

  // The task's trial, read now if no other task has done so. Throws InputError when it cannot be
  // read, has no reference, or is not the one that was planned with. From any thread.
  std::shared_ptr<const TrialFolder> Take(const SweepTask& task);

 private:
  struct Place {
    std::mutex mutex;
    std::size_t tasks = 0;  // still to come
    std::shared_ptr<const TrialFolder> folder;
  };
  std::map<std::string, Place> places_;
};

}  // namespace brachium
