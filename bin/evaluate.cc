// brachium evaluate: how far an estimate is from the trial's reference.
#include <iostream>
#include <string>

#include "bin/commands.h"
#include "bin/estimate_text.h"
#include "bin/evaluation_text.h"
#include "bin/help.h"
#include "bin/judge.h"
#include "bin/termination.h"
#include "io/estimate_folder.h"
#include "io/evaluation_file.h"
#include "io/trial_folder.h"

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
    "tables and writes evaluation.json. Exits with 2, and writes nothing, when the trial has no "
    "reference or the estimate was made from other recordings."};

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
  RequireMadeFrom(ReadRun(flags.estimate), flags.estimate, folder, flags.trial);
  const Evaluation evaluation = Judge(estimate, reference, flags.trial);
  {
    const WithoutInterruption writing;
    WriteEvaluation(output, evaluation, flags.overwrite);
  }
  std::cout << "Trial " << folder.trial.name << "\n"
            << EvaluationText(evaluation)
            << FindingsText({.defaults = {}, .repairs = {}, .warnings = folder.warnings})
            << "Evaluation in " << output << "/evaluation.json\n";
  WarnOfDistrust(estimate.diagnostics, std::cerr);
  return kGood;
}

}  // namespace brachium
