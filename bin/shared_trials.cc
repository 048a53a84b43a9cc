#include "bin/shared_trials.h"

#include <utility>

#include "bin/judge.h"
#include "io/input_error.h"

namespace brachium {

std::shared_ptr<const TrialFolder> SharedTrials::Take(const SweepTask& task) {
  Place& place = places_.at(task.path);
  const std::lock_guard lock(place.mutex);
  --place.tasks;
  if (!place.folder) {
    auto folder = std::make_shared<const TrialFolder>(ReadTrial(task.path));
    RequireReference(*folder, task.path);
    place.folder = std::move(folder);
  }
  if (InputsHash(place.folder->inputs) != task.inputs)
    throw InputError(task.path + "/trial.json", 0,
                     "or a file that it names was changed since the sweep was planned; plan again, "
                     "in another folder");
  return place.tasks == 0 ? std::exchange(place.folder, nullptr) : place.folder;
}

}  // namespace brachium
