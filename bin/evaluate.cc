// brachium evaluate: how far an estimate is from the trial's reference.
#include <iostream>
#include <string>

#include "bin/commands.h"
#include "bin/evaluation_text.h"
#include "bin/help.h"
#include "bin/termination.h"
#include "io/estimate_folder.h"
#include "io/evaluation_file.h"
#include "io/input_error.h"
#include "io/trial_folder.h"
#include "problems/evaluation.h"

namespace brachium {
namespace {

struct EvaluateFlags {
  std::string trial;
  std::string estimate;
  std::string output;
  bool overwrite = false;

  template <typename Flags, typename Visitor>
  static void Visit(Flags& flags, Visitor&& visit) {
    visit("trial", flags.trial, "The trial folder, with a reference.");
    visit("estimate", flags.estimate, "The estimate folder.");
    visit("output", flags.output,
          "The folder that receives evaluation.json; the estimate folder when left out.");
    visit("overwrite", flags.overwrite, "Replace an older evaluation that says something else.");
  }
};

const CommandHelp kHelp = {
    "--trial=DIR --estimate=DIR [--output=DIR] [flags]",
    "Compares an estimate with the independent reference of its trial: orientation of each "
    "segment and between segments, joint angles, positions. Absolute orientations and positions "
    "are compared after one constant heading and shift, which no inertial sensor can know. Prints "
    "tables and writes evaluation.json."};

const Reference& RequireReference(const TrialFolder& folder, const std::string& trial) {
  if (!folder.trial.reference)
    throw InputError(trial + "/trial.json", 0,
                     "has no \"reference\", so there is nothing to compare with; add an "
                     "independent recording of the same movement, as "
                     "\"reference\": {\"file\": \"reference.csv\", \"frames\": \"segment\"}");
  return *folder.trial.reference;
}

void RequireCommonInstants(const Evaluation& evaluation, const std::string& trial) {
  if (evaluation.used == 0)
    throw InputError(trial + "/trial.json", 0,
                     "the reference and the estimate have no instant, or no segment, in common; "
                     "expected both of the same trial (see \"clock_offset_s\" and \"columns\")");
}

}  // namespace

int RunEvaluate(CommandLine& line) {
  EvaluateFlags flags;
  line.Add("Flags", flags);
  if (ShowHelp(line, kHelp)) return kGood;
  line.Read();
  RequireGiven(flags.trial, "trial");
  RequireGiven(flags.estimate, "estimate");
  const std::string output = flags.output.empty() ? flags.estimate : flags.output;

  const TrialFolder folder = ReadTrial(flags.trial);
  const Reference& reference = RequireReference(folder, flags.trial);
  const Estimate estimate = ReadEstimate(flags.estimate);
  const Evaluation evaluation = Evaluate(estimate, reference);
  RequireCommonInstants(evaluation, flags.trial);
  {
    const WithoutInterruption writing;
    WriteEvaluation(output, evaluation, flags.overwrite);
  }
  std::cout << "Trial " << folder.trial.name << "\n"
            << EvaluationText(evaluation) << "Evaluation in " << output << "/evaluation.json\n";
  return kGood;
}

}  // namespace brachium
