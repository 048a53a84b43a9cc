// Estimate folders: what a method found, how it went, and how to do it again.
#pragma once

#include <string>

#include "io/estimate_csv.h"
#include "io/output_folder.h"
#include "io/run_info.h"
#include "problems/estimate.h"

namespace brachium {

// How an estimate folder is recognised, for CheckReplaceable() before long work.
FolderKind EstimateFolderKind();

// Writes estimate.csv, summary.json, timing.json and run.flags in one step. All but timing.json is
// the same, byte for byte, for the same estimate and run. Throws OutputExists and OutputError.
void WriteEstimate(const std::string& folder, const Estimate& estimate, const RunInfo& run,
                   bool overwrite);

// The same folder where the motion comes piece by piece. Without Commit() nothing remains.
class EstimateFolder {
 public:
  EstimateFolder(const std::string& folder, bool overwrite);

  void Append(const Estimate& piece);

  // `estimate`: all but the motion that was appended.
  void Commit(const Estimate& estimate, const RunInfo& run);

  // Where it is made.
  const std::string& draft() const { return output_.draft(); }

 private:
  OutputFolder output_;
  EstimateCsvWriter motion_;
};

// Whether a folder holds the estimate that this run would make: by the same method, options and
// versions from the same inputs.
bool HoldsEstimate(const std::string& folder, const std::string& method, const RunInfo& run);

// The motion, and of the finding all that summary.json tells. Throws InputError.
Estimate ReadEstimate(const std::string& folder);

// What an estimate folder says of its run: the trial's name, findings, inputs, versions and flags.
// Throws InputError.
RunInfo ReadRun(const std::string& folder);

}  // namespace brachium
