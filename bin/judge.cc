#include "bin/judge.h"

#include <algorithm>

#include "io/input_error.h"

namespace brachium {

const Reference& RequireReference(const TrialFolder& folder, const std::string& path) {
  if (!folder.trial.reference)
    throw InputError(path + "/trial.json", 0,
                     "has no \"reference\", so there is nothing to compare with; add an "
                     "independent recording of the same movement, as "
                     "\"reference\": {\"file\": \"reference.csv\", \"frames\": \"segment\"}");
  return *folder.trial.reference;
}

void RequireMadeFrom(const RunInfo& run, const std::string& estimate, const TrialFolder& folder,
                     const std::string& path) {
  if (run.inputs.empty()) return;
  for (const RecordingFacts& recording : folder.recordings) {
    const auto input = std::ranges::find(folder.inputs, recording.file, &InputFile::path);
    if (input == folder.inputs.end() ||
        std::ranges::find(run.inputs, input->sha256, &InputFile::sha256) == run.inputs.end())
      throw InputError(estimate, 0,
                       "was not made from " + recording.file + " in " + path +
                           " as it is now; expected the trial of the estimate, its recordings "
                           "unchanged: name it, or reconstruct again");
  }
}

Evaluation Judge(const Estimate& estimate, const Reference& reference, const std::string& path) {
  Evaluation evaluation = Evaluate(estimate, reference);
  if (evaluation.used == 0)
    throw InputError(path + "/trial.json", 0,
                     "the reference and the estimate have no instant, or no segment, in common; "
                     "expected both of the same trial (see \"clock_offset_s\" and \"columns\")");
  return evaluation;
}

}  // namespace brachium
