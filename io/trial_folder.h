// Trial folders: trial.json and the files that it names.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/findings.h"
#include "io/recording_csv.h"
#include "io/reference_csv.h"
#include "problems/sample_source.h"
#include "problems/trial.h"

namespace brachium {

struct InputFile {
  std::string path;    // as trial.json names it; "trial.json" itself comes first
  std::string sha256;  // hexadecimal
};

// A trial as it was read, what had to be assumed and mended, and what there was.
struct TrialFolder : Findings {
  Trial trial;
  bool simulated = false;
  std::vector<RecordingFacts> recordings;  // beside trial.observations.recordings
  std::optional<ReferenceFacts> reference;
  std::vector<InputFile> inputs;
};

enum class TrialParts {
  kAll,
  kRecordings,  // of the reference only which file it is
};

// Reads a trial. A recording that trial.json gives no mounting has none afterwards, unless it is
// alone: then its segment's axes are the sensor's. A left arm stays a left arm. Throws InputError
// `file:line: what, and what was expected` for everything that cannot be mended.
TrialFolder ReadTrial(const std::string& folder, TrialParts parts = TrialParts::kAll);

// The same of a trial whose samples stay in their files: its recordings are empty.
struct StreamedTrial : TrialFolder {
  std::vector<std::unique_ptr<SampleSource>> samples;  // beside trial.observations.recordings
};

// As ReadTrial, in memory that does not grow with the trial. Every recording's file is read through
// once, and refused as a whole if a line of it is; what shows only in the numbers, of one recording
// or between them, is looked for in the first 100 000 samples. Makers' exports are held in memory. A
// reference is not looked into.
StreamedTrial OpenTrial(const std::string& folder);

// What a written trial says besides the trial.
struct TrialExtras {
  bool simulated = false;
  std::string truth_json;  // the text of truth.json; empty: no such file
};

// Writes a folder from which ReadTrial makes the same trial: trial.json, one csv file per
// recording, reference.csv. Throws OutputExists and OutputError.
void WriteTrial(const std::string& folder, const Trial& trial, const TrialExtras& extras,
                bool overwrite);

}  // namespace brachium
