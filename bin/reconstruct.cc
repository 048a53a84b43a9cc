// brachium reconstruct: estimates the motion of a trial.
#include <iostream>
#include <string>

#include "bin/commands.h"
#include "bin/estimate_text.h"
#include "bin/help.h"
#include "bin/method_flags.h"
#include "bin/progress_line.h"
#include "bin/run_facts.h"
#include "bin/run_info.h"
#include "bin/termination.h"
#include "io/estimate_folder.h"
#include "io/input_error.h"
#include "io/trial_folder.h"
#include "solver/estimators.h"
#include "solver/stretch_smoother.h"

namespace brachium {
namespace {

struct ReconstructFlags {
  std::string trial;
  std::string output;
  std::string method = "smoother";
  bool overwrite = false;

  template <typename Flags, typename Visitor>
  static void Visit(Flags& flags, Visitor&& visit) {
    visit("trial", flags.trial, "The trial folder.");
    visit("output", flags.output, "The estimate folder to be written.");
    visit("method", flags.method, "How to estimate; each method brings flags of its own.");
    visit("overwrite", flags.overwrite, "Replace an older estimate in the output folder.");
  }
};

const CommandHelp kHelp = {
    "--trial=DIR --output=DIR [--method=NAME] [flags]",
    "Estimates the motion of the arm, and the constants that go with it, from the recordings of a "
    "trial. The output folder receives estimate.csv, summary.json, timing.json and run.flags; "
    "--flagfile=DIR/run.flags does the same again. Exits with 3 when the result is not to be "
    "trusted: it is written nevertheless, and says so."};

void RequireAccepted(const Estimator& estimator, const Observations& observations,
                     const std::string& trial) {
  if (std::string why; !estimator.Accepts(observations, &why))
    throw InputError(trial + "/trial.json", 0, why);
}

Estimate RunWatched(const Estimator& estimator, const Observations& observations) {
  ProgressLine line;
  return estimator.Run(observations, line.callback());
}

int Verdict(const Diagnostics& diagnostics) {
  for (const std::string& unknown : diagnostics.held_by_prior)
    std::cerr << "brachium: held by its prior only: " << unknown << "\n";
  WarnOfDistrust(diagnostics, std::cerr);
  return diagnostics.converged && !diagnostics.singular ? kGood : kNotToBeTrusted;
}

// The motion goes from the recordings' files to the estimate's without ever being held.
int ReconstructInStretches(const CommandLine& line, const ReconstructFlags& flags,
                           const SmootherOptions& options) {
  const Stopwatch reading;
  StreamedTrial folder = OpenTrial(flags.trial);
  const RunInfo run = RunInfoOf(folder, options, line.RunFlags({"output", "overwrite"}),
                                line.text(), reading.Seconds());
  StreamedObservations trial{folder.trial.observations, std::move(folder.samples)};
  RequireAccepted(BatchSmoother(options), trial.told, flags.trial);
  EstimateFolder output(flags.output, flags.overwrite);
  const DiscardedOnTermination discarded(output.draft());
  Estimate estimate;
  {
    ProgressLine progress;
    estimate = SmoothInStretches(
        trial, options, [&](const Estimate& piece) { output.Append(piece); }, progress.callback());
  }
  {
    const WithoutInterruption writing;
    output.Commit(estimate, run);
  }
  std::cout << EstimateText(folder.trial.name, estimate) << FindingsText(folder) << "Estimate in "
            << flags.output << "\n";
  return Verdict(estimate.diagnostics);
}

}  // namespace

int RunReconstruct(CommandLine& line) {
  ReconstructFlags flags;
  MethodOptions method = OptionsOf("method", line.Peek("method", flags.method));
  line.Add("Flags", flags);
  std::visit([&](auto& options) { line.Add("Flags of the method", options); }, method);
  if (ShowHelp(line, kHelp, {MethodList()})) return kGood;
  line.Read();
  RequireGiven(flags.trial, "trial");
  RequireGiven(flags.output, "output");
  std::visit([](const auto& options) { RequireValid(options); }, method);
  CheckReplaceable(flags.output, EstimateFolderKind(), flags.overwrite);

  if (const auto* smoother = std::get_if<SmootherOptions>(&method);
      smoother != nullptr && !smoother->whole_trial)
    return ReconstructInStretches(line, flags, *smoother);
  const Stopwatch reading;
  const TrialFolder folder = ReadTrial(flags.trial, TrialParts::kRecordings);
  const RunInfo run = RunInfoOf(folder, method, line.RunFlags({"output", "overwrite"}), line.text(),
                                reading.Seconds());
  const auto estimator = MakeEstimator(method);
  RequireAccepted(*estimator, folder.trial.observations, flags.trial);
  const Estimate estimate = RunWatched(*estimator, folder.trial.observations);
  {
    const WithoutInterruption writing;
    WriteEstimate(flags.output, estimate, run, flags.overwrite);
  }
  std::cout << EstimateText(folder.trial.name, estimate) << FindingsText(folder) << "Estimate in "
            << flags.output << "\n";
  return Verdict(estimate.diagnostics);
}

}  // namespace brachium
